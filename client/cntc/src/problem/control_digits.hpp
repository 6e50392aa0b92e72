// The flags of a contact problem: which there are, and which of their values contactd has.
#pragma once

#include <map>

namespace contactd::cntc {

class ControlDigits {
   public:
    ControlDigits();
    int operator()(int code) const { return values_.at(code); }
    bool knows(int code) const { return values_.contains(code); }
    /// Throws Refused where contactd does not have the value, and changes nothing then. A code that means nothing here
    /// has no effect: output, threads, wheel on rail.
    void set(int code, int value);
    /// Throws Refused where nobody knows the code.
    static void require_known(int code);

   private:
    std::map<int, int> values_;
};

}  // namespace contactd::cntc
