// Defines the exception for refused calls, which the edge of the library turns into a code and a message.
#pragma once

#include <string>

#include "contactd/error.hpp"

namespace contactd::cntc {

/// A refused call. `what()` is a whole sentence.
class Refused : public Error {
   public:
    Refused(int code, const std::string& sentence) : Error(sentence), code_(code) {}
    int code() const noexcept { return code_; }

   private:
    int code_;
};

/// Returns the refusal that corresponds to the exception being handled.
Refused refused_of_exception();

}  // namespace contactd::cntc
