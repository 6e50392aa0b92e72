// contactd.h: both wheels of a wheelset that is free to roll.
#include <memory>

#include "edge.hpp"

using namespace contactd::c;

std::int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left) {
    return with(right, [&](Wheel& right_wheel) {
        const std::shared_ptr<Wheel> left_wheel = wheels().find(left);
        if (left_wheel.get() == &right_wheel)
            throw contactd::InvalidArgument("left", "is the right wheel, too; make another one");
        const Turn turn(left_wheel->user);
        Wheel::solve_wheelset(right_wheel, *left_wheel);
    });
}

std::int32_t contactd_wheel_get_roll(contactd_wheel* wheel, double* roll) {
    return with(wheel, [&](Wheel& asked) { *given(roll, "roll") = asked.roll(); });
}
