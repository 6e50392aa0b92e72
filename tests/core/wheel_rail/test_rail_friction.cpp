// Tests layers and friction with memory between a wheel and its rail.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "wheel_rail/mirror.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

WheelRailSetup coarse_setup(const WheelRailFriction& friction) {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.5;
    setup.friction = friction;
    return setup;
}

WheelRailState creeping() {
    WheelRailState state;
    state.position = {2, 0, 0.002, 0.005};
    state.velocity = {20000, 15, 3, 0.01, 0.02, -43.3};
    state.Fz = 60000;
    return state;
}

std::string refused(const WheelRailSetup& setup, const WheelRailState& state) {
    try {
        solve(setup, state);
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return {};
}

}  // namespace

TEST_CASE("A layer between wheel and rail lowers creep forces, the more when it flows") {
    const WheelRailState state = creeping();
    const auto force = [&](const std::optional<InterfacialLayer>& layer) {
        const WheelRailSolution solution = solve(coarse_setup({{{0, 0.3}}, false, {}, layer}), state);
        REQUIRE(solution.converged());
        return std::hypot(solution.forces.track.Fx, solution.patches[0].solution.forces.Fy);
    };
    const double clean = force({}), elastic = force(InterfacialLayer{2e-5}),
                 flowing = force(InterfacialLayer{2e-5, 50});
    CHECK(elastic < clean);
    CHECK(flowing < elastic);
    CHECK_THAT(force(InterfacialLayer{1e-13}), WithinRel(clean, 1e-5));
}

TEST_CASE("Flow and coefficients of a left wheel are those of a right one in a mirror") {
    KineticFriction kinetic{SlipLaw::exponential, 0.2, 100};
    kinetic.memory = FrictionMemory{0.01, 1};
    WheelRailSetup setup = coarse_setup({{{0, 0.35}}, false, kinetic, InterfacialLayer{1e-5, 80, 5000}});
    const WheelRailState state = creeping();
    const WheelRailSolution right = solve(setup, state);
    REQUIRE(right.converged());
    setup.side = Side::left;
    const WheelRailSolution left = mirrored(solve(setup, mirrored(state)));
    REQUIRE(left.patches.size() == right.patches.size());
    const ContactSolution &a = left.patches.at(0).solution, &b = right.patches.at(0).solution;
    CHECK(a.elements.flow > 0);
    CHECK(a.flow_x == b.flow_x);
    CHECK(a.flow_y == b.flow_y);
    CHECK(a.yield_stress == b.yield_stress);
    CHECK(a.friction_coefficient == b.friction_coefficient);
    CHECK(a.plastic_power == b.plastic_power);
}

TEST_CASE("Transient rolling with memory and a layer that hardens ends as steady rolling") {
    KineticFriction kinetic{SlipLaw::exponential, 0.2, 100};
    kinetic.memory = FrictionMemory{0.01, 1};
    WheelRailSetup setup = coarse_setup({{{0, 0.35}}, false, kinetic, InterfacialLayer{1e-5, 80, 5000}});
    setup.dx = setup.dy = 1;
    const WheelRailContact contact(setup);
    WheelRailState state = creeping();
    state.Fz.reset();
    Observer observer;
    state.position.z = contact.solve(creeping(), observer).z;
    const WheelRailSolution steady = contact.solve(state, observer);
    state.motion = WheelRailMotion::transient_rolling;
    state.time_step = 1 / steady.patches.at(0).place.creepages.velocity;
    WheelRailEstimates left;
    WheelRailSolution last;
    for (int step = 0; step < 60; ++step) last = contact.solve(state, left, observer);
    REQUIRE(last.converged());
    const ContactSolution &rolling = last.patches.at(0).solution, &expected = steady.patches.at(0).solution;
    REQUIRE(expected.elements.flow > 0);
    const double scale = 0.35 * expected.forces.Fn;
    CHECK_THAT(rolling.forces.Fx, WithinAbs(expected.forces.Fx, 0.01 * scale));
    CHECK_THAT(rolling.forces.Fy, WithinAbs(expected.forces.Fy, 0.01 * scale));
    CHECK_THAT(rolling.largest_flow.value(), WithinRel(expected.largest_flow.value(), 0.1));
    const auto least = [](const ContactSolution& of) {
        return *std::min_element(of.friction_coefficient.begin(), of.friction_coefficient.end());
    };
    CHECK_THAT(least(rolling), WithinAbs(least(expected), 0.005));
}

TEST_CASE("A layer on a rail hardens by each shift to and fro") {
    const WheelRailContact contact(coarse_setup({{{0, 0.6}}, false, {}, InterfacialLayer{0, 80, 500}}));
    Observer observer;
    WheelRailEstimates left;
    double before = 80;
    for (const double y : {0.05, -0.05, 0.05}) {
        WheelRailState shift = creeping();
        shift.position.yaw = 0;
        shift.velocity = {};
        shift.velocity.y = y;
        shift.motion = WheelRailMotion::shift;
        shift.time_step = 1;
        const WheelRailSolution solution = contact.solve(shift, left, observer);
        REQUIRE(solution.converged());
        const std::vector<double>& stress = solution.patches.at(0).solution.yield_stress;
        const double largest = *std::max_element(stress.begin(), stress.end());
        CHECK(largest > before + 1);
        before = largest;
    }
}

TEST_CASE("Simplified models of wheels know no layer") {
    WheelRailSetup setup = coarse_setup({{{0, 0.35}}, false, {}, InterfacialLayer{1e-5}});
    setup.model = Model::fastsim;
    CHECK(refused(setup, creeping()) == "friction.layer");
}

TEST_CASE("Friction by temperature goes on straight lines between angles, and is constant beyond") {
    const std::vector<TemperatureFrictionAtAngle> laws{{-0.2, -0.1, 0, 300}, {0.2, -0.3, 100, 600}};
    CHECK(law_at(laws, -1) == TemperatureFriction{-0.1, 0, 300});
    CHECK(law_at(laws, 1) == TemperatureFriction{-0.3, 100, 600});
    const TemperatureFriction between = law_at(laws, 0.1);
    CHECK_THAT(between.change, WithinRel(-0.25, 1e-12));
    CHECK_THAT(between.reference, WithinRel(75, 1e-12));
    CHECK_THAT(between.range, WithinRel(525, 1e-12));
}

TEST_CASE("Friction by temperature at angles is that of the patch's angle, or of each row's") {
    const std::vector<TemperatureFrictionAtAngle> laws{{-0.5, -0.1, 0, 300}, {0.5, -0.2, 50, 400}};
    WheelRailState state = creeping();
    state.velocity.pitch = -44;
    const auto setup_of = [&](const WheelRailFriction& friction) {
        WheelRailSetup setup = coarse_setup(friction);
        setup.temperature = ThermalBodies{};
        return setup;
    };
    WheelRailFriction by_angle{{{0, 0.3}}}, plain = by_angle, alike = by_angle, rows = by_angle;
    by_angle.temperature_by_angle = laws;
    const WheelRailSolution solution = solve(setup_of(by_angle), state);
    plain.temperature = law_at(laws, solution.patches.at(0).place.reference.angle);
    const WheelRailSolution one = solve(setup_of(plain), state);
    CHECK_THAT(solution.forces.track.Fx, WithinRel(one.forces.track.Fx, 1e-9));
    // If all rows have one law, the result is the contact with that law.
    alike.along_profile = rows.along_profile = true;
    alike.temperature_by_angle = {
        {-1, plain.temperature->change, plain.temperature->reference, plain.temperature->range},
        {1, plain.temperature->change, plain.temperature->reference, plain.temperature->range}};
    CHECK_THAT(solve(setup_of(alike), state).forces.track.Fx, WithinRel(one.forces.track.Fx, 1e-9));
    rows.temperature_by_angle = laws;
    CHECK_THAT(solve(setup_of(rows), state).forces.track.Fx, WithinRel(one.forces.track.Fx, 0.05));
}

namespace {

/// Creates a wheel that slips by 1.6 % with temperature-dependent friction at `angles`.
WheelRailSetup warm_setup(const WheelRailFriction& friction) {
    WheelRailSetup setup = coarse_setup(friction);
    setup.temperature = ThermalBodies{};
    setup.settings.outer.tolerance = 1e-8;
    return setup;
}

WheelRailState slipping() {
    WheelRailState state = creeping();
    state.velocity.pitch = -44;
    return state;
}

WheelRailFriction by_rows(std::vector<TemperatureFrictionAtAngle> laws, std::optional<FrictionMemory> memory) {
    WheelRailFriction friction{{{-0.5, 0.3}, {0.5, 0.32}}, true};
    friction.temperature_by_angle = std::move(laws);
    friction.memory = memory;
    return friction;
}

const std::vector<TemperatureFrictionAtAngle> differing{{-0.2, -0.05, 20, 300}, {0.2, -0.25, 10, 200}};

}  // namespace

TEST_CASE("The same law with memory at all angles is that law, of the patch or row by row", "[temperature]") {
    const bool along = GENERATE(false, true);
    const FrictionMemory memory{0.02, 5};
    WheelRailFriction one{{{0, 0.3}}, along}, alike = one;
    one.temperature = TemperatureFriction{-0.2, 0, 200, memory};
    alike.temperature_by_angle = {{-1, -0.2, 0, 200}, {-0.1, -0.2, 0, 200}, {1, -0.2, 0, 200}};
    alike.memory = memory;
    const WheelRailSolution by_one = solve(warm_setup(one), slipping()), by_all = solve(warm_setup(alike), slipping());
    CHECK_THAT(by_all.forces.track.Fx, WithinRel(by_one.forces.track.Fx, 1e-9));
    const auto &expected = by_one.patches.at(0).solution.friction_coefficient,
               &found = by_all.patches.at(0).solution.friction_coefficient;
    REQUIRE(!expected.empty());
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK_THAT(found[i], WithinRel(expected[i], 1e-9));
    CHECK(*std::ranges::min_element(found) < 0.29);
    alike.memory.reset();
    CHECK(std::abs(solve(warm_setup(alike), slipping()).forces.track.Fx) < 0.999 * std::abs(by_one.forces.track.Fx));
}

TEST_CASE("Each row's coefficients follow the law of its angle with memory", "[temperature]") {
    const FrictionMemory memory{0.02, 5};
    WheelRailSetup setup = warm_setup(by_rows(differing, memory));
    setup.conformal = GENERATE(Conformal::off, Conformal::half_space);
    const WheelRailSolution solution = solve(setup, slipping());
    REQUIRE(solution.converged());
    for (const WheelRailPatch& patch : solution.patches) {
        const ContactSolution& found = patch.solution;
        const auto& rolling = std::get<Rolling>(*found.motion);
        const Grid& grid = patch.place.grid;
        const double seconds = grid.dx / rolling.velocity;
        const auto nx = static_cast<std::size_t>(grid.nx);
        REQUIRE(found.friction_coefficient.size() == grid.size());
        for (std::size_t row = 0; row < static_cast<std::size_t>(grid.ny); ++row) {
            const auto begin = found.friction_coefficient.begin() + static_cast<std::ptrdiff_t>(row * nx);
            const double entering = *(begin + static_cast<std::ptrdiff_t>(nx - 1));  // ahead of the contact
            double cold = 0, carried = entering;
            TemperatureFriction law;
            if (!patch.place.rows.empty()) {
                const double angle = patch.place.rows[row].angle;
                cold = coefficient_at(setup.friction->mu, angle);
                law = law_at(differing, angle);
                CHECK_THAT(entering, WithinRel(cold, 1e-12));
            }
            for (std::size_t k = 0; k < nx; ++k) {
                const std::size_t i = row * nx + nx - 1 - k;
                if (!(found.pressure[i] > 0)) continue;
                const double mu = found.friction_coefficient[i],
                             traction = std::hypot(found.traction_x[i], found.traction_y[i]);
                CHECK(traction <= mu * found.pressure[i] * (1 + 1e-5));
                if (patch.place.rows.empty()) continue;  // without stated angles
                const bool slips = found.element_division[i] == ElementState::slip;
                const double v = slips ? rolling.velocity * std::hypot(found.slip_x[i], found.slip_y[i]) : 0;
                const double theta = memory.distance / (memory.distance + seconds * std::max(v, memory.least_velocity));
                carried = theta * carried + (1 - theta) * friction_coefficient(law, cold, found.upper_temperature[i]);
                CHECK_THAT(mu, WithinRel(carried, 1e-5));
            }
        }
    }
}

TEST_CASE("Memory of friction by temperature and angle that is short is none, and that is long keeps coefficients",
          "[temperature]") {
    const auto force = [](const WheelRailFriction& friction) {
        const WheelRailSolution solution = solve(warm_setup(friction), slipping());
        REQUIRE(solution.converged());
        return std::abs(solution.forces.track.Fx);
    };
    const double at_once = force(by_rows(differing, {}));
    CHECK_THAT(force(by_rows(differing, FrictionMemory{1e-9, 1})), WithinRel(at_once, 1e-6));
    const double between = force(by_rows(differing, FrictionMemory{0.02, 1})),
                 lasting = force(by_rows(differing, FrictionMemory{1e9, 1}));
    WheelRailFriction cold = by_rows({}, {});
    CHECK_THAT(lasting, WithinRel(force(cold), 1e-6));
    CHECK(between > 1.001 * at_once);
    CHECK(between < 0.999 * lasting);
}

TEST_CASE("Steps in halves change memory of friction by temperature and angle less and less", "[temperature]") {
    const auto force = [](double dx) {
        WheelRailSetup setup = warm_setup(by_rows(differing, FrictionMemory{0.05, 1}));
        setup.dx = dx;
        const WheelRailSolution solution = solve(setup, slipping());
        REQUIRE(solution.converged());
        return solution.forces.track.Fx;
    };
    const double coarse = force(0.4), finer = force(0.2), finest = force(0.1);
    CHECK(std::abs(finest - finer) < 0.7 * std::abs(finer - coarse));
    CHECK_THAT(finest, WithinRel(finer, 5e-3));
}

TEST_CASE("A left wheel has the memory of friction by temperature and angle of a right one", "[temperature]") {
    WheelRailSetup setup = warm_setup(by_rows(differing, FrictionMemory{0.02, 1}));
    const WheelRailState state = slipping();
    const WheelRailSolution right = solve(setup, state);
    setup.side = Side::left;
    const WheelRailSolution left = mirrored(solve(setup, mirrored(state)));
    CHECK(left.patches.at(0).solution.friction_coefficient == right.patches.at(0).solution.friction_coefficient);
}

TEST_CASE(
    "Friction by temperature at angles is refused beside another one, in disorder, or without friction when hot") {
    const auto refused_field = [&](const WheelRailFriction& friction) {
        WheelRailSetup setup = coarse_setup(friction);
        setup.temperature = ThermalBodies{};
        return refused(setup, creeping());
    };
    WheelRailFriction both{{{0, 0.3}}}, disorder = both, none = both;
    both.temperature = TemperatureFriction{-0.1, 0, 300};
    both.temperature_by_angle = {{0, -0.1, 0, 300}};
    CHECK(refused_field(both) == "friction.temperature_by_angle");
    disorder.temperature_by_angle = {{0.1, -0.1, 0, 300}, {-0.1, -0.1, 0, 300}};
    CHECK(refused_field(disorder) == "friction.temperature_by_angle[1].angle");
    none.temperature_by_angle = {{0, -0.1, 0, 300}, {0.5, -0.3, 0, 300}};
    CHECK(refused_field(none) == "friction.temperature.change");
    WheelRailFriction memory{{{0, 0.3}}};
    memory.memory = FrictionMemory{0.01, 1};
    CHECK(refused_field(memory) == "friction.memory");
    memory.temperature_by_angle = {{0, -0.1, 0, 300}};
    CHECK(refused_field(memory).empty());
    memory.memory->distance = 0;
    CHECK(refused_field(memory) == "friction.memory.distance");
}
