// Compares gradients of wheel forces by profile ordinates with values of a dense prototype, and with differences of
// whole solves.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "contactd/contact_gradients.hpp"
#include "contactd/solve_contact.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "geometry/position.hpp"
#include "wheel_rail/force_gradient.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"
#include "wheel_rail/patches/patch_solver.hpp"

using namespace contactd;
using Catch::Matchers::WithinRel;
using geometry::GradientMode;
using geometry::WheelGradient;

namespace {

WheelRailSetup setup_of_points() {
    WheelRailSetup setup;
    setup.dx = 0.6;
    setup.dy = 0.5;
    const geometry::Profiles profiles = geometry::make_profiles(setup);
    ProfilePoints wheel, rail;
    wheel.points = profiles.wheel.points();
    rail.points = profiles.rail.points();
    setup.wheel.shape = wheel;
    setup.rail.shape = rail;
    setup.track.rail_origin = profiles.rail_origin;
    for (SolverSettings* settings : {&setup.settings.normal, &setup.settings.tangential, &setup.settings.outer})
        settings->tolerance *= 1e-3;
    setup.force.tolerance = 1e-10;
    return setup;
}

WheelRailState state_of_wheel() {
    WheelRailState state;
    state.position.y = 3;
    state.position.yaw = 0.0015;
    state.velocity.x = 20000;
    state.velocity.pitch = -20000.0 / 460;
    state.Fz = 80000;
    return state;
}

/// Solves the patches of a wheel at a given height, and sums the gradients of an output.
class Chain {
   public:
    Chain(const WheelRailSetup& setup, WheelRailState state, double z)
        : setup_(setup),
          state_((state.position.z = z, state)),
          profiles_(geometry::make_profiles(setup)),
          position_(setup_, profiles_, state_),
          cache_(setup.bodies) {}

    /// The output is a force in track coordinates, plus `by_pmax` times the largest pressure.
    WheelGradient gradient(const Wrench& by, double by_pmax = 0, GradientMode mode = GradientMode::exact) {
        const double z = *state_.position.z;
        const auto wheel = position_.wheel(z);
        geometry::PlaceGradient sum(setup_, state_, wheel, position_.rail(), mode);
        for (geometry::CandidatePatch& found : position_.candidates(z)) {
            if (!position_.measure(found, z)) continue;
            const ContactProblem problem = problem_of(setup_, state_, found, position_.rail());
            const ContactInfluence influence = cache_.of(problem, {}, observer_);
            const ContactSolution solution = solve_contact(problem, influence, observer_);
            const ContactReference& at = found.place.reference;
            const geometry::Vector3 force =
                geometry::contact_frame(at).axes *
                geometry::Vector3{solution.forces.Fx, solution.forces.Fy, solution.forces.Fn};
            const geometry::Vector3 moment = cross(geometry::Vector3{at.x, at.y, at.z}, force);
            const ByPatchForces by_patch =
                by_patch_forces(at, {force.x, force.y, force.z, moment.x, moment.y, moment.z}, by);
            Cotangents output;
            output.Fx = by_patch.contact.Fx;
            output.Fy = by_patch.contact.Fy;
            output.Fn = by_patch.contact.Fz;
            output.pmax = by_pmax;
            const Gradient found_gradient =
                contact_gradients(problem, influence, solution, {output}, {GradientInput::gap}, observer_)
                    .outputs.at(0);
            geometry::ByPlace by_place;
            by_place.distance = found_gradient.gap;
            by_place.creepages = {found_gradient.xi.value_or(0), found_gradient.eta.value_or(0),
                                  found_gradient.phi.value_or(0), 0, 0};
            by_place.reference = by_patch.reference;
            sum.add(found.place, by_place);
        }
        return sum.result();
    }

   private:
    WheelRailSetup setup_;
    WheelRailState state_;
    geometry::Profiles profiles_;
    geometry::Position position_;
    HalfSpaceCache cache_;
    Observer observer_;
};

/// A smooth change of a profile about y = `middle`, 4 mm wide, z += exp(-((y - middle)/4)^2).
double bump_at(double y, double middle) {
    return std::exp(-(y - middle) * (y - middle) / 16);
}

std::vector<ProfilePoint>& points_of(WheelRailSetup& setup, bool of_wheel) {
    return std::get<ProfilePoints>((of_wheel ? setup.wheel : setup.rail).shape).points;
}

double by_bump(WheelRailSetup setup, const WheelGradient& gradient, bool of_wheel, double middle) {
    const auto& points = points_of(setup, of_wheel);
    const auto& by = of_wheel ? gradient.wheel : gradient.rail;
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += by[i].z * bump_at(points[i].y, middle);
    return sum;
}

Wrench force(double Wrench::* component) {
    Wrench by;
    by.*component = 1;
    return by;
}

}  // namespace

TEST_CASE("Gradients of a wheel by profile ordinates have the values of a dense prototype") {
    const WheelRailSetup setup = setup_of_points();
    Observer observer;
    const double z = solve_wheel_rail(setup, state_of_wheel(), observer).z;
    Chain chain(setup, state_of_wheel(), z);
    const WheelGradient Fx = chain.gradient(force(&Wrench::Fx)), Fy = chain.gradient(force(&Wrench::Fy)),
                        Fz = chain.gradient(force(&Wrench::Fz)), pmax = chain.gradient({}, 1);
    const auto by_wheel = [&](const WheelGradient& of) { return by_bump(setup, of, true, -12.8); };
    const auto by_rail = [&](const WheelGradient& of) { return by_bump(setup, of, false, -23.3); };
    // Height held.
    CHECK_THAT(by_wheel(Fx), WithinRel(-124134.0, 1e-4));
    CHECK_THAT(by_wheel(Fy), WithinRel(-107126.0, 1e-4));
    CHECK_THAT(by_wheel(Fz), WithinRel(943758.0, 1e-4));
    CHECK_THAT(by_wheel(pmax), WithinRel(15320.1, 1e-4));
    // Vertical force held.
    CHECK_THAT(by_wheel(at_given_force(Fx, Fz)), WithinRel(8094.38, 1e-3));
    CHECK_THAT(by_wheel(at_given_force(pmax, Fz)), WithinRel(10121.4, 1e-4));
    CHECK_THAT(by_rail(at_given_force(Fx, Fz)), WithinRel(25861.1, 1e-4));
    CHECK_THAT(by_rail(at_given_force(Fy, Fz)), WithinRel(-18179.1, 1e-4));
}

TEST_CASE("Gradients of a wheel by profile ordinates agree with differences of whole solves") {
    const WheelRailSetup setup = setup_of_points();
    Observer observer;
    const double z = solve_wheel_rail(setup, state_of_wheel(), observer).z;
    WheelRailState at_height = state_of_wheel();
    at_height.Fz.reset();
    at_height.position.z = z;
    const auto forces = [&](bool of_wheel, double middle, double height) {
        WheelRailSetup changed = setup;
        for (ProfilePoint& point : points_of(changed, of_wheel)) point.z += height * bump_at(point.y, middle);
        return solve_wheel_rail(changed, at_height, observer).forces.track;
    };
    Chain chain(setup, state_of_wheel(), z);
    constexpr double change = 1e-5;
    for (const auto& [of_wheel, middle] : {std::pair(true, -12.8), std::pair(false, -23.3)}) {
        const Wrench more = forces(of_wheel, middle, change), less = forces(of_wheel, middle, -change);
        for (double Wrench::* component : {&Wrench::Fx, &Wrench::Fy, &Wrench::Fz}) {
            const double difference = (more.*component - less.*component) / (2 * change);
            CHECK_THAT(by_bump(setup, chain.gradient(force(component)), of_wheel, middle), WithinRel(difference, 1e-3));
        }
    }
}
