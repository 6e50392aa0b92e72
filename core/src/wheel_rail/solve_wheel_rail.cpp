#include "contactd/solve_wheel_rail.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contactd/below.hpp"
#include "geometry/position.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"
#include "wheel_rail/plausibility.hpp"
#include "wheel_rail/right_wheel.hpp"
#include "wheel_rail/units.hpp"

namespace contactd {
namespace {

InfluenceSource source_for(const WheelRailSetup& setup, InfluenceSource source) {
    if (source || setup.model != Model::full) return source;
    return [cache = std::make_shared<HalfSpaceCache>(setup.bodies)](const ContactProblem& problem,
                                                                    const PatchStrips& strips, Observer& observer) {
        return cache->of(problem, strips, observer);
    };
}

/// Adds warnings about set-up and state themselves.
template <class Answer>
Answer warned(Answer answer, const std::vector<std::string>& of_setup, const WheelRailSetup& setup,
              const WheelRailState& state) {
    answer.warnings.insert(answer.warnings.begin(), of_setup.begin(), of_setup.end());
    for (std::string& warning : unit_warnings(setup, state)) answer.warnings.push_back(std::move(warning));
    return answer;
}

}  // namespace

struct WheelRailContact::Parts {
    Parts(WheelRailSetup given, std::shared_ptr<const geometry::Profiles> curves, InfluenceSource source)
        : setup(std::move(given)),
          solved(with_tolerances(setup)),
          profiles(std::move(curves)),
          influences(std::move(source)),
          warnings(plausibility_warnings(setup, *profiles)) {
        for (std::string& warning : unit_warnings(setup)) warnings.push_back(std::move(warning));
        if (setup.conformal != Conformal::automatic) return;
        plane = curved = solved;
        plane->conformal = Conformal::off;
        curved->conformal = Conformal::rotated;
    }

    WheelRailSetup setup, solved;  // the given set-up, and the one with the tolerances of its accuracy
    std::shared_ptr<const geometry::Profiles> profiles;
    InfluenceSource influences;
    std::vector<std::string> warnings;                // added to every solution
    std::optional<WheelRailSetup> plane{}, curved{};  // possible replacements of setup if conformal is automatic

    /// Calls `ask` with a right wheel, which is mirrored for a left one.
    template <class Ask>
    auto of_right_wheel(const WheelRailState& state, const Observer& observer, const Ask& ask) const {
        below("state", [&] { validate(setup, state); });
        if (setup.side == Side::right) return ask(right_wheel(state, observer));
        const WheelRailState right = mirrored(state);
        return mirrored(ask(right_wheel(right, observer)));
    }

   private:
    RightWheel right_wheel(const WheelRailState& state, const Observer& observer) const {
        if (!plane) return {solved, *profiles, influences, state, observer};
        const bool bends = RightWheel(*plane, *profiles, influences, state, observer).bends();
        return {bends ? *curved : *plane, *profiles, influences, state, observer};
    }
};

WheelRailContact::WheelRailContact(WheelRailSetup setup, InfluenceSource source, const Observer& observer) {
    validate(setup);
    InfluenceSource influences = source_for(setup, std::move(source));
    auto profiles = std::make_shared<const geometry::Profiles>(geometry::make_profiles(setup, observer));
    parts_ = std::make_shared<const Parts>(std::move(setup), std::move(profiles), std::move(influences));
}

WheelRailContact::WheelRailContact(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

WheelRailContact WheelRailContact::with_friction(const WheelRailFriction& friction) const {
    WheelRailSetup setup = parts_->setup;
    setup.friction = friction;
    validate(setup);
    return WheelRailContact(std::make_shared<const Parts>(std::move(setup), parts_->profiles, parts_->influences));
}

WheelRailSolution WheelRailContact::solve(const WheelRailState& state, Observer& observer) const {
    WheelRailSolution solution =
        warned(parts_->of_right_wheel(state, observer, [&](RightWheel&& wheel) { return wheel.solve(observer); }),
               parts_->warnings, parts_->setup, state);
    for (std::string& warning : unit_warnings_of_one(parts_->setup, state))
        solution.warnings.push_back(std::move(warning));
    return solution;
}

WheelRailSolution WheelRailContact::solve(const WheelRailState& state, WheelRailEstimates& estimates,
                                          Observer& observer) const {
    WheelRailSolution solution = solve_within_step(state, estimates, observer);
    estimates.end_step();
    return solution;
}

WheelRailSolution WheelRailContact::solve_within_step(const WheelRailState& state, WheelRailEstimates& estimates,
                                                      Observer& observer) const {
    return warned(parts_->of_right_wheel(state, observer,
                                         [&](RightWheel&& wheel) {
                                             if (state.motion != WheelRailMotion::steady_rolling)
                                                 wheel.go_on_from(estimates.patches);
                                             wheel.start_from(estimates);
                                             return wheel.solve(observer);
                                         }),
                  parts_->warnings, parts_->setup, state);
}

WheelRailGeometry WheelRailContact::locate(const WheelRailState& state, const Observer& observer) const {
    return warned(parts_->of_right_wheel(state, observer, [](RightWheel&& wheel) { return wheel.locate(); }),
                  parts_->warnings, parts_->setup, state);
}

std::optional<double> WheelRailContact::first_contact_height(const WheelRailState& state,
                                                             const Observer& observer) const {
    return parts_->of_right_wheel(state, observer, [](RightWheel&& wheel) { return wheel.first_contact_height(); });
}

const WheelRailSetup& WheelRailContact::setup() const {
    return parts_->setup;
}

WheelRailSolution solve_wheel_rail(const WheelRailSetup& setup, const WheelRailState& state, Observer& observer) {
    return WheelRailContact(setup, nullptr, observer).solve(state, observer);
}

}  // namespace contactd
