// contactd.h: a rail on springs.
#include "edge.hpp"

using namespace contactd::c;

namespace {

/// 0: none, where the rail is rigid.
std::optional<double> spring(double stiffness, const char* field) {
    if (finite(stiffness, field) == 0) return std::nullopt;
    return stiffness;
}

}  // namespace

std::int32_t contactd_wheel_set_springs(contactd_wheel* wheel, double y, double z) {
    return with(wheel, [&](Wheel& changed) {
        const contactd::RailSprings springs{spring(y, "setup.track.springs.y"), spring(z, "setup.track.springs.z")};
        auto& said = changed.said.setup.track.springs;
        said.reset();
        if (springs.y || springs.z) said = springs;
    });
}

std::int32_t contactd_wheel_set_rail_forces(contactd_wheel* wheel, double Fy, double Fz) {
    return with(wheel, [&](Wheel& changed) {
        finite(Fy, "state.rail.Fy"), finite(Fz, "state.rail.Fz");
        changed.said.state.rail.Fy = Fy;
        changed.said.state.rail.Fz = Fz;
    });
}

std::int32_t contactd_wheel_get_rail_shift(contactd_wheel* wheel, double* y, double* z) {
    return with(wheel, [&](Wheel& asked) {
        const std::optional<contactd::RailShift>& shift = asked.solution().rail_shift;
        given(y, "y"), given(z, "z");
        if (!shift) throw nothing_of("shift of the rail: it has no springs");
        *y = shift->y;
        *z = shift->z;
    });
}
