// Compares gradients of the geometry of a contact with differences of its search and its measurement.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "contactd/error.hpp"
#include "geometry/adjoint/place_gradient.hpp"
#include "geometry/distance/heights.hpp"
#include "geometry/position.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using geometry::GradientMode;

namespace {

/// Holds all inputs of the geometry, so that they can be changed.
struct Inputs {
    WheelRailSetup setup;
    WheelRailState state;
    std::vector<ProfilePoint> wheel, rail;
    std::vector<std::size_t> wheel_kinks, rail_kinks;

    geometry::Profiles profiles() const {
        ProfileCurve of_wheel(wheel, wheel_kinks), of_rail(rail, rail_kinks);
        const ProfilePoint origin = geometry::rail_origin(of_rail, setup.track);
        return {std::move(of_wheel), std::move(of_rail), origin};
    }
};

/// Holds a linear function of the values of a patch.
struct Weights {
    std::vector<double> distance;
    double xi = 0, eta = 0, phi = 0, velocity = 0;
    ContactReference reference;
};

Inputs inputs_at(double y, double yaw, double depth) {
    Inputs inputs;
    WheelRailSetup& setup = inputs.setup;
    setup.dx = 0.6, setup.dy = 0.5;
    const geometry::Profiles profiles = geometry::make_profiles(setup);
    inputs.wheel = profiles.wheel.points(), inputs.rail = profiles.rail.points();
    inputs.wheel_kinks = profiles.wheel.kinks(), inputs.rail_kinks = profiles.rail.kinks();
    WheelRailState& state = inputs.state;
    state.position.y = y;
    state.position.yaw = yaw;
    state.position.roll = 0.3 * yaw;
    state.velocity = {20000, 30, 12, 0.02, 0.05, -20000 / 459.8};
    state.position.z = geometry::Position(setup, profiles, state).clearance(0) + depth;
    return inputs;
}

/// Holds a measured patch of these inputs.
struct Measured {
    Measured(const Inputs& inputs, std::size_t patch)
        : state(inputs.state),
          profiles(inputs.profiles()),
          position(inputs.setup, profiles, inputs.state),
          wheel(position.wheel(inputs.state.position.height())) {
        found = position.candidates(inputs.state.position.height()).at(patch);
        position.measure(found, inputs.state.position.height());
    }

    /// Returns the weighted sum, with elements where they lay before if they are held.
    double value(const Weights& weights, const ContactPlace* held) const {
        const ContactPlace& place = found.place;
        ContactReference plane = place.reference;
        double along = 0, ahead = 0;
        if (held != nullptr) {
            const double c = std::cos(plane.angle), s = std::sin(plane.angle);
            ahead = plane.x - held->reference.x;
            along = c * (plane.y - held->reference.y) + s * (plane.z - held->reference.z);
            plane = {plane.x - ahead, plane.y - c * along, plane.z - s * along, plane.angle};
        }
        const Grid& grid = held != nullptr ? held->grid : place.grid;
        const auto of_rail = rail_heights(position.rail(), plane, grid), of_wheel = wheel_heights(wheel, plane, grid);
        Creepages motion = place.creepages;
        if (held != nullptr) {
            double approach = -1;
            for (std::size_t i = 0; i < of_wheel.size(); ++i)
                approach = std::fmax(approach, of_wheel[i] - of_rail[i / static_cast<std::size_t>(grid.nx)]);
            motion = geometry::creepages(wheel, position.rail(), state, place.reference, approach);
            motion.xi += held->creepages.phi * along;
            motion.eta -= held->creepages.phi * ahead;
        }
        double sum = weights.xi * motion.xi + weights.eta * motion.eta + weights.phi * motion.phi +
                     weights.velocity * motion.velocity + weights.reference.x * plane.x +
                     weights.reference.y * plane.y + weights.reference.z * plane.z +
                     weights.reference.angle * plane.angle;
        for (std::size_t i = 0; i < of_wheel.size(); ++i)
            if (weights.distance[i] != 0)
                sum += weights.distance[i] * (of_rail[i / static_cast<std::size_t>(grid.nx)] - of_wheel[i]);
        return sum;
    }

    WheelRailState state;
    geometry::Profiles profiles;
    geometry::Position position;
    geometry::WheelSurface wheel;
    geometry::CandidatePatch found;
};

/// Returns weights of one kind; those of distances are in the overlap only.
Weights weights_of(const std::string& kind, const Measured& measured) {
    Weights weights;
    weights.distance.assign(measured.found.gap.size(), 0);
    if (kind == "distance")
        for (std::size_t i = 0; i < weights.distance.size(); ++i)
            if (measured.found.gap[i] < measured.found.place.approach)
                weights.distance[i] = 1 + std::sin(1.7 * static_cast<double>(i));
    if (kind == "xi") weights.xi = 1;
    if (kind == "eta") weights.eta = 1;
    if (kind == "phi") weights.phi = 1;
    if (kind == "velocity") weights.velocity = 1;
    if (kind == "x") weights.reference.x = 1;
    if (kind == "y") weights.reference.y = 1;
    if (kind == "z") weights.reference.z = 1;
    if (kind == "angle") weights.reference.angle = 1;
    return weights;
}

struct Direction {
    std::string name;
    double step;
    std::function<void(Inputs&, double)> move;
    std::function<double(const geometry::WheelGradient&)> along;
};

double bump_at(const ProfilePoint& point, double middle) {
    const double away = (point.y - middle) / 4;
    return std::exp(-away * away);
}

Direction bump(bool of_wheel, double middle) {
    return {std::string(of_wheel ? "wheel" : "rail") + " bump at " + std::to_string(middle), 1e-5,
            [=](Inputs& in, double step) {
                for (ProfilePoint& point : of_wheel ? in.wheel : in.rail) point.z += step * bump_at(point, middle);
            },
            [=](const geometry::WheelGradient&) { return 0.0; }};
}

double along_bump(const std::vector<ProfilePoint>& gradient, const std::vector<ProfilePoint>& points, double middle) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += gradient[i].z * bump_at(points[i], middle);
    return sum;
}

std::vector<Direction> directions(const Inputs& inputs, double on_wheel, double on_rail) {
    Direction wheel = bump(true, on_wheel), rail = bump(false, on_rail);
    wheel.along = [&inputs, on_wheel](const auto& by) { return along_bump(by.wheel, inputs.wheel, on_wheel); };
    rail.along = [&inputs, on_rail](const auto& by) { return along_bump(by.rail, inputs.rail, on_rail); };
    const auto of_state = [](const char* name, double step, const std::function<double&(WheelRailState&)>& of) {
        return Direction{name, step, [of](Inputs& in, double by) { of(in.state) += by; },
                         [of](const geometry::WheelGradient& by) {
                             WheelRailState state = by.state;
                             return of(state);
                         }};
    };
    using State = WheelRailState;
    return {wheel,
            rail,
            of_state("y", 1e-5, [](State& s) -> double& { return s.position.y; }),
            of_state("z", 1e-5, [](State& s) -> double& { return *s.position.z; }),
            of_state("roll", 1e-8, [](State& s) -> double& { return s.position.roll; }),
            of_state("yaw", 1e-6, [](State& s) -> double& { return s.position.yaw; }),
            of_state("rail.y", 1e-5, [](State& s) -> double& { return s.rail.y; }),
            of_state("rail.z", 1e-5, [](State& s) -> double& { return s.rail.z; }),
            of_state("rail.roll", 1e-7, [](State& s) -> double& { return s.rail.roll; }),
            of_state("wheel.x", 1e-4, [](State& s) -> double& { return s.wheel.x; }),
            of_state("wheel.y", 1e-5, [](State& s) -> double& { return s.wheel.y; }),
            of_state("wheel.z", 1e-5, [](State& s) -> double& { return s.wheel.z; }),
            of_state("wheel.roll", 1e-7, [](State& s) -> double& { return s.wheel.roll; }),
            of_state("wheel.yaw", 1e-6, [](State& s) -> double& { return s.wheel.yaw; }),
            of_state("velocity.x", 1, [](State& s) -> double& { return s.velocity.x; }),
            of_state("velocity.y", 1, [](State& s) -> double& { return s.velocity.y; }),
            of_state("velocity.z", 1, [](State& s) -> double& { return s.velocity.z; }),
            of_state("velocity.roll", 1e-3, [](State& s) -> double& { return s.velocity.roll; }),
            of_state("velocity.yaw", 1e-3, [](State& s) -> double& { return s.velocity.yaw; }),
            of_state("velocity.pitch", 1e-3, [](State& s) -> double& { return s.velocity.pitch; }),
            of_state("rail.y_velocity", 1, [](State& s) -> double& { return s.rail.y_velocity; }),
            of_state("rail.roll_velocity", 1e-3, [](State& s) -> double& { return s.rail.roll_velocity; }),
            of_state("wheel.y_velocity", 1, [](State& s) -> double& { return s.wheel.y_velocity; }),
            of_state("wheel.pitch_velocity", 1e-3, [](State& s) -> double& { return s.wheel.pitch_velocity; })};
}

void check_patch(const Inputs& inputs, std::size_t patch, GradientMode mode) {
    const Measured here(inputs, patch);
    const ContactPlace& place = here.found.place;
    const double on_rail = here.position.rail().frame().inside({0, place.reference.y, place.reference.z}).y + 1;
    const double on_wheel = place.reference.y - here.wheel.profile_origin().y - 1;
    const ContactPlace* held = mode == GradientMode::design ? &place : nullptr;
    for (const char* kind : {"distance", "xi", "eta", "phi", "velocity", "x", "y", "z", "angle"}) {
        const Weights weights = weights_of(kind, here);
        geometry::PlaceGradient gradient(inputs.setup, inputs.state, here.wheel, here.position.rail(), mode);
        gradient.add(
            place,
            {weights.distance, {weights.xi, weights.eta, weights.phi, 0, weights.velocity}, 0, weights.reference});
        const geometry::WheelGradient by = gradient.result();
        for (const Direction& direction : directions(inputs, on_wheel, on_rail)) {
            Inputs more = inputs, less = inputs;
            direction.move(more, direction.step);
            direction.move(less, -direction.step);
            const double change =
                Measured(more, patch).value(weights, held) - Measured(less, patch).value(weights, held);
            const double difference = change / (2 * direction.step), found = direction.along(by);
            const double rounding = 1e-11 * (1 + std::abs(here.value(weights, held))) / direction.step;
            INFO(kind << " by " << direction.name << " in the patch at " << place.reference.y);
            CHECK_THAT(found, WithinAbs(difference, 1e-6 * std::abs(difference) + rounding));
        }
    }
}

}  // namespace

TEST_CASE("Gradients of a place by profiles and state agree with differences") {
    const GradientMode mode = GENERATE(GradientMode::exact, GradientMode::design);
    const double y = GENERATE(0.0, 3.0, -2.0, 5.0);
    const double yaw = y == 3 ? 0.0015 : y == 5 ? -0.002 : 0;
    Inputs inputs = inputs_at(y, yaw, 0.08);
    if (y == 3) inputs.setup.track.rail_origin = ProfilePoint{753, 0.2};
    if (y == 3)
        inputs.state.position.z = geometry::Position(inputs.setup, inputs.profiles(), inputs.state).clearance(0) + 0.08;
    check_patch(inputs, 0, mode);
}

TEST_CASE("Gradients of each of several patches agree with differences") {
    Inputs inputs = inputs_at(2, 0, 0.1);
    for (ProfilePoint& point : inputs.wheel) point.z += 0.3 * (bump_at(point, -16) + bump_at(point, 6));
    inputs.state.position.z = geometry::Position(inputs.setup, inputs.profiles(), inputs.state).clearance(0) + 0.1;
    const std::size_t count =
        geometry::Position(inputs.setup, inputs.profiles(), inputs.state).candidates(*inputs.state.position.z).size();
    REQUIRE(count == 2);
    for (std::size_t patch = 0; patch < count; ++patch) check_patch(inputs, patch, GradientMode::exact);
}

TEST_CASE("A rail that moves with the wheel changes no gradient") {
    const Inputs inputs = inputs_at(2, 0.001, 0.07);
    const Measured here(inputs, 0);
    geometry::PlaceGradient gradient(inputs.setup, inputs.state, here.wheel, here.position.rail(), GradientMode::exact);
    geometry::ByPlace by{.distance = weights_of("distance", here).distance, .creepages = {3, -2, 5e2, 0, 1e-5}};
    gradient.add(here.found.place, by);
    const WheelRailState state = gradient.result().state;
    const double largest = std::abs(*state.position.z);
    CHECK_THAT(*state.position.z + state.rail.z, WithinAbs(0, 1e-9 * largest));
    CHECK_THAT(state.position.y + state.rail.y, WithinAbs(0, 1e-8 * largest));
}

TEST_CASE("Friction that depends on the angle adds to the gradient by the angle") {
    Inputs inputs = inputs_at(2, 0, 0.07);
    inputs.setup.friction->mu = {{-0.5, 0.1}, {0.5, 0.3}};
    const Measured here(inputs, 0);
    const auto by_yaw = [&](const geometry::ByPlace& by) {
        geometry::PlaceGradient sum(inputs.setup, inputs.state, here.wheel, here.position.rail(), GradientMode::exact);
        sum.add(here.found.place, by);
        return sum.result().state.rail.roll;
    };
    geometry::ByPlace by{.distance = std::vector<double>(here.found.gap.size(), 0)};
    by.mu = 1;
    const double of_friction = by_yaw(by);
    by.mu = 0;
    by.reference.angle = 0.2;
    CHECK(of_friction == by_yaw(by));
}

TEST_CASE("Gradients refuse what they do not cover by its name") {
    const Inputs inputs = inputs_at(0, 0, 0.05);
    const auto refused = [&](const auto& change) {
        WheelRailSetup setup = inputs.setup;
        WheelRailState state = inputs.state;
        change(setup, state);
        try {
            geometry::check_gradient(setup, state);
        } catch (const InvalidArgument& error) {
            return std::string(error.field());
        }
        return std::string();
    };
    using Setup = WheelRailSetup;
    using State = WheelRailState;
    CHECK(refused([](Setup&, State&) {}).empty());
    CHECK(refused([](Setup&, State& s) { s.motion = WheelRailMotion::shift; }) == "state.motion");
    CHECK(refused([](Setup& s, State&) { s.track.roller_radius = 500; }) == "setup.track.roller_radius");
    CHECK(refused([](Setup& s, State&) { s.rail_slices.resize(2); }) == "setup.rail_slices");
    CHECK(refused([](Setup& s, State&) { s.wheel_slices.resize(2); }) == "setup.wheel_slices");
    CHECK(refused([](Setup& s, State&) { s.track.springs = RailSprings{}; }) == "setup.track.springs");
    CHECK(refused([](Setup& s, State&) { s.conformal = Conformal::rotated; }) == "setup.conformal");
    CHECK(refused([](Setup& s, State&) { s.wheel_surface = WheelSurfaceKind::bilinear; }) == "setup.wheel_surface");
    CHECK(refused([](Setup& s, State&) { s.patches.search = ContactSearch::mesh; }) == "setup.patches.search");
    CHECK(refused([](Setup& s, State&) { s.rigid_slip = RigidSlipKind::surfaces; }) == "setup.rigid_slip");
    CHECK(refused([](Setup& s, State&) { s.model = Model::hertz; }) == "setup.model");
}

TEST_CASE("A plane that was rotated towards its neighbour has no gradient") {
    const Inputs inputs = inputs_at(-5.5, 0, 0.06);
    const Measured here(inputs, 0);
    ContactPlace place = here.found.place;
    place.reference.angle += 0.01;
    geometry::PlaceGradient gradient(inputs.setup, inputs.state, here.wheel, here.position.rail(), GradientMode::exact);
    geometry::ByPlace by{.distance = std::vector<double>(here.found.gap.size(), 0)};
    CHECK_THROWS_AS(gradient.add(place, by), InvalidArgument);
}
