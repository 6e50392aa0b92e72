// The result elements and contact problems of the process.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "handles/contact_case.hpp"
#include "handles/rail_case.hpp"

namespace contactd::cntc {

using CasePtr = std::shared_ptr<ProblemCase>;

/// A wheel on a rail, and its settings shared with basic contact.
struct RailPtrs {
    std::shared_ptr<RailCase> rail;
    CasePtr common;
};

/// Finds contact problems by their numbers. Thread-safe; a deleted problem that another thread uses lives until that
/// use ends.
class Registry {
   public:
    static Registry& of_process();

    /// Creates a result element, and replaces an earlier one with this number. The first use refuses an unknown module.
    void initialize(int ire, int module);
    void finalize(int ire);
    void finalize_all();

    /// Returns the problems for a setter, and creates them on first use. `all_problems` are the existing ones and the
    /// pattern for new ones. Throws Refused for invalid numbers.
    std::vector<CasePtr> to_set(int ire, int icp);
    /// Returns the requested problem. Throws Refused if it does not exist.
    CasePtr at(int ire, int icp);
    /// Returns one problem or all of them. Throws Refused if there is none.
    std::vector<CasePtr> existing(int ire, int icp);
    /// Returns the problem or, for `all_problems` and a number that does not exist, the pattern for new ones.
    CasePtr existing_or_pattern(int ire, int icp);

    bool is_wheel_rail(int ire);
    /// Returns a wheel on a rail, created on first use. Throws Refused for basic contact.
    RailPtrs rail(int ire);
    /// Returns the contact problems of the patches, numbered from 1, followed by all other existing ones. Missing ones
    /// are created with these settings.
    std::vector<CasePtr> patches(int ire, std::size_t count, const Settings& common);

   private:
    struct ResultElement {
        explicit ResultElement(int module);

        int module;
        CasePtr pattern;  ///< settings made for all problems
        std::map<int, CasePtr> problems;
        std::shared_ptr<RailCase> rail;  ///< only for a wheel on a rail
    };

    /// Finds the element, or creates it for the module. Throws Refused for an unknown module.
    ResultElement& element(int ire, int module = module_number::basic_contact);
    ResultElement& existing_element(int ire);
    CasePtr& problem(ResultElement& element, int icp);

    std::mutex mutex_;
    std::map<int, ResultElement> elements_;
};

}  // namespace contactd::cntc
