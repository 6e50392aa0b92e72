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
        throw Refused(error_code::handle, "There is no result element " + std::to_string(ire) + ".");
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
                                              " was initialized for another module than 1 and 3, which contactd does "
                                              "not have.");
    return element;
}

Registry::ResultElement& Registry::existing_element(int ire) {
    if (!elements_.contains(ire))
        throw Refused(error_code::handle, "There is no result element " + std::to_string(ire) + ".");
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
    return {problem(found, icp)};
}

std::vector<CasePtr> Registry::existing(int ire, int icp) {
    const std::scoped_lock lock(mutex_);
    const auto& problems = existing_element(ire).problems;
    std::vector<CasePtr> result;
    for (const auto& [number, problem] : problems)
        if (icp == all_problems || icp == number) result.push_back(problem);
    if (result.empty()) throw Refused(error_code::handle, "There is no " + name_of(ire, icp) + ".");
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
                                              " was initialized for basic contact, module 3; a wheel on a rail is "
                                              "module 1.");
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
        throw Refused(error_code::handle, "One contact problem must be named; -1 stands for all of them.");
    return existing(ire, icp).front();
}

}  // namespace contactd::cntc
