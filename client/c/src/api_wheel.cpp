// contactd.h: wheels on rails from their making to their end.
#include <memory>

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
