#include <algorithm>

#include "contactd/wheel_rail_setup.hpp"

namespace contactd {
namespace {

template <class Entry>
double value_at(const std::vector<Entry>& entries, double angle, double Entry::* value) {
    const auto behind =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.angle > angle; });
    if (behind == entries.begin()) return entries.front().*value;
    const Entry& before = *(behind - 1);
    if (behind == entries.end()) return before.*value;
    return before.*value + (angle - before.angle) / (behind->angle - before.angle) * (*behind.*value - before.*value);
}

}  // namespace

double coefficient_at(const std::vector<FrictionAtAngle>& mu, double angle) {
    return value_at(mu, angle, &FrictionAtAngle::mu);
}

TemperatureFriction law_at(const std::vector<TemperatureFrictionAtAngle>& laws, double angle) {
    using At = TemperatureFrictionAtAngle;
    return {value_at(laws, angle, &At::change), value_at(laws, angle, &At::reference),
            value_at(laws, angle, &At::range)};
}

TemperatureFriction temperature_friction_at(const WheelRailFriction& friction, double angle) {
    TemperatureFriction law = law_at(friction.temperature_by_angle, angle);
    law.memory = friction.memory;
    return law;
}

}  // namespace contactd
