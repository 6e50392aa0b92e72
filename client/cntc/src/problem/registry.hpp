// The result elements and contact problems of the process.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "problem/contact_case.hpp"

namespace contactd::cntc {

using CasePtr = std::shared_ptr<ContactCase>;

/// Finds contact problems by their numbers. Safe to be used from several threads; a problem that is forgotten while
/// somebody uses it lives until then.
class Registry {
   public:
    static Registry& of_process();

    /// Makes a result element; one of that number is forgotten. One that is not basic contact answers nothing.
    void initialize(int ire, bool basic_contact);
    void finalize(int ire);
    void finalize_all();

    /// Those that something is set of. They are made when they are first named; `all_problems` are those there are, and
    /// the one that further ones are copied from. Throws Refused for numbers that cannot be.
    std::vector<CasePtr> to_set(int ire, int icp);
    /// The one that is asked for; throws Refused where there is none.
    CasePtr at(int ire, int icp);
    /// It, or all of them; throws Refused where there is none.
    std::vector<CasePtr> existing(int ire, int icp);

   private:
    struct ResultElement {
        bool basic_contact = true;
        CasePtr pattern = std::make_shared<ContactCase>();  ///< what was set of all
        std::map<int, CasePtr> problems;
    };

    ResultElement& element(int ire);

    std::mutex mutex_;
    std::map<int, ResultElement> elements_;
};

}  // namespace contactd::cntc
