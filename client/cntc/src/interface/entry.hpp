// The frame of every function of the interface: it finds and locks handles, and catches all exceptions.
#pragma once

#include <exception>

#include "edge/arguments.hpp"
#include "edge/codes.hpp"
#include "edge/exported.hpp"
#include "edge/last_error.hpp"
#include "handles/registry.hpp"

namespace contactd::cntc {

/// Runs `work`. Returns 0, or the code of its exception, which is reported under the name of the function.
template <class Work>
int answer(const char* function, const Work& work) noexcept {
    begin_call();
    try {
        work();
        return 0;
    } catch (...) {
        return report(function);
    }
}

inline int number_of(const int* handle) {
    if (handle == nullptr)
        throw Refused(error_code::handle, "The pointer to the number of a result element or problem is null.");
    return *handle;
}

/// Sets one part of a contact problem by `change(settings)`, which throws and changes nothing for invalid values. The
/// part is then refused until it is set to valid ones.
template <class Given, class Change>
void set_part(Given& settings, const std::string& part, const Change& change) {
    try {
        change(settings);
        settings.refused.erase(part);
    } catch (...) {
        settings.refused.insert_or_assign(part, refused_of_exception());
        throw;
    }
}

/// Calls `change(settings)` for one contact problem or for all. A problem that refuses does not affect the others.
template <class Change>
void for_each_settings(const int* ire, const int* icp, const Change& change) {
    std::exception_ptr failed;
    for (const CasePtr& problem : Registry::of_process().to_set(number_of(ire), number_of(icp))) {
        const std::scoped_lock lock(problem->mutex);
        try {
            change(problem->settings);
        } catch (...) {
            failed = std::current_exception();
        }
    }
    if (failed) std::rethrow_exception(failed);
}

/// Sets one part of a problem.
template <class Change>
void set(const char* function, const int* ire, const int* icp, const char* part, const Change& change) noexcept {
    answer(function,
           [&] { for_each_settings(ire, icp, [&](Settings& settings) { set_part(settings, part, change); }); });
}

/// Sets one part of basic contact; on rails this part follows from other inputs.
template <class Change>
void set_basic(const char* function, const int* ire, const int* icp, const char* part, const Change& change) noexcept {
    answer(function, [&] {
        const int element = number_of(ire);
        if (Registry::of_process().is_wheel_rail(element))
            throw Refused(error_code::handle, "Result element " + std::to_string(element) +
                                                  " is a wheel on a rail. There, this input follows from profiles, "
                                                  "position and motion. Remove the call.");
        for_each_settings(ire, icp, [&](Settings& settings) { set_part(settings, part, change); });
    });
}

/// Reads results of one contact problem by `read(problem)`.
template <class Read>
int get(const char* function, const int* ire, const int* icp, const Read& read) noexcept {
    return answer(function, [&] {
        const CasePtr problem = Registry::of_process().at(number_of(ire), number_of(icp));
        const std::scoped_lock lock(problem->mutex);
        read(*problem);
    });
}

/// Reads results by `read(problem)`. On rails, -1 stands for the whole wheel.
template <class Read>
int get_whole(const char* function, const int* ire, const int* icp, const Read& read) noexcept {
    return answer(function, [&] {
        auto& registry = Registry::of_process();
        const int element = number_of(ire), number = number_of(icp);
        const CasePtr problem = registry.is_wheel_rail(element) ? registry.existing_or_pattern(element, number)
                                                                : registry.at(element, number);
        const std::scoped_lock lock(problem->mutex);
        read(*problem);
    });
}

/// Reads settings of one contact problem or of all. Without any call the initial values are returned.
template <class Read>
int get_set(const char* function, const int* ire, const int* icp, const Read& read) noexcept {
    return answer(function, [&] {
        const CasePtr problem = Registry::of_process().existing_or_pattern(number_of(ire), number_of(icp));
        const std::scoped_lock lock(problem->mutex);
        read(*problem);
    });
}

/// Returns whether a function of both modules is called for a wheel on a rail.
inline bool of_rail(const int* ire) {
    return ire != nullptr && Registry::of_process().is_wheel_rail(*ire);
}

/// Runs `work(rail, common)` for a wheel on a rail, with both locked.
template <class Work>
int with_rail(const char* function, const int* ire, const Work& work) noexcept {
    return answer(function, [&] {
        const auto [rail, common] = Registry::of_process().rail(number_of(ire));
        const std::scoped_lock lock(rail->mutex, common->mutex);
        work(*rail, common->settings);
    });
}

/// Sets one part of a wheel on a rail by `change(settings, units)`.
template <class Change>
void set_rail(const char* function, const int* ire, const std::string& part, const Change& change) noexcept {
    with_rail(function, ire, [&](RailCase& rail, const Settings& common) {
        set_part(rail.settings, part, [&](RailSettings& settings) { change(settings, common.units); });
    });
}

}  // namespace contactd::cntc
