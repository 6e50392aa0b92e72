#include "registry.hpp"

#include <string>

#include "edge/codes.hpp"

namespace contactd::cntc {
namespace {

std::string name_of(int ire, int icp) {
    return "contact problem " + std::to_string(icp) + " of result element " + std::to_string(ire);
}

void require_number(int ire) {
    if (ire < 1)
        throw Refused(error_code::handle,
                      "Result elements are numbered from 1 on; there is no " + std::to_string(ire) + ".");
}

}  // namespace

// Never ended: a thread may still be at work when the process ends.
Registry& Registry::of_process() {
    static auto& registry = *new Registry;
    return registry;
}

void Registry::initialize(int ire, bool basic_contact) {
    require_number(ire);
    const std::scoped_lock lock(mutex_);
    elements_[ire] = ResultElement{};
    elements_[ire].basic_contact = basic_contact;
}

void Registry::finalize(int ire) {
    const std::scoped_lock lock(mutex_);
    if (elements_.erase(ire) == 0)
        throw Refused(error_code::handle, "There is no result element " + std::to_string(ire) + ".");
}

void Registry::finalize_all() {
    const std::scoped_lock lock(mutex_);
    elements_.clear();
}

Registry::ResultElement& Registry::element(int ire) {
    require_number(ire);
    ResultElement& element = elements_[ire];
    if (!element.basic_contact)
        throw Refused(error_code::handle, "Result element " + std::to_string(ire) +
                                              " was initialized for another module than 3, which contactd does not "
                                              "have.");
    return element;
}

std::vector<CasePtr> Registry::to_set(int ire, int icp) {
    const std::scoped_lock lock(mutex_);
    if (icp < 1 && icp != all_problems)
        throw Refused(error_code::handle,
                      "Contact problems are numbered from 1 on, and -1 means all of them; there "
                      "is no " +
                          name_of(ire, icp) + ".");
    ResultElement& found = element(ire);
    if (icp == all_problems) {
        std::vector<CasePtr> all{found.pattern};
        for (const auto& [number, problem] : found.problems) all.push_back(problem);
        return all;
    }
    CasePtr& problem = found.problems[icp];
    if (!problem) {
        problem = std::make_shared<ContactCase>();
        const std::scoped_lock pattern_lock(found.pattern->mutex);
        problem->settings = found.pattern->settings;
    }
    return {problem};
}

std::vector<CasePtr> Registry::existing(int ire, int icp) {
    const std::scoped_lock lock(mutex_);
    const auto found = elements_.find(ire);
    if (found == elements_.end())
        throw Refused(error_code::handle, "There is no result element " + std::to_string(ire) + ".");
    const auto& problems = element(ire).problems;
    std::vector<CasePtr> result;
    for (const auto& [number, problem] : problems)
        if (icp == all_problems || icp == number) result.push_back(problem);
    if (result.empty()) throw Refused(error_code::handle, "There is no " + name_of(ire, icp) + ".");
    return result;
}

CasePtr Registry::at(int ire, int icp) {
    if (icp == all_problems)
        throw Refused(error_code::handle, "One contact problem must be named; -1 stands for all of them.");
    return existing(ire, icp).front();
}

}  // namespace contactd::cntc
