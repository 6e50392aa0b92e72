// Provides a wheel on its rail, and all results of a solve.
#pragma once

#include <string>

#include "every_wheel_call.hpp"

/// Returns an arc through the origin that descends to both sides.
inline void set_arc(contactd_wheel* w, const std::string& profile, double radius) {
    set(w, profile + ".arc.radius", radius);
    set_array(w, profile + ".arc.ends", {-30, 30});
}
inline void set_cone(contactd_wheel* w, const std::string& profile, double slope, double half_width = 30) {
    set(w, profile + ".cone.slope", slope);
    set_array(w, profile + ".cone.ends", {-half_width, half_width});
}
/// Entry `k` of a list of slices.
inline std::string slice(const std::string& list, std::size_t k) {
    return "setup." + list + "[" + std::to_string(k) + "]";
}

/// Creates a right wheel that rolls under 10 kN, on elements of 1 mm, and requests all results.
inline void set_rolling(contactd_wheel* w, double y) {
    set(w, {{"setup.dx", 1}, {"setup.dy", 1}, {"state.position.y", y}, {"state.position.yaw", 2.4e-3 * y}});
    set_array(w, "state.velocity", {2000, 0, 0, 0, 0, -2000 / 460.0});
    set(w, "state.Fz", 1e4);
    for (const char* array : every_array) require_ok(contactd_want(w, array, 1), w);
    require_ok(contactd_want(w, "gap", 1), w);
}

/// Holds all results of the last solve.
inline Numbers found_of(contactd_wheel* w) {
    Numbers all;
    const auto take = [&](const std::string& path) {
        if (!has(w, path)) return;
        const Numbers more = get_array(w, path);
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const char* path :
         {"z", "pitch_rate", "roll", "clearance", "rail_deflection", "forces", "derivatives", "converged"})
        take(path);
    for (int k = 0; k < get(w, "warnings"); ++k)
        for (const char letter : get_word(w, "warnings[" + std::to_string(k) + "]")) all.push_back(letter);
    for (int k = 0; k < get(w, "patches"); ++k) {
        const std::string patch = "patches[" + std::to_string(k) + "].";
        for (const char* path : {"gap", "forces", "place.grid", "place.rows", "place.reference", "place.creepages",
                                 "place.radii", "solution.forces", "solution.area", "solution.elements",
                                 "solution.approach", "solution.pmax", "solution.frictional_power"})
            take(patch + path);
        for (const char* array : every_array) take(patch + "solution." + array);
    }
    return all;
}
inline Numbers solved(contactd_wheel* w) {
    require_ok(contactd_wheel_solve(w), w);
    return found_of(w);
}
