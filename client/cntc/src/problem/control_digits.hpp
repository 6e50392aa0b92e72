// The flags of a contact problem: which there are, and which of their values contactd has.
#pragma once

#include <map>

#include "edge/codes.hpp"

namespace contactd::cntc {

class ControlDigits {
   public:
    /// Flags of basic contact or of wheel on rail, which have some codes in common and not all of their values.
    explicit ControlDigits(int module = module_number::basic_contact);
    int operator()(int code) const { return values_.at(code); }
    bool knows(int code) const { return values_.contains(code); }
    /// Throws Refused where contactd does not have the value, and changes nothing then. A code that means nothing here
    /// has no effect: output, threads, and of basic contact the control of wheel on rail. 0 and 1 keep discretisation
    /// and coefficients as they are.
    void set(int code, int value);
    /// Throws Refused where nobody knows the code.
    static void require_known(int code);

   private:
    int module_;
    std::map<int, int> values_;
};

}  // namespace contactd::cntc
