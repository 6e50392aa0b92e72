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

/// A wheel on a rail, and what it has in common with basic contact.
struct RailPtrs {
    std::shared_ptr<RailCase> rail;
    CasePtr common;
};

/// Finds contact problems by their numbers. Safe to be used from several threads; a problem that is forgotten while
/// somebody uses it lives until then.
class Registry {
   public:
    static Registry& of_process();

    /// Makes a result element; one of that number is forgotten. One of a module that nobody has answers nothing.
    void initialize(int ire, int module);
    void finalize(int ire);
    void finalize_all();

    /// Those that something is set of. They are made when they are first named; `all_problems` are those there are, and
    /// the one that further ones are copied from. Throws Refused for numbers that cannot be.
    std::vector<CasePtr> to_set(int ire, int icp);
    /// The one that is asked for; throws Refused where there is none.
    CasePtr at(int ire, int icp);
    /// It, or all of them; throws Refused where there is none.
    std::vector<CasePtr> existing(int ire, int icp);
    /// The pattern of further problems: with `all_problems`, and where there is none of this number.
    CasePtr existing_or_pattern(int ire, int icp);

    bool is_wheel_rail(int ire);
    /// A wheel on a rail, which is made when it is first named. Throws Refused for basic contact.
    RailPtrs rail(int ire);
    /// The contact problems of its patches, numbered from 1 on, and behind them all others that there are. Those that
    /// are missing are made with these settings.
    std::vector<CasePtr> patches(int ire, std::size_t count, const Settings& common);

   private:
    struct ResultElement {
        explicit ResultElement(int module);

        int module;
        CasePtr pattern;  ///< what was set of all
        std::map<int, CasePtr> problems;
        std::shared_ptr<RailCase> rail;  ///< where it is a wheel on a rail
    };

    /// Finds it, or makes one of the module. Throws Refused where the module is none that there is.
    ResultElement& element(int ire, int module = module_number::basic_contact);
    ResultElement& existing_element(int ire);
    CasePtr& problem(ResultElement& element, int icp);

    std::mutex mutex_;
    std::map<int, ResultElement> elements_;
};

}  // namespace contactd::cntc
