#include "registry.hpp"

#include <string>

#include "edge/codes.hpp"

namespace contactd::cntc {
namespace {

Refused missing_problem(int ire, int icp) {
    const std::string element = std::to_string(ire);
    if (icp == all_problems) return {error_code::handle, "Result element " + element + " has no contact problems."};
    return {error_code::handle,
            "Contact problem " + std::to_string(icp) + " of result element " + element + " does not exist."};
}

void require_number(int ire) {
    if (ire < 1)
        throw Refused(error_code::handle, "ire is " + std::to_string(ire) + "; result elements are numbered from 1.");
}

}  // namespace

// The registry is never destroyed, because a thread may still run when the process ends.
Registry& Registry::of_process() {
    static auto& registry = *new Registry;
    return registry;
}

Registry::ResultElement::ResultElement(int module_)
    : module(module_ == module_number::wheel_rail_inputs ? module_number::wheel_rail : module_),
      pattern(std::make_shared<ProblemCase>()) {
    if (module != module_number::wheel_rail) return;
    pattern->settings.module = module;
    rail = std::make_shared<RailCase>();
}

void Registry::initialize(int ire, int module) {
    require_number(ire);
    const std::scoped_lock lock(mutex_);
    elements_.insert_or_assign(ire, ResultElement(module));
}

void Registry::finalize(int ire) {
    const std::scoped_lock lock(mutex_);
    if (elements_.erase(ire) == 0)
        throw Refused(error_code::handle, "Result element " + std::to_string(ire) + " does not exist.");
}

void Registry::finalize_all() {
    const std::scoped_lock lock(mutex_);
    elements_.clear();
}

Registry::ResultElement& Registry::element(int ire, int module) {
    require_number(ire);
    ResultElement& element = elements_.try_emplace(ire, module).first->second;
    if (element.module != module_number::basic_contact && element.module != module_number::wheel_rail)
        throw Refused(error_code::handle, "Result element " + std::to_string(ire) +
                                              " was initialized for a module that is not supported. "
                                              "Use module 1 or 3.");
    return element;
}

Registry::ResultElement& Registry::existing_element(int ire) {
    if (!elements_.contains(ire))
        throw Refused(error_code::handle, "Result element " + std::to_string(ire) + " does not exist.");
    return element(ire);
}

CasePtr& Registry::problem(ResultElement& element, int icp) {
    CasePtr& problem = element.problems[icp];
    if (problem) return problem;
    problem = std::make_shared<ProblemCase>();
    const std::scoped_lock pattern_lock(element.pattern->mutex);
    problem->settings = element.pattern->settings;
    return problem;
}

std::vector<CasePtr> Registry::to_set(int ire, int icp) {
    const std::scoped_lock lock(mutex_);
    if (icp < 1 && icp != all_problems)
        throw Refused(error_code::handle, "icp is " + std::to_string(icp) +
                                              "; contact problems are numbered from 1, and -1 means all of them.");
    ResultElement& found = element(ire);
    if (icp == all_problems) {
        std::vector<CasePtr> all{found.pattern};
        for (const auto& [number, problem] : found.problems) all.push_back(problem);
        return all;
    }
    return {problem(found, icp)};
}

std::vector<CasePtr> Registry::existing(int ire, int icp) {
    const std::scoped_lock lock(mutex_);
    const auto& problems = existing_element(ire).problems;
    std::vector<CasePtr> result;
    for (const auto& [number, problem] : problems)
        if (icp == all_problems || icp == number) result.push_back(problem);
    if (result.empty()) throw missing_problem(ire, icp);
    return result;
}

CasePtr Registry::existing_or_pattern(int ire, int icp) {
    const std::scoped_lock lock(mutex_);
    const ResultElement& found = existing_element(ire);
    const auto problem = found.problems.find(icp);
    return problem == found.problems.end() ? found.pattern : problem->second;
}

bool Registry::is_wheel_rail(int ire) {
    const std::scoped_lock lock(mutex_);
    const auto found = elements_.find(ire);
    return found != elements_.end() && found->second.rail != nullptr;
}

RailPtrs Registry::rail(int ire) {
    const std::scoped_lock lock(mutex_);
    const ResultElement& found = element(ire, module_number::wheel_rail);
    if (!found.rail)
        throw Refused(error_code::handle, "Result element " + std::to_string(ire) +
                                              " was initialized for basic contact (module 3), not for a wheel "
                                              "on a rail (module 1).");
    return {found.rail, found.pattern};
}

std::vector<CasePtr> Registry::patches(int ire, std::size_t count, const Settings& common) {
    const std::scoped_lock lock(mutex_);
    ResultElement& found = element(ire);
    std::vector<CasePtr> patches;
    for (std::size_t i = 0; i < count; ++i) {
        CasePtr& problem = found.problems[static_cast<int>(i) + 1];
        if (!problem) {
            problem = std::make_shared<ProblemCase>();
            problem->settings = common;
        }
        patches.push_back(problem);
    }
    for (const auto& [number, problem] : found.problems)
        if (number > static_cast<int>(count)) patches.push_back(problem);
    return patches;
}

CasePtr Registry::at(int ire, int icp) {
    if (icp == all_problems)
        throw Refused(error_code::handle,
                      "icp is -1, which means all contact problems. This function requires the number of one.");
    return existing(ire, icp).front();
}

}  // namespace contactd::cntc
