// contactd.h: wheels on rails from their making to their end.
#include <algorithm>
#include <atomic>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "api_boundary.hpp"

using namespace contactd::c;
using contactd::InvalidArgument;

std::int32_t contactd_wheel_new(contactd_connection* connection, contactd_wheel** wheel) {
    return with(connection, [&](Connection& made_with) {
        *given(wheel, "wheel") = nullptr;
        *wheel = wheels().add(std::make_shared<Wheel>(made_with));
    });
}

std::int32_t contactd_wheel_free(contactd_wheel* wheel) {
    return with(wheel, [&](Wheel&) { wheels().remove(wheel); });
}

std::int32_t contactd_wheel_solve(contactd_wheel* wheel) {
    return with(wheel, [](Wheel& solved) { solved.solve(); });
}

namespace {

/// Throws InvalidArgument or StatusError where these are not so many wheels, each of them once; `at_fault` is then the
/// one that it is about.
void check_wheels(contactd_wheel* const* handles, std::int32_t count, std::int32_t threads,
                  const contactd_wheel*& at_fault) {
    at_least_zero(count, "count");
    at_least_zero(threads, "threads");
    if (count > 0) given(handles, "wheels");
    std::set<const contactd_wheel*> seen;
    for (std::int32_t i = 0; i < count; ++i) {
        const std::string field = "wheels[" + std::to_string(i) + "]";
        at_fault = handles[i];
        if (!wheels().find_any(handles[i])) throw not_a_handle(field.c_str(), handles[i]);
        if (!seen.insert(handles[i]).second)
            throw InvalidArgument(field, "stands twice; a wheel takes one step at a time");
    }
    at_fault = nullptr;
}

}  // namespace

std::int32_t contactd_wheel_solve_many(contactd_wheel* const* handles, std::int32_t count, std::int32_t threads) {
    const contactd_wheel* at_fault = nullptr;
    try {
        check_wheels(handles, count, threads, at_fault);
        std::vector<std::int32_t> codes(static_cast<std::size_t>(count));
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t i = next++; i < codes.size(); i = next++) codes[i] = contactd_wheel_solve(handles[i]);
        };
        const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
        const std::size_t workers = threads == 0 ? processors : static_cast<std::size_t>(threads);
        {
            std::vector<std::jthread> others;
            try {
                for (std::size_t i = 1; i < std::min(workers, codes.size()); ++i) others.emplace_back(work);
            } catch (const std::system_error&) {  // there are no more threads, and those that are here do it all
            }
            work();
        }
        const auto failing = std::ranges::find_if(codes, [](std::int32_t code) { return code != CONTACTD_OK; });
        return failing == codes.end() ? CONTACTD_OK : *failing;
    } catch (...) {
        return failed<Wheel>(at_fault, nullptr);
    }
}

std::int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left) {
    return with(right, [&](Wheel& right_wheel) {
        const std::shared_ptr<Wheel> left_wheel = wheels().find(left);
        if (left_wheel.get() == &right_wheel)
            throw InvalidArgument("left", "is the right wheel, too; make another one");
        const HandleGuard turn(left_wheel->user);
        Wheel::solve_wheelset(right_wheel, *left_wheel);
    });
}

std::int32_t contactd_wheel_cancel(contactd_wheel* wheel) {
    return cancel(wheels(), wheel);
}
