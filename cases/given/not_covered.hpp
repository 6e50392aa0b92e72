// Defines the error for a case that contactd cannot compute.
#pragma once

#include <string>

#include "contactd/error.hpp"

namespace contactd::cases {

/// Names the part of a case that cannot be used.
enum class Subject { input, file, coefficients, profile, friction, discretisation, tolerance, other };

/// Thrown for a case that is not supported, incomplete or inconsistent. `what()` is a whole sentence.
class NotCovered : public Error {
   public:
    NotCovered(Subject subject, const std::string& sentence) : Error(sentence), subject_(subject) {}
    Subject subject() const noexcept { return subject_; }

   private:
    Subject subject_;
};

}  // namespace contactd::cases
