// Defines friction that depends on the surface temperature.
#pragma once

#include <optional>
#include <span>

#include "contactd/friction_with_memory.hpp"

namespace contactd {

/// The coefficient of friction changes linearly from that of the law (mu) at `reference` to mu + change at `reference`
/// + `range`, and is constant on both sides: mu + change min(1, max(0, (T - reference)/range)). T is the temperature of
/// the element itself, including its own heat.
struct TemperatureFriction {
    double change = 0;     ///< for a hot surface; negative if friction decreases
    double reference = 0;  ///< (degrees Celsius)
    double range = 0;      ///< > 0 (K)
    std::optional<FrictionMemory> memory{};

    bool operator==(const TemperatureFriction&) const = default;
};

/// Returns the coefficient at the temperature T (degrees Celsius); `mu` is that of the law.
double friction_coefficient(const TemperatureFriction& law, double mu, double T);

/// Throws InvalidArgument ("friction.temperature.change", ...) unless all values are finite, range and the distance of
/// memory are positive, and each coefficient of `mu` stays valid where the surface is hot.
void validate(const TemperatureFriction& law, std::span<const double> mu);

}  // namespace contactd
