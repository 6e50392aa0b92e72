// Sends requests like clients, and returns the errors of bad ones.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "contactd/proto/status.hpp"

namespace wire {

inline nlohmann::json ic_params() {
    return nlohmann::json::parse(R"({
        "material": {"G": 82000, "nu": 0.28},
        "grid": {"nx": 10, "ny": 12, "dx": 0.8, "dy": 0.4},
        "ics": {"source": "fem", "preset": "paper-test2", "L_over_h": 1280}})");
}

inline nlohmann::json solve_params() {
    return nlohmann::json::parse(R"({
        "grid": {"nx": 3, "ny": 2, "dx": 0.06, "dy": 0.06},
        "bodies": {"upper": {"G": 200, "nu": 0.42}},
        "ics": {"source": "analytic"},
        "gap": {"paraboloid": {"Rx": 50, "Ry": 50}},
        "approach": 0.02,
        "friction": {"mu": 0.4, "rigid_shift": [0.00817, 0]}})");
}

inline nlohmann::json subsurface_params() {
    return nlohmann::json::parse(R"({
        "grid": {"nx": 3, "ny": 2, "dx": 0.06, "dy": 0.06},
        "nu": 0.28,
        "pressure": [[0, 1, 2], [0, 3, 0]],
        "traction_x": [[0, -0.1, -0.2], [0, -0.3, 0]],
        "block": {"x": [0], "y": [0], "z": [0, -0.05]}})");
}

inline nlohmann::json temperature_params() {
    return nlohmann::json::parse(R"({
        "grid": {"nx": 3, "ny": 2, "dx": 0.6, "dy": 0.6},
        "temperature": {"upper": {"bulk_temperature": 40}, "lower": {"conductivity": 20, "density": 7000}},
        "velocity": 20000,
        "pressure": [[0, 1, 2], [0, 3, 0]],
        "traction_x": [[0, -0.1, -0.2], [0, -0.3, 0]],
        "traction_y": [[0, 0, 0], [0, 0, 0]],
        "slip_x": [[0, 0.01, 0.01], [0, 0.01, 0]],
        "slip_y": [[0, 0, 0], [0, 0, 0]]})");
}

/// Returns the status that `act` throws, or nothing.
inline std::optional<contactd::proto::Status> status_thrown_by(const std::function<void()>& act) {
    try {
        act();
    } catch (const contactd::proto::StatusError& error) {
        return error.status();
    }
    return std::nullopt;
}

}  // namespace wire
