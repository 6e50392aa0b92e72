// The frame of every function of the interface: it finds handles, locks them, and lets no exception out.
#pragma once

#include <exception>

#include "edge/arguments.hpp"
#include "edge/codes.hpp"
#include "edge/exported.hpp"
#include "edge/last_error.hpp"
#include "problem/registry.hpp"

namespace contactd::cntc {

/// Runs `work`. Answers 0, or the code of what it threw, which is reported in the name of the function.
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
    if (handle == nullptr) throw Refused(error_code::handle, "The number of a result element or problem is null.");
    return *handle;
}

/// Sets something of one contact problem or of all, by `change(settings)`, which throws and leaves them as they were
/// where it cannot be. Then `part` of the problem is refused, until it is set well.
template <class Change>
void set_part(Settings& settings, const std::string& part, const Change& change) {
    try {
        change(settings);
        settings.refused.erase(part);
    } catch (...) {
        settings.refused.insert_or_assign(part, refused_of_exception());
        throw;
    }
}

/// Calls `change(settings)` of one contact problem or of all; what one refuses does not keep the others from it.
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

/// A function that sets one part.
template <class Change>
void set(const char* function, const int* ire, const int* icp, const char* part, const Change& change) noexcept {
    answer(function,
           [&] { for_each_settings(ire, icp, [&](Settings& settings) { set_part(settings, part, change); }); });
}

/// Reads something of one contact problem, by `read(problem)`.
template <class Read>
int get(const char* function, const int* ire, const int* icp, const Read& read) noexcept {
    return answer(function, [&] {
        const CasePtr problem = Registry::of_process().at(number_of(ire), number_of(icp));
        const std::scoped_lock lock(problem->mutex);
        read(*problem);
    });
}

}  // namespace contactd::cntc
