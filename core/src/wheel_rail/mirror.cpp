#include "wheel_rail/mirror.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <variant>

#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/fields/wheel_rail_state.hpp"

// The fields of numbers and arrays define their signs (x-parity in proto/schema). This file mirrors lists, rows and
// ends.
namespace contactd {
namespace {

void flip_sign(double& value) {
    value = 0 - value;  // avoids a negative zero
}

void mirror(Extent& extent) {
    extent = {0 - extent.to, 0 - extent.from};
}

void mirror(OverlapRegion& region) {
    mirror(region.y);
    std::swap(region.z.from, region.z.to);
}

/// Reverses the order of rows.
template <class Value>
void mirror_rows(std::vector<Value>& values, const Grid& grid) {
    if (values.empty()) return;
    const auto nx = static_cast<std::ptrdiff_t>(grid.nx);
    for (std::ptrdiff_t low = 0, high = grid.ny - 1; low < high; ++low, --high)
        std::swap_ranges(values.begin() + low * nx, values.begin() + (low + 1) * nx, values.begin() + high * nx);
}

void mirror(Motion& motion) {
    if (auto* rolling = std::get_if<Rolling>(&motion)) {
        flip_sign(rolling->eta);
        flip_sign(rolling->phi);
        flip_sign(rolling->chi);
        if (rolling->chi == -std::numbers::pi) rolling->chi = std::numbers::pi;
    } else {
        auto& shift = std::get<Shift>(motion);
        flip_sign(shift.rigid_shift.y);
        flip_sign(shift.rotation);
    }
}

void mirror(WheelRailPatch& patch) {
    mirror(patch.place);
    mirror_rows(patch.gap, patch.place.grid);
    mirror(patch.solution, patch.place.grid);
}

}  // namespace

void mirror(Grid& grid) {
    grid.y0 = 0 - (grid.y0 + grid.ny * grid.dy);
}

void mirror(ContactPlace& place) {
    mirror(place.grid);
    std::reverse(place.rows.begin(), place.rows.end());
    for (OverlapRegion& region : place.regions) mirror(region);
    std::reverse(place.regions.begin(), place.regions.end());
    std::reverse(place.shares.begin(), place.shares.end());
}

void mirror(ContactRegions& regions) {
    for (RegionLimits& limits : regions.limits) mirror(limits.y);
}

void mirror(ContactSolution& solution, const Grid& grid) {
    mirror_rows(solution.element_division, grid);
    for (const Field& field : type_of<ContactSolution>().fields) {
        if (&field.type() != &custom_type<std::vector<double>>()) continue;
        auto& values = *static_cast<std::vector<double>*>(field.make(&solution));
        mirror_rows(values, grid);
        if (field.parity == MirrorParity::odd)
            for (double& value : values) flip_sign(value);
    }
    if (solution.motion) mirror(*solution.motion);
    if (solution.fatigue) {
        std::reverse(solution.fatigue->rows.begin(), solution.fatigue->rows.end());
        double& angle = solution.fatigue->force_angle;
        if (angle == -std::numbers::pi) angle = std::numbers::pi;
    }
    if (solution.wear) std::reverse(solution.wear->rows.begin(), solution.wear->rows.end());
}

WheelRailState mirrored(WheelRailState state) {
    mirror_fields(state);
    return state;
}

WheelRailGeometry mirrored(WheelRailGeometry geometry) {
    mirror_fields(geometry);
    for (ContactPlace& place : geometry.places) mirror(place);
    std::reverse(geometry.places.begin(), geometry.places.end());
    return geometry;
}

WheelRailSolution mirrored(WheelRailSolution solution) {
    mirror_fields(solution);
    for (WheelRailPatch& patch : solution.patches) mirror(patch);
    std::reverse(solution.patches.begin(), solution.patches.end());
    return solution;
}

}  // namespace contactd
