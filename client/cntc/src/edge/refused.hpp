// How the library says no inside: the edge makes a code and a sentence of it.
#pragma once

#include <string>

#include "contactd/error.hpp"

namespace contactd::cntc {

/// A call that cannot be carried out; `what()` is a whole sentence.
class Refused : public Error {
   public:
    Refused(int code, const std::string& sentence) : Error(sentence), code_(code) {}
    int code() const noexcept { return code_; }

   private:
    int code_;
};

/// The refusal that stands for the exception being handled.
Refused refused_of_exception();

}  // namespace contactd::cntc
