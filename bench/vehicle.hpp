// Defines a vehicle of eight wheels, S1002 on 60E1, through contactd.h, in process or with a daemon. It hunts by 3 mm,
// or runs through a curve with flange contact of the first wheelset. Loads oscillate by 5 %.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "contactd.h"

namespace contactd::bench {

using Values = std::vector<double>;
using Wrench = std::array<double, 6>;

inline constexpr int wheelsets = 4;
inline constexpr double speed = 20'000;      // mm/s
inline constexpr double radius = 460;        // mm
inline constexpr double static_Fz = 70'000;  // N

enum class Run { hunting, curving };

/// Holds input of one wheel in a step.
struct WheelStep {
    double y, yaw, roll, y_rate, Fz;
};

inline WheelStep step_of(Run run, int wheelset, bool left, int k) {
    const double way = 2 * std::numbers::pi * k / 300 + 0.7 * wheelset, sway = 0.05 * std::sin(7 * way + left);
    const double share = left == (run == Run::curving) ? 60.0 / 70 : 80.0 / 70;
    if (run == Run::hunting)
        return {3 * std::sin(way), 2e-3 * std::cos(way), -1.5e-4 * std::sin(way), 63 * std::cos(way),
                static_Fz * share * (1 + sway)};
    const double aside = wheelset % 2 == 0 ? 6 : -1;
    return {aside + 0.2 * std::sin(way), (wheelset % 2 == 0 ? 4e-3 : -1e-3) + 1e-4 * std::cos(way), 0,
            4 * std::cos(way), static_Fz * share * (1 + sway)};
}

inline void check(std::int32_t code, const void* handle) {
    if (code != CONTACTD_OK) throw std::runtime_error(contactd_last_error(handle));
}

class Vehicle {
   public:
    /// An accuracy of 0 keeps the default tolerances.
    explicit Vehicle(const char* model, double accuracy = 0, const char* where = "local") {
        check(contactd_open(where, &connection_), nullptr);
        check(contactd_set_log(connection_, nullptr, nullptr), connection_);
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            check(contactd_wheel_new(connection_, &wheels_[i]), connection_);
            contactd_wheel* wheel = wheels_[i];
            check(contactd_set_word(wheel, "setup.model", model), wheel);
            check(contactd_set_word(wheel, "setup.side", i % 2 == 0 ? "right" : "left"), wheel);
            for (const char* size : {"setup.dx", "setup.dy"}) check(contactd_set(wheel, size, 0.5), wheel);
            check(contactd_set(wheel, "setup.friction.mu", 0.3), wheel);
            if (accuracy > 0) check(contactd_set(wheel, "setup.accuracy", accuracy), wheel);
        }
    }
    Vehicle(const Vehicle&) = delete;
    ~Vehicle() {
        for (contactd_wheel* wheel : wheels_) contactd_wheel_free(wheel);
        contactd_close(connection_);
    }

    /// Prescribes the heights in `at`, or without it the forces.
    void step(Run run, int k, int threads, const Values* at = nullptr) {
        heights_.clear();
        forces_.clear();
        for (int i = 0; i < 2 * wheelsets; ++i) {
            contactd_wheel* wheel = wheels_[static_cast<std::size_t>(i)];
            const WheelStep now = step_of(run, i / 2, i % 2 == 1, k);
            for (const auto& [path, value] : {std::pair{"state.position.y", now.y},
                                              {"state.position.yaw", now.yaw},
                                              {"state.position.roll", now.roll},
                                              {"state.velocity.y", now.y_rate},
                                              {"state.velocity.x", speed},
                                              {"state.velocity.pitch", -speed / radius}})
                check(contactd_set(wheel, path, value), wheel);
            if (at)
                check(contactd_set(wheel, "state.position.z", (*at)[static_cast<std::size_t>(i)]), wheel);
            else
                check(contactd_set(wheel, "state.Fz", now.Fz), wheel);
        }
        check(contactd_wheel_solve_many(wheels_.data(), 2 * wheelsets, threads), nullptr);
        for (contactd_wheel* wheel : wheels_) {
            Wrench force{};
            check(contactd_get_array(wheel, "forces.track", force.data(), 6), wheel);
            forces_.push_back(force);
            double z;
            check(contactd_get(wheel, "z", &z), wheel);
            heights_.push_back(z);
        }
    }
    const Values& heights() const { return heights_; }
    /// Returns Fx, Fy, Fz, Mx, My, Mz of each wheel, in track coordinates.
    const std::vector<Wrench>& forces() const { return forces_; }

   private:
    contactd_connection* connection_ = nullptr;
    std::array<contactd_wheel*, 2 * wheelsets> wheels_{};
    std::vector<Wrench> forces_;
    Values heights_;
};

}  // namespace contactd::bench
