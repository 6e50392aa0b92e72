#include "contactd/solve_wheel_rail.hpp"

#include <optional>
#include <utility>

#include "geometry/position.hpp"
#include "wheel_rail/influence_keeper.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/right_wheel.hpp"

namespace contactd {
namespace {

InfluenceSource source_for(const WheelRailSetup& setup, InfluenceSource source) {
    if (source || setup.model != Model::full) return source;
    return [keeper = std::make_shared<InfluenceKeeper>(setup.bodies)](const ContactProblem& problem) {
        return keeper->of(problem);
    };
}

}  // namespace

struct WheelRailContact::Parts {
    WheelRailSetup setup;
    geometry::Profiles profiles;
    InfluenceSource influences;

    /// What a right wheel answers, in a mirror where it is a left one.
    template <class Ask>
    auto of_right_wheel(const WheelRailState& state, const Ask& ask) const {
        validate(state);
        if (setup.side == Side::right) return ask(RightWheel(setup, profiles, influences, state));
        const WheelRailState right = mirrored(state);
        return mirrored(ask(RightWheel(setup, profiles, influences, right)));
    }
};

WheelRailContact::WheelRailContact(WheelRailSetup setup, InfluenceSource source) {
    validate(setup);
    InfluenceSource influences = source_for(setup, std::move(source));
    geometry::Profiles profiles = geometry::make_profiles(setup);
    parts_ = std::make_shared<const Parts>(Parts{std::move(setup), std::move(profiles), std::move(influences)});
}

WheelRailSolution WheelRailContact::solve(const WheelRailState& state, Observer& observer) const {
    return parts_->of_right_wheel(state, [&](RightWheel&& wheel) { return wheel.solve(observer); });
}

WheelRailGeometry WheelRailContact::locate(const WheelRailState& state) const {
    return parts_->of_right_wheel(state, [](RightWheel&& wheel) { return wheel.locate(); });
}

std::optional<double> WheelRailContact::touch(const WheelRailState& state) const {
    return parts_->of_right_wheel(state, [](RightWheel&& wheel) { return wheel.touch(); });
}

const WheelRailSetup& WheelRailContact::setup() const {
    return parts_->setup;
}

WheelRailSolution solve_wheel_rail(const WheelRailSetup& setup, const WheelRailState& state, Observer& observer) {
    return WheelRailContact(setup).solve(state, observer);
}

}  // namespace contactd
