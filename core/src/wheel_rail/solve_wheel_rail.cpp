#include "contactd/solve_wheel_rail.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "contactd/error.hpp"
#include "geometry/position.hpp"
#include "types/number_text.hpp"
#include "wheel_rail/height_search.hpp"
#include "wheel_rail/influence_keeper.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/patch_solver.hpp"
#include "wheel_rail/resultants.hpp"
#include "wheel_rail/warnings.hpp"

namespace contactd {
namespace {

using geometry::PlaceWithGap;
using geometry::Position;

constexpr double deepest_penetration = 5;  // mm: deeper than anything elastic

InfluenceSource source_for(const WheelRailSetup& setup, InfluenceSource source) {
    if (source || setup.model != Model::full) return source;
    return [keeper = std::make_shared<InfluenceKeeper>(setup.bodies)](const ContactProblem& problem) {
        return keeper->of(problem);
    };
}

/// A right wheel in one position.
class RightWheel {
   public:
    RightWheel(const WheelRailSetup& setup, const geometry::Profiles& profiles, const InfluenceSource& influences,
               const WheelRailState& state)
        : setup_(setup), influences_(influences), state_(state), position_(setup, profiles, state) {}

    WheelRailSolution solve(Observer& observer) {
        WheelRailSolution solution;
        if (!std::isfinite(position_.clearance(0))) {
            solution.z = state_.position.z;
            solution.warnings.emplace_back("No part of the wheel is above the rail: there is no contact.");
            return solution;
        }
        if (state_.Fz) {
            solution = under_force(*state_.Fz, observer);
        } else {
            solution = at(state_.position.z, observer);
        }
        return solution;
    }

    WheelRailGeometry locate() {
        WheelRailGeometry geometry;
        const double z = state_.position.z;
        if (!std::isfinite(position_.clearance(0))) return geometry;
        geometry.clearance = position_.clearance(z);
        check_depth(z);
        for (const PlaceWithGap& found : position_.places(z)) {
            geometry.places.push_back(found.place);
            for (std::string& warning : warnings_of(found, setup_.side, false))
                geometry.warnings.push_back(std::move(warning));
        }
        return geometry;
    }

   private:
    void check_depth(double z) const {
        const double clearance = position_.clearance(z);
        if (clearance < -deepest_penetration)
            throw InvalidArgument("position.z", "is " + number_text(z) + "; there the wheel is " +
                                                    short_text(-clearance) + " mm inside the rail, and more than " +
                                                    number_text(deepest_penetration) +
                                                    " mm are no elastic contact: lift the wheelset, or prescribe Fz");
    }

    WheelRailSolution at(double z, Observer& observer) {
        WheelRailSolution solution;
        solution.z = z;
        solution.clearance = position_.clearance(z);
        check_depth(z);
        for (PlaceWithGap& found : position_.places(z)) {
            solution.patches.push_back(solve(found, z, observer));
            solution.forces = sum(solution.forces, solution.patches.back().forces);
            for (std::string& warning : warnings_of(found, setup_.side, setup_.friction.has_value()))
                solution.warnings.push_back(std::move(warning));
        }
        return solution;
    }

    WheelRailPatch solve(PlaceWithGap& found, double z, Observer& observer) const {
        const WheelRailFriction* friction = setup_.friction ? &*setup_.friction : nullptr;
        WheelRailPatch patch;
        patch.solution = solve_place(problem_of(setup_, found, position_.rail(), friction), found.place, setup_.patches,
                                     influences_, observer);
        patch.place = found.place;
        patch.gap = std::move(found.gap);
        patch.forces = resultants(patch.place.reference, patch.place.grid, patch.solution, setup_.model != Model::full,
                                  position_.rail().frame(), position_.wheel(z).frame());
        return patch;
    }

    WheelRailSolution under_force(double Fz, Observer& observer) {
        const auto begin = std::chrono::steady_clock::now();
        const double compliance = setup_.bodies.materials().normal_compliance();
        WheelRailSolution solution;
        HeightTask task;
        task.estimate = [&](double z) { return position_.expected_force(z, compliance); };
        task.force = [&](double z) {
            solution = at(z, observer);
            return solution.forces.track.Fz;
        };
        task.touch = position_.clearance(0);
        task.deepest = task.touch + deepest_penetration;
        task.target = Fz;
        task.settings = setup_.force;
        const HeightFound found = find_height(task);
        solution.force = found.evidence;
        const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
        solution.force->seconds = duration.count();
        return solution;
    }

    const WheelRailSetup& setup_;
    const InfluenceSource& influences_;
    const WheelRailState& state_;
    Position position_;
};

}  // namespace

struct WheelRailContact::Parts {
    WheelRailSetup setup;
    geometry::Profiles profiles;
    InfluenceSource influences;
};

WheelRailContact::WheelRailContact(WheelRailSetup setup, InfluenceSource source) {
    validate(setup);
    InfluenceSource influences = source_for(setup, std::move(source));
    geometry::Profiles profiles = geometry::make_profiles(setup);
    parts_ = std::make_shared<const Parts>(Parts{std::move(setup), std::move(profiles), std::move(influences)});
}

WheelRailSolution WheelRailContact::solve(const WheelRailState& state, Observer& observer) const {
    validate(state);
    const bool left = parts_->setup.side == Side::left;
    const WheelRailState right_state = left ? mirrored(state) : state;
    WheelRailSolution solution =
        RightWheel(parts_->setup, parts_->profiles, parts_->influences, right_state).solve(observer);
    return left ? mirrored(std::move(solution)) : solution;
}

WheelRailGeometry WheelRailContact::locate(const WheelRailState& state) const {
    validate(state);
    const bool left = parts_->setup.side == Side::left;
    const WheelRailState right_state = left ? mirrored(state) : state;
    WheelRailGeometry geometry = RightWheel(parts_->setup, parts_->profiles, parts_->influences, right_state).locate();
    return left ? mirrored(std::move(geometry)) : geometry;
}

const WheelRailSetup& WheelRailContact::setup() const {
    return parts_->setup;
}

WheelRailSolution solve_wheel_rail(const WheelRailSetup& setup, const WheelRailState& state, Observer& observer) {
    return WheelRailContact(setup).solve(state, observer);
}

}  // namespace contactd
