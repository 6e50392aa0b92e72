// The refusal of a case that no problem can be made of.
#pragma once

#include <string>

#include "contactd/error.hpp"

namespace contactd::cases {

/// The part of a case that a refusal is about.
enum class Subject { input, profile, friction, discretisation, tolerance, other };

/// A case that contactd does not cover, or that lacks something or contradicts itself. `what()` is a whole sentence.
class NotCovered : public Error {
   public:
    NotCovered(Subject subject, const std::string& sentence) : Error(sentence), subject_(subject) {}
    Subject subject() const noexcept { return subject_; }

   private:
    Subject subject_;
};

}  // namespace contactd::cases
