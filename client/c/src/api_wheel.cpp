// Implements contactd.h: creation, solves and end of wheels on rails.
#include <algorithm>
#include <exception>
#include <memory>
#include <set>
#include <span>
#include <string>
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

/// Throws InvalidArgument or StatusError unless these are `count` different wheels; `at_fault` is then the invalid
/// handle.
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
            throw InvalidArgument(field, "is listed twice; a wheel takes one step at a time");
    }
    at_fault = nullptr;
}

/// Returns the code of the first failure; each wheel stores its own failure.
std::int32_t solve_together(std::span<contactd_wheel* const> handles, std::int32_t threads) {
    struct Part {
        contactd_wheel* handle;
        std::shared_ptr<Wheel> wheel;
        std::unique_ptr<const HandleGuard> turn;
        std::int32_t code = CONTACTD_OK;
    };
    std::vector<Part> parts;
    std::vector<Wheel*> solved;
    for (contactd_wheel* handle : handles) {
        Part& part = parts.emplace_back(handle);
        try {
            part.wheel = wheels().find(handle);
            part.turn = std::make_unique<const HandleGuard>(part.wheel->user);
            solved.push_back(part.wheel.get());
        } catch (...) {
            part.code = failed(handle, part.wheel.get());
        }
    }
    const std::vector<std::exception_ptr> failures = Wheel::solve_many(solved, threads);
    auto failure = failures.begin();
    for (Part& part : parts) {
        if (!part.turn) continue;
        try {
            if (*failure) std::rethrow_exception(*failure);
        } catch (...) {
            part.code = failed_under_guard(part.handle, *part.wheel);
        }
        ++failure;
    }
    const auto failing = std::ranges::find_if(parts, [](const Part& part) { return part.code != CONTACTD_OK; });
    return failing == parts.end() ? CONTACTD_OK : failing->code;
}

}  // namespace

std::int32_t contactd_wheel_solve_many(contactd_wheel* const* handles, std::int32_t count, std::int32_t threads) {
    const contactd_wheel* at_fault = nullptr;
    try {
        check_wheels(handles, count, threads, at_fault);
        return solve_together({handles, static_cast<std::size_t>(count)}, threads);
    } catch (...) {
        return failed<Wheel>(at_fault, nullptr);
    }
}

std::int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left) {
    return with(right, [&](Wheel& right_wheel) {
        const std::shared_ptr<Wheel> left_wheel = wheels().find(left);
        if (left_wheel.get() == &right_wheel)
            throw InvalidArgument("left", "is also the right wheel; create another one");
        const HandleGuard turn(left_wheel->user);
        Wheel::solve_wheelset(right_wheel, *left_wheel);
    });
}

std::int32_t contactd_wheel_cancel(contactd_wheel* wheel) {
    return cancel(wheels(), wheel);
}
