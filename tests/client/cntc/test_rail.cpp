// A wheel on a rail by the functions of the library: what core solves, and what a reference program has published.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "client/cntc/rail_calls.hpp"
#include "contactd/solve_wheel_rail.hpp"

using namespace contactd;
using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using contactd::test::manchester_cases;
using contactd::test::ManchesterCase;

namespace {

WheelRailSetup core_setup(Side side) {
    WheelRailSetup setup = contactd::test::manchester_setup(side);
    setup.rail = spec_of(ProfileKind::rail, rail_60e1());
    setup.wheel = spec_of(ProfileKind::wheel, s1002());
    return setup;
}

const ManchesterCase& known_case(Side side, int number) {
    for (const ManchesterCase& known : manchester_cases)
        if (known.side == side && known.number == number) return known;
    throw std::out_of_range("no such case");
}

}  // namespace

TEST_CASE("a wheel on a rail is solved as core solves it, to the last bit") {
    const Side side = GENERATE(Side::left, Side::right);
    RailCase rail = manchester_wheel(1, side);
    const WheelRailContact contact(core_setup(side));
    for (const int number : {1, 5, 11, 19}) {
        CAPTURE(number);
        const ManchesterCase& known = known_case(side, number);
        WheelRailState state = contactd::test::manchester_state(known);
        state.displacements = true;
        Observer observer;
        const WheelRailSolution expected = contact.solve(state, observer);

        place(rail, known);
        REQUIRE(rail.whole.calculate() == 0);

        REQUIRE(rail.patches() == static_cast<int>(expected.patches.size()));
        CHECK(rail.wheelset_position()[2] == expected.z);
        const Wrench& track = expected.forces.track;
        const Values forces = rail.global_forces();
        CHECK(Values(forces.begin(), forces.begin() + 3) == Values{track.Fx, track.Fy, track.Fz});
        const WheelRailPatch& patch = expected.patches.front();
        Case found = rail.patch(1);
        const auto [fn, fx, fy, mz] = found.forces();
        CHECK(fn == patch.solution.forces.Fn);
        CHECK(fx == patch.solution.forces.Fx);
        CHECK(fy == patch.solution.forces.Fy);
        CHECK(mz == patch.solution.forces.Mz);
        CHECK(found.max_pressure() == patch.solution.pmax);
        CHECK(found.found_penetration() == patch.solution.approach);
        CHECK(found.areas().contact == patch.solution.area.contact);
        CHECK(found.found_creepages().vx == patch.place.creepages.xi);
        CHECK(found.found_creepages().vy == patch.place.creepages.eta);
        CHECK(found.found_creepages().phi == patch.place.creepages.phi);
        const auto [pn, px, py] = found.tractions();
        CHECK(pn == patch.solution.pressure);
        CHECK(px == patch.solution.traction_x);
        CHECK(py == patch.solution.traction_y);
        CHECK(found.field(1) == patch.gap);
        CHECK(found.field(15) == patch.solution.slip_x);
        Values parted = patch.solution.displacement_z;
        for (std::size_t i = 0; i < parted.size(); ++i)
            if (patch.solution.element_division[i] == ElementState::exterior) parted[i] = 0;
        CHECK(found.field(9) == parted);
        const Grid& grid = patch.place.grid;
        CHECK(found.potential_back() ==
              Values{double(grid.nx), double(grid.ny), grid.x(0), grid.y(0), grid.dx, grid.dy});
    }
}

TEST_CASE("a wheelset on its way across the track has the published forces and places of its wheels") {
    const ManchesterCase& known = GENERATE(from_range(std::begin(manchester_cases), std::end(manchester_cases)));
    INFO((known.side == Side::left ? "left" : "right") << " wheel, case " << known.number);
    RailCase rail = manchester_wheel(1, known.side);
    place(rail, known);
    REQUIRE(rail.whole.calculate() == 0);
    REQUIRE(rail.patches() == 1);

    const auto forces = rail.patch(1).forces();
    CHECK_THAT(forces.fn, WithinRel(known.Fn, 2e-3));
    CHECK_THAT(forces.fx, WithinAbs(known.Fx_c, 1e-3 * 0.3 * known.Fn + 1));
    CHECK_THAT(forces.fy, WithinAbs(known.Fs, 1e-3 * 0.3 * known.Fn + 1));
    const Values global = rail.global_forces();
    CHECK_THAT(global[2], WithinRel(10000, 1e-5));
    CHECK_THAT(global[1], WithinAbs(known.Fy, 15));
    const Values at = rail.location(1);
    CHECK_THAT(at[0], WithinAbs(known.x_cp, 0.02));
    CHECK_THAT(at[1], WithinAbs(known.y_cp, 0.02));
    CHECK_THAT(at[2], WithinAbs(known.z_cp, 0.02));
    CHECK_THAT(at[3], WithinAbs(known.delta, 1e-3));
    CHECK_THAT(rail.wheelset_position()[2], WithinAbs(known.z, 2e-3));
    CHECK_THAT(rail.patch(1).found_creepages().vy, WithinAbs(known.eta, 3e-5));
}

TEST_CASE("places and forces in the axes of rail, wheel and wheelset fit each other") {
    const Side side = GENERATE(Side::left, Side::right);
    const double outwards = side == Side::left ? -1 : 1;
    RailCase rail = manchester_wheel(1, side);
    place(rail, known_case(side, 5));
    rail.track(2, {0.1, 0.2, 0.01, 0, 0, 0});
    rail.flexibility(4, {0, 0.3, 0, 0.002, 0, 0, 0, 0, 0, 0, 0, 0});
    REQUIRE(rail.whole.calculate() == 0);
    const Values at = rail.location(1);
    const auto sine = [&](int i) { return std::sin(at[static_cast<std::size_t>(i)]); };
    const auto cosine = [&](int i) { return std::cos(at[static_cast<std::size_t>(i)]); };

    // From the rail's profile to the track.
    CHECK_THAT(at[25], WithinAbs(outwards * 760.532353 + 0.1, 1e-9));
    CHECK_THAT(at[26], WithinAbs(-0.000023 + 0.2, 1e-9));
    CHECK_THAT(at[27], WithinAbs(0.01, 1e-12));
    CHECK_THAT(at[25] + at[5] * cosine(27) - at[6] * sine(27), WithinAbs(at[1], 1e-9));
    CHECK_THAT(at[26] + at[5] * sine(27) + at[6] * cosine(27), WithinAbs(at[2], 1e-9));
    CHECK_THAT(at[8] + at[27], WithinAbs(at[3], 1e-12));
    // From the wheel's profile to the wheelset.
    CHECK_THAT(at[33], WithinAbs(0, 1e-9));
    CHECK_THAT(at[34], WithinAbs(outwards * (1360 / 2.0 + 70) + 0.3, 1e-9));
    CHECK_THAT(at[35], WithinAbs(460, 1e-9));
    CHECK_THAT(at[36], WithinAbs(0.002, 1e-12));
    CHECK_THAT(at[34] + at[10] * cosine(36) - at[11] * sine(36), WithinAbs(at[30], 1e-9));
    CHECK_THAT(at[35] + at[10] * sine(36) + at[11] * cosine(36), WithinAbs(at[31], 1e-9));
    // Forces turn with their axes, and keep their size.
    const Values f = rail.global_forces();
    CHECK_THAT(f[13] * cosine(27) - f[14] * sine(27), WithinAbs(f[1], 1e-6));
    CHECK_THAT(f[15], WithinAbs(f[3], 1e-6));
    CHECK_THAT(f[16] * cosine(27) - f[17] * sine(27), WithinAbs(f[4], 1e-6));
    CHECK_THAT(f[19] * cosine(36) - f[20] * sine(36), WithinAbs(f[7], 1e-6));
    for (const std::size_t first : {6U, 12U, 18U})
        CHECK_THAT(std::hypot(f[first], f[first + 1], f[first + 2]), WithinRel(std::hypot(f[0], f[1], f[2]), 1e-12));
    // The force acts in the contact: its moment about the rail's profile is that of an arm within the patch.
    const double from_z = (at[1] - at[25]) * f[2] - (at[2] - at[26]) * f[1];
    CHECK_THAT(f[3], WithinAbs(from_z, 0.02 * 10000 * 10));
    CHECK(rail.global_forces(1) == f);
}

TEST_CASE("units of the interface change numbers and signs of a wheel on a rail, and nothing else") {
    const Side side = GENERATE(Side::left, Side::right);
    const ManchesterCase& known = known_case(side, 7);
    RailCase rail = manchester_wheel(1, side);
    place(rail, known);
    REQUIRE(rail.whole.calculate() == 0);
    const int code = GENERATE(1935, 1936);
    const double sign = code == 1935 ? -1 : 1;
    RailCase metres(2, 11);
    metres.whole.flag(1933, code);
    metres.whole.flag(1967, side == Side::left ? 0 : 1);
    metres.whole.material(0.28, 0.28, 82e9, 82e9);
    metres.whole.coulomb(0.3);
    metres.whole.potential(-1, {0.2e-3, 0.2e-3, 1.5707963267948966, 8e-3, 4e-3, 12e-3});
    metres.profile(false, rail_60e1());
    metres.profile(true, s1002());
    metres.track(1, {0, (side == Side::left ? -1 : 1) * 0.760532353, -0.000023e-3, 0, 0});
    metres.wheelset(3, {1.360, -0.070, 0.460});
    place(metres, known, 1000);
    REQUIRE(metres.whole.calculate() == 0);

    const Values mm = rail.location(1), m = metres.location(1);
    CHECK_THAT(1000 * m[1], WithinRel(mm[1], 1e-9));
    CHECK_THAT(m[3], WithinRel(mm[3], 1e-7));
    const Values in_mm = rail.global_forces(), in_m = metres.global_forces();
    for (const std::size_t i : {0U, 1U, 2U}) CHECK_THAT(sign * in_m[i], WithinRel(in_mm[i], 1e-5));
    CHECK_THAT(sign * 1000 * in_m[3], WithinRel(in_mm[3], 1e-5));
    CHECK_THAT(sign * metres.patch(1).found_creepages().vy, WithinRel(rail.patch(1).found_creepages().vy, 1e-6));
    CHECK_THAT(metres.patch(1).forces().fn, WithinRel(rail.patch(1).forces().fn, 1e-6));
    CHECK_THAT(sign * metres.patch(1).forces().fy, WithinRel(rail.patch(1).forces().fy, 1e-5));
    CHECK_THAT(metres.patch(1).max_pressure(), WithinRel(1e6 * rail.patch(1).max_pressure(), 1e-4));
    CHECK_THAT(1000 * metres.wheelset_position()[2], WithinRel(rail.wheelset_position()[2], 1e-6));
    CHECK_THAT(metres.wheelset_velocity()[0], WithinRel(2, 1e-12));
}

TEST_CASE("steps go on from tractions, start anew and repeat the last one") {
    const auto roll = [](int ire) {
        RailCase rail = manchester_wheel(ire, Side::right);
        rail.whole.flag(1972, 2);
        rail.whole.potential(0, {0.5, 0.5, 0});
        place(rail, known_case(Side::right, 5));
        return rail;
    };
    RailCase rail = roll(1);
    REQUIRE(rail.whole.calculate() == 0);
    const double first = rail.patch(1).forces().fy;
    rail.whole.flag(1970, 0);
    REQUIRE(rail.whole.calculate() == 0);
    const double second = rail.patch(1).forces().fy;
    CHECK(std::abs(second) > 1.2 * std::abs(first));
    rail.whole.flag(1970, 3);
    REQUIRE(rail.whole.calculate() == 0);
    CHECK_THAT(rail.patch(1).forces().fy, WithinRel(second, 1e-6));
    rail.whole.flag(1970, 2);
    REQUIRE(rail.whole.calculate() == 0);
    CHECK_THAT(rail.patch(1).forces().fy, WithinRel(first, 1e-6));
}

TEST_CASE("elements and moments of a shift are counted from one place on the rail") {
    std::vector<double> corners;
    for (const double along : {0.0, 3.0, 6.26}) {
        RailCase rail = manchester_wheel(1, Side::right);
        rail.whole.flag(1972, 1);
        rail.whole.potential(0, {0.5, 0.5, 0});
        place(rail, known_case(Side::right, 5));
        rail.position(2, {along, 2, 0.2, -1e-4, 0.005, 0});
        rail.velocity(2, {0.02, 0.01, 0, 0, 0, 0});
        REQUIRE(rail.whole.calculate() == 0);
        corners.push_back(rail.patch(1).potential_back().at(2));
        const auto forces = rail.patch(1).forces();
        const Values px = rail.patch(1).field(3), py = rail.patch(1).field(4);
        const Values area = rail.patch(1).potential_back();
        const int mx = static_cast<int>(area[0]);
        double moment = 0;
        for (std::size_t i = 0; i < px.size(); ++i) {
            const double x = area[2] + static_cast<double>(static_cast<int>(i) % mx) * area[4];
            const double y = area[3] + static_cast<double>(static_cast<int>(i) / mx) * area[5];
            moment += (x * py[i] - y * px[i]) * area[4] * area[5];
        }
        CHECK_THAT(forces.mz, WithinRel(moment, 1e-6));
    }
    for (const double corner : corners)
        CHECK_THAT((corner - corners[0]) / 0.5, WithinAbs(std::round((corner - corners[0]) / 0.5), 1e-6));
}

TEST_CASE("a longitudinal force finds the pitch rate, and a massless flexible rail its place") {
    RailCase rail = manchester_wheel(1, Side::right);
    place(rail, known_case(Side::right, 1));
    rail.whole.flag(1974, 1);
    rail.whole.tangential_forces(500, 0);
    REQUIRE(rail.whole.calculate() == 0);
    CHECK_THAT(rail.global_forces()[6], WithinAbs(500, 0.1));
    CHECK(rail.wheelset_velocity()[5] != known_case(Side::right, 1).pitch_rate);

    rail.whole.flag(1974, 3);
    rail.track(33, {1000, 0, 2000, 0});
    REQUIRE(rail.whole.calculate() == 0);
    const Values at = rail.location(1), forces = rail.global_forces();
    CHECK_THAT(1000 * at[17], WithinAbs(forces[1], 0.1));
    CHECK_THAT(2000 * at[18], WithinAbs(forces[2], 0.1));
    CHECK_THAT(at[26], WithinAbs(-0.000023 + at[18], 1e-9));
}

TEST_CASE("a roller turns under the wheel, and friction follows the rail's angle or its length") {
    RailCase roller = manchester_wheel(1, Side::right);
    const ManchesterCase& known = known_case(Side::right, 1);
    place(roller, known);
    roller.whole.flag(1967, 5);
    roller.track(1, {0, 760.532353, -0.000023, 0, 500});
    roller.velocity(2, {4, 0, 0, 0, 0, -4 * 500 / 460.0});
    REQUIRE(roller.whole.calculate() == 0);
    CHECK(roller.patches() == 1);
    CHECK_THAT(roller.global_forces()[2], WithinRel(10000, 1e-5));
    CHECK(roller.wheelset_velocity()[0] == 0);

    RailCase rail = manchester_wheel(2, Side::right);
    place(rail, known_case(Side::right, 5));
    REQUIRE(rail.whole.calculate() == 0);
    const double full = rail.patch(1).forces().fy;
    rail.whole.friction(10, {2, -1, 0.15, 0.15, -0.5, 0.15, 0.15});
    REQUIRE(rail.whole.calculate() == 0);
    CHECK_THAT(rail.patch(1).forces().fy, WithinRel(0.5 * full, 0.02));
    CHECK_THAT(rail.patch(1).field(2).front(), WithinRel(0.15, 1e-12));
    rail.whole.friction(20, {2, -100, 0.2, 0.2, 100, 0.4, 0.4});
    REQUIRE(rail.whole.calculate() == 0);
    CHECK_THAT(rail.patch(1).field(2).front(), WithinRel(0.3, 1e-12));
    CHECK_THAT(rail.patch(1).forces().fy, WithinRel(full, 1e-6));
}

TEST_CASE("a roller that leans with its deviation is solved as core solves it") {
    RailCase roller = manchester_wheel(1, Side::right);
    const ManchesterCase& known = known_case(Side::right, 1);
    place(roller, known);
    roller.whole.flag(1967, 5);
    const double pitch = 4, roll = GENERATE(0.0, 2e-3);
    roller.track(3, {0, 760.532353, -0.000023, 0, 500, 0, 0.05, roll, 0, 0, 0});
    roller.velocity(2, {pitch, 0, 0, 0, 0, -pitch * 500 / 460.0});
    REQUIRE(roller.whole.calculate() == 0);

    WheelRailSetup setup = core_setup(Side::right);
    setup.track.roller_radius = 500;
    setup.track.roller_leans = roll != 0;
    setup.patches.history = PatchHistory::whole;
    WheelRailState state = contactd::test::manchester_state(known);
    state.position.x = 0;
    state.velocity = {};
    state.velocity.pitch = -pitch * 500 / 460.0;
    state.roller_pitch = pitch;
    if (roll != 0) {
        state.rail.z = 0.05;
        state.rail.roll = roll;
    } else {  // it goes along with its axle
        setup.track.rail_origin->z += 0.05;
    }
    Observer observer;
    const WheelRailSolution expected = WheelRailContact(setup).solve(state, observer);
    CHECK_THAT(roller.wheelset_position()[2], WithinAbs(expected.z, 1e-9));
    CHECK_THAT(roller.patch(1).forces().fy, WithinRel(expected.patches.front().solution.forces.Fy, 1e-7));
    CHECK_THAT(roller.patch(1).found_creepages().phi, WithinRel(expected.patches.front().place.creepages.phi, 1e-7));
}

TEST_CASE("stresses below each patch are those of its tractions") {
    RailCase rail = manchester_wheel(1, Side::left);
    place(rail, known_case(Side::left, 5));
    int block = 1, kind = 5, none = 0, three = 3, icp = -1, error = -1;
    Values z{1e-9, 0.5, 1};
    subs_addblock(rail.ire(), &icp, &block, &kind, &none, &none, &three, nullptr, nullptr, z.data());
    REQUIRE(rail.whole.calculate() == 0);
    subs_calculate(rail.ire(), &icp, &error);
    REQUIRE(error == 0);
    int nx = 0, ny = 0, nz = 0, first = 1;
    subs_getblocksize(rail.ire(), &first, &block, &nx, &ny, &nz);
    REQUIRE(nx * ny == rail.patch(1).elements());
    REQUIRE(nz == 3);
    int points = nx * ny * nz, columns = 1, vertical = 21;
    Values stress(static_cast<std::size_t>(points));
    subs_getresults(rail.ire(), &first, &block, &points, &columns, &vertical, stress.data());
    double least = 0;
    for (const double s : stress) least = std::min(least, s);
    CHECK_THAT(-least, WithinRel(rail.patch(1).max_pressure(), 0.02));
}

TEST_CASE("profiles come back as they were given, and in the track") {
    const Side side = GENERATE(Side::left, Side::right);
    RailCase rail = manchester_wheel(1, side);
    CHECK(rail.profile_values(-1, true, 1)[0] == 0);
    const int points = static_cast<int>(rail.profile_values(0, false, 1)[0]);
    REQUIRE(points == static_cast<int>(rail_60e1().size() / 2));
    const Values own = rail.profile_values(1, false, 2 * points), track = rail.profile_values(2, false, 2 * points);
    const double outwards = side == Side::left ? -1 : 1;
    for (int i = 0; i < points; ++i) {
        const auto k = static_cast<std::size_t>(i), n = static_cast<std::size_t>(points);
        CHECK_THAT(own[k], WithinAbs(rail_60e1()[2 * k], 1e-6));
        CHECK_THAT(track[k], WithinAbs(outwards * (760.532353 + own[k]), 1e-9));
        CHECK_THAT(track[n + k], WithinAbs(own[n + k] - 0.000023, 1e-9));
    }
    const int finer = static_cast<int>(rail.profile_values(0, false, 1, 1, 0.5)[0]);
    CHECK(finer > 100);
    const Values lengths = rail.profile_values(4, false, finer, 1, 0.5);
    CHECK_THAT(lengths[1] - lengths[0], WithinAbs(0.5, 1e-12));
}

TEST_CASE("what a wheel on a rail lacks is named, and what was refused refuses the solve") {
    RailCase rail(1);
    CHECK(rail.whole.calculate() == -32);
    CHECK(last_sentence().find("profile of the rail") != std::string::npos);
    CHECK(rail.patches() == 0);
    CHECK(std::isnan(rail.global_forces()[0]));
    CHECK(std::isnan(rail.location(1)[0]));
    rail.profile(false, rail_60e1());
    CHECK(rail.whole.calculate() == -32);
    rail.profile(true, s1002());
    CHECK(rail.whole.calculate() == -39);
    rail.whole.material(0.28, 0.28, 82000, 82000);
    CHECK(rail.whole.calculate() == -34);
    rail.whole.potential(0, {0.5, 0.5, 0});
    CHECK(rail.whole.calculate() == -33);
    rail.whole.coulomb(0.3);
    CHECK(rail.whole.calculate() == -39);
    CHECK(last_sentence().find("cntc_setverticalforce") != std::string::npos);
    rail.vertical_force(10000);
    rail.velocity(2, {2000, 0, 0, 0, 0, -4.348});
    REQUIRE(rail.whole.calculate() == 0);

    rail.position(2, {0, no_number, 0, 0, 0, 0});
    CHECK(rail.whole.calculate() == -39);
    CHECK(rail.patches() == 0);
    CHECK(std::isnan(rail.patch(1).forces().fn));
    rail.position(2, {0, 500, 0, 0, 0, 0});
    CHECK(rail.whole.calculate() == -25);
    rail.position(2, {0, 0, 0, 0, 0, 0});
    rail.track(7, {});
    CHECK(rail.whole.calculate() == -39);
    rail.track(1, {14, 0, 1435, 0, 0});
    rail.whole.flag(1977, 7);
    CHECK(rail.whole.calculate() == -39);
    rail.whole.flag(1977, 2);
    rail.profile(true, {0, 0});
    CHECK(rail.whole.calculate() == -32);
    rail.profile_file("no such folder/wheel.prw");
    CHECK(last_code() == -32);
    rail.profile(true, s1002());
    CHECK(rail.whole.calculate() == -32);  // of a file whose kind its ending told
    rail.profile_file("no such folder/wheel.prw", {1});
    rail.profile(true, s1002());
    CHECK(last_code() == 0);
}

TEST_CASE("basic contact and wheels on rails do not answer for each other") {
    Case basic = wheel(1);
    double fz = 10000;
    cntc_setverticalforce(basic.ire(), &fz);
    CHECK(last_code() == -31);
    int count = 0, error = 0;
    cntc_getnumcontactpatches(basic.ire(), &count);
    CHECK(last_code() == -31);
    cntc_calculate1(basic.ire(), &error);
    CHECK(error == -31);
    cntc_calculate3(basic.ire(), basic.icp(), &error);
    CHECK(error == 0);
    RailCase rail = manchester_wheel(2, Side::right);
    place(rail, known_case(Side::right, 1));
    int first = 1;
    double vx = 0;
    cntc_setcreepages(rail.ire(), &first, &vx, &vx, &vx);
    CHECK(last_code() == -31);
    cntc_calculate3(rail.ire(), &first, &error);
    CHECK(error == -31);
    cntc_calculate(rail.ire(), &first, &error);
    CHECK(error == -31);
    cntc_calculate1(rail.ire(), &error);
    CHECK(error == 0);
    CHECK(rail.patches() == 1);
    cntc_getmaxnumthreads(&count);
    CHECK(count == 1);
}
