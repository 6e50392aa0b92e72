// A wheel on its rail to start from, and all that a solve tells of it.
#pragma once

#include <string>
#include <vector>

#include "every_wheel_call.hpp"

using Numbers = std::vector<double>;

/// A right wheel that rolls under 10 kN, on elements of 1 mm, from which all that there is comes along.
inline void set_rolling(contactd_wheel* w, double y) {
    require_ok(contactd_wheel_set_elements(w, 1, 1, 0), w);
    require_ok(contactd_wheel_set_velocity(w, 2000, 0, 0, 0, 0, -2000 / 460.0), w);
    require_ok(contactd_wheel_set_position(w, y, 0, 0, 2.4e-3 * y), w);
    require_ok(contactd_wheel_set_Fz(w, 1e4), w);
    for (std::int32_t array = CONTACTD_DIVISION; array <= CONTACTD_GAP; ++array)
        require_ok(contactd_wheel_want(w, array, 1), w);
}

inline void read_patch(contactd_wheel* w, std::int32_t patch, Numbers& all) {
    double x[8] = {};
    std::int32_t n[4] = {};
    require_ok(contactd_wheel_get_grid(w, patch, n, n + 1, x, x + 1, x + 2, x + 3), w);
    all.insert(all.end(), {double(n[0]), double(n[1]), x[0], x[1], x[2], x[3]});
    const std::int32_t size = n[0] * n[1];
    Numbers values(static_cast<std::size_t>(size));
    std::vector<std::int32_t> division(values.size());
    for (std::int32_t array = CONTACTD_PRESSURE; array <= CONTACTD_GAP; ++array) {
        const std::int32_t code = contactd_wheel_get_array(w, patch, array, values.data(), size);
        if (array != CONTACTD_GAP || code != CONTACTD_NOT_FOUND) require_ok(code, w);
        all.insert(all.end(), values.begin(), values.end());
    }
    require_ok(contactd_wheel_get_division(w, patch, division.data(), size), w);
    all.insert(all.end(), division.begin(), division.end());
    const auto ny = static_cast<std::size_t>(n[1]);
    Numbers rows(3 * ny);
    const std::int32_t curved =
        contactd_wheel_get_rows(w, patch, rows.data(), rows.data() + ny, rows.data() + 2 * ny, n[1]);
    if (curved != CONTACTD_NOT_FOUND) require_ok(curved, w);
    all.insert(all.end(), rows.begin(), rows.end());
    require_ok(contactd_wheel_get_place(w, patch, x, x + 1, x + 2, x + 3), w);
    require_ok(contactd_wheel_get_pressure(w, patch, x + 4, x + 5), w);
    all.insert(all.end(), x, x + 6);
    require_ok(contactd_wheel_get_creepages(w, patch, x, x + 1, x + 2, x + 3), w);
    require_ok(contactd_wheel_get_radii(w, patch, x + 4, x + 5, x + 6, x + 7), w);
    all.insert(all.end(), x, x + 8);
    require_ok(contactd_wheel_get_contact_forces(w, patch, x, x + 1, x + 2, x + 3), w);
    require_ok(contactd_wheel_get_areas(w, patch, x + 4, x + 5, x + 6), w);
    require_ok(contactd_wheel_get_counts(w, patch, n, n + 1, n + 2, n + 3), w);
    all.insert(all.end(), x, x + 7);
    all.insert(all.end(), n, n + 4);
    if (contactd_wheel_get_frictional_power(w, patch, x) == CONTACTD_OK) all.push_back(x[0]);
    for (const std::int32_t coordinates : {CONTACTD_IN_TRACK, CONTACTD_IN_RAIL, CONTACTD_IN_WHEELSET}) {
        require_ok(contactd_wheel_get_patch_forces(w, patch, coordinates, x), w);
        all.insert(all.end(), x, x + 6);
    }
}

/// All that a solve tells.
inline Numbers solved(contactd_wheel* w) {
    require_ok(contactd_wheel_solve(w), w);
    Numbers all(2);
    double x[6] = {};
    std::int32_t n = 0, patches = 0;
    require_ok(contactd_wheel_get_motion(w, &all[0], &all[1]), w);
    if (contactd_wheel_get_clearance(w, x) == CONTACTD_OK) all.push_back(x[0]);
    if (contactd_wheel_get_rail_shift(w, x, x + 1) == CONTACTD_OK) all.insert(all.end(), x, x + 2);
    for (const std::int32_t coordinates : {CONTACTD_IN_TRACK, CONTACTD_IN_RAIL, CONTACTD_IN_WHEELSET}) {
        require_ok(contactd_wheel_get_forces(w, coordinates, x), w);
        all.insert(all.end(), x, x + 6);
    }
    for (std::int32_t by = CONTACTD_BY_POSITION_Y; by <= CONTACTD_BY_VELOCITY_PITCH; ++by)
        if (contactd_wheel_get_derivative(w, by, x) == CONTACTD_OK) all.insert(all.end(), x, x + 6);
    require_ok(contactd_wheel_get_converged(w, &n), w);
    all.push_back(n);
    require_ok(contactd_wheel_get_warnings(w, &n), w);
    for (std::int32_t k = 0; k < n; ++k) {
        char text[500] = {};
        require_ok(contactd_wheel_get_warning(w, k, text, 500), w);
        for (const char letter : std::string(text)) all.push_back(letter);
    }
    require_ok(contactd_wheel_get_patches(w, &patches), w);
    for (std::int32_t patch = 0; patch < patches; ++patch) read_patch(w, patch, all);
    return all;
}
