#include "geometry/motion/creepages.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/distance/heights.hpp"
#include "geometry/motion/surface_motion.hpp"

namespace contactd::geometry {
namespace {

constexpr double least_velocity = 1e-30;  // mm/s: as in contact problems
constexpr double shift_velocity = 1;      // mm/s: velocity to which those of a shift refer
constexpr double largest_creepage = 1e9;  // (1, rad/mm): with faster relative motion, the wheel does not roll

/// Holds the speeds along x of the wheel over the rail and of its rim about its axle, whose mean is the rolling
/// velocity.
struct RollingSpeeds {
    double over_ground, of_rim;

    double mean() const { return 0.5 * (std::abs(over_ground) + std::abs(of_rim)); }
    bool forwards() const { return std::abs(over_ground) >= std::abs(of_rim) ? over_ground >= 0 : of_rim <= 0; }
};

RollingSpeeds rolling_speeds(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                             const Vector3& on_wheel, const SurfaceMotion& rim, const SurfaceMotion& ground) {
    if (rail.axle()) return {-ground.velocity.x, rim.velocity.x};
    const Vector3 pitching = wheel.wheelset().axes * Vector3{0, state.velocity.pitch, 0};
    const double of_rim = cross(pitching, on_wheel - centre_of_rotation(wheel, state)).x;
    return {rim.velocity.x - ground.velocity.x - of_rim, of_rim};
}

}  // namespace

bool is_rolling(const Creepages& creepages) {
    const double largest = std::max({std::abs(creepages.xi), std::abs(creepages.eta), std::abs(creepages.phi)});
    return creepages.velocity >= least_velocity && largest <= largest_creepage &&
           std::isfinite(creepages.xi + creepages.eta + creepages.phi);
}

Creepages creepages(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                    const ContactReference& reference, double approach) {
    const Frame contact = contact_frame(reference);
    const Vector3 on_wheel = contact.origin + approach * contact.axes.z;
    const SurfaceMotion rim = of_wheel(wheel, state, on_wheel), ground = of_rail(rail, state, contact.origin);
    const RollingSpeeds speeds = rolling_speeds(wheel, rail, state, on_wheel, rim, ground);

    Creepages result;
    result.velocity = rail.axle() ? 0.5 * std::abs(ground.velocity.x + rim.velocity.x) : speeds.mean();
    result.chi = speeds.forwards() ? 0 : std::numbers::pi;
    if (state.motion == WheelRailMotion::shift) {
        result.velocity = shift_velocity;
        result.chi = 0;
    }
    if (!(result.velocity >= least_velocity)) return {};
    const Vector3 over = ground.velocity - rim.velocity;
    result.xi = dot(over, contact.axes.x) / result.velocity;
    result.eta = dot(over, contact.axes.y) / result.velocity;
    result.phi = dot(ground.angular_velocity - rim.angular_velocity, contact.axes.z) / result.velocity;
    return is_rolling(result) ? result : Creepages{};
}

double rail_speed(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                  const ContactReference& reference, double approach) {
    const Frame contact = contact_frame(reference);
    const Vector3 on_wheel = contact.origin + approach * contact.axes.z;
    const SurfaceMotion rim = of_wheel(wheel, state, on_wheel), ground = of_rail(rail, state, contact.origin);
    return std::abs(rolling_speeds(wheel, rail, state, on_wheel, rim, ground).over_ground);
}

namespace {

/// Returns the lean of the surface between both from the plane at row iy, from its neighbours.
double lean(const std::vector<double>& heights, std::size_t iy, double dy) {
    const std::size_t before = iy > 0 ? iy - 1 : iy, behind = std::min(iy + 1, heights.size() - 1);
    const double rise = heights[behind] - heights[before];
    return std::isfinite(rise) && behind > before ? std::atan(rise / (static_cast<double>(behind - before) * dy)) : 0;
}

}  // namespace

std::vector<RowSlip> row_slips(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                               const ContactReference& reference, const Creepages& creepages, const Grid& grid) {
    const Grid column{1, grid.ny, grid.dx, grid.dy, -0.5 * grid.dx, grid.y0};
    const std::vector<double> of_rail_surface = rail_heights(rail, reference, column);
    const std::vector<double> of_wheel_surface = wheel_heights(wheel, reference, column);
    std::vector<double> middle;
    for (std::size_t i = 0; i < of_rail_surface.size(); ++i)
        middle.push_back(0.5 * (of_rail_surface[i] + of_wheel_surface[i]));
    const Frame contact = contact_frame(reference);
    std::vector<RowSlip> slips(middle.size());
    for (std::size_t iy = 0; iy < slips.size(); ++iy) {
        if (!std::isfinite(middle[iy]) || !(creepages.velocity > 0)) continue;
        const double y = grid.y(static_cast<int>(iy)), angle = lean(middle, iy, grid.dy);
        const SurfaceMotion ground = of_rail(rail, state, contact.outside({0, y, of_rail_surface[iy]}));
        const SurfaceMotion rim = of_wheel(wheel, state, contact.outside({0, y, of_wheel_surface[iy]}));
        const Rotation row = contact_frame({0, 0, 0, reference.angle + angle}).axes;
        const Vector3 over = ground.velocity - rim.velocity;
        slips[iy] = {dot(over, row.x) / creepages.velocity, dot(over, row.y) / creepages.velocity,
                     dot(ground.angular_velocity - rim.angular_velocity, row.z) / creepages.velocity};
    }
    return slips;
}

}  // namespace contactd::geometry
