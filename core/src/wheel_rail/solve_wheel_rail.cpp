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
    return [keeper = std::make_shared<InfluenceKeeper>(setup.bodies)](const ContactProblem& problem,
                                                                      const PatchColumns& columns, Observer&) {
        return keeper->of(problem, columns);
    };
}

}  // namespace

struct WheelRailContact::Parts {
    WheelRailSetup setup;
    geometry::Profiles profiles;
    InfluenceSource influences;
    std::optional<WheelRailSetup> plane{}, curved{};  // what setup may become where conformal is automatic

    /// What a right wheel answers, in a mirror where it is a left one.
    template <class Ask>
    auto of_right_wheel(const WheelRailState& state, const Ask& ask) const {
        validate(state);
        if (setup.side == Side::right) return ask(right_wheel(state));
        const WheelRailState right = mirrored(state);
        return mirrored(ask(right_wheel(right)));
    }

   private:
    RightWheel right_wheel(const WheelRailState& state) const {
        if (!plane) return {setup, profiles, influences, state};
        const bool bends = RightWheel(*plane, profiles, influences, state).bends();
        return {bends ? *curved : *plane, profiles, influences, state};
    }
};

WheelRailContact::WheelRailContact(WheelRailSetup setup, InfluenceSource source) {
    validate(setup);
    InfluenceSource influences = source_for(setup, std::move(source));
    geometry::Profiles profiles = geometry::make_profiles(setup);
    auto parts = std::make_shared<Parts>(Parts{std::move(setup), std::move(profiles), std::move(influences)});
    if (parts->setup.conformal == Conformal::automatic) {
        parts->plane = parts->curved = parts->setup;
        parts->plane->conformal = Conformal::off;
        parts->curved->conformal = Conformal::rotated;
    }
    parts_ = std::move(parts);
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
