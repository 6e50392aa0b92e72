// contactd.h: wheels on rails from their making to their end, and where they are.
#include <algorithm>
#include <memory>

#include "edge.hpp"

using namespace contactd::c;
using contactd::SolutionField;
using contactd::WheelRailState;

namespace {

template <class Body>
std::int32_t state(contactd_wheel* wheel, const Body& body) {
    return with(wheel, [&](Wheel& changed) { body(changed.said.state); });
}

}  // namespace

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

std::int32_t contactd_wheel_cancel(contactd_wheel* wheel) {
    return cancel(wheels(), wheel);
}

std::int32_t contactd_wheel_set_position(contactd_wheel* wheel, double y, double z, double roll, double yaw) {
    return state(wheel, [&](WheelRailState& changed) {
        contactd::WheelsetPosition position = changed.position;  // x and pitch stay
        position.y = finite(y, "state.position.y");
        position.z = finite(z, "state.position.z");
        position.roll = finite(roll, "state.position.roll");
        position.yaw = finite(yaw, "state.position.yaw");
        changed.position = position;
    });
}

std::int32_t contactd_wheel_set_x(contactd_wheel* wheel, double x) {
    return state(wheel, [&](WheelRailState& changed) { changed.position.x = finite(x, "state.position.x"); });
}

std::int32_t contactd_wheel_set_pitch_angle(contactd_wheel* wheel, double pitch) {
    return state(wheel,
                 [&](WheelRailState& changed) { changed.position.pitch = finite(pitch, "state.position.pitch"); });
}

std::int32_t contactd_wheel_set_velocity(contactd_wheel* wheel, double x, double y, double z, double roll, double yaw,
                                         double pitch) {
    return state(wheel, [&](WheelRailState& changed) {
        changed.velocity = {finite(x, "state.velocity.x"),     finite(y, "state.velocity.y"),
                            finite(z, "state.velocity.z"),     finite(roll, "state.velocity.roll"),
                            finite(yaw, "state.velocity.yaw"), finite(pitch, "state.velocity.pitch")};
    });
}

std::int32_t contactd_wheel_set_deviation(contactd_wheel* wheel, double y, double z, double roll) {
    return state(wheel, [&](WheelRailState& changed) {
        contactd::RailDeviation rail = changed.rail;  // its velocity and what acts on it stay
        rail.y = finite(y, "state.rail.y");
        rail.z = finite(z, "state.rail.z");
        rail.roll = finite(roll, "state.rail.roll");
        changed.rail = rail;
    });
}

std::int32_t contactd_wheel_set_deviation_rate(contactd_wheel* wheel, double y, double z, double roll) {
    return state(wheel, [&](WheelRailState& changed) {
        contactd::RailDeviation rail = changed.rail;
        rail.y_velocity = finite(y, "state.rail.y_velocity");
        rail.z_velocity = finite(z, "state.rail.z_velocity");
        rail.roll_velocity = finite(roll, "state.rail.roll_velocity");
        changed.rail = rail;
    });
}

std::int32_t contactd_wheel_set_roller_pitch(contactd_wheel* wheel, double pitch) {
    return state(wheel, [&](WheelRailState& changed) { changed.roller_pitch = finite(pitch, "state.roller_pitch"); });
}

std::int32_t contactd_wheel_set_Fz(contactd_wheel* wheel, double Fz) {
    return state(wheel, [&](WheelRailState& changed) { changed.Fz = finite(Fz, "state.Fz"); });
}

std::int32_t contactd_wheel_set_Fx(contactd_wheel* wheel, double Fx) {
    return state(wheel, [&](WheelRailState& changed) { changed.Fx = finite(Fx, "state.Fx"); });
}

std::int32_t contactd_wheel_clear_forces(contactd_wheel* wheel) {
    return state(wheel, [](WheelRailState& changed) {
        changed.Fz.reset();
        changed.Fx.reset();
    });
}

std::int32_t contactd_wheel_want(contactd_wheel* wheel, std::int32_t array, std::int32_t wanted) {
    return with(wheel, [&](Wheel& changed) {
        if (word(array, CONTACTD_GAP, "array") == CONTACTD_GAP) {
            changed.said.gap = wanted != 0;
            return;
        }
        const auto field = static_cast<SolutionField>(array);
        auto& fields = changed.said.fields;
        std::erase(fields, field);
        if (wanted != 0) fields.push_back(field);
    });
}

std::int32_t contactd_wheel_want_derivatives(contactd_wheel* wheel, std::int32_t wanted) {
    return state(wheel, [&](WheelRailState& changed) { changed.derivatives = wanted != 0; });
}
