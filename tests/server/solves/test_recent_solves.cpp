#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <memory>
#include <string>

#include "contactd/error.hpp"
#include "contactd/proto/status.hpp"
#include "solves/recent_solves.hpp"

using namespace contactd;
using namespace contactd::server;

namespace {

constexpr std::size_t plenty = 1 << 20;
const MessageLimits limits;
const Grid grid = Grid::of_elements(3, 2, 0.5, 0.5);
const auto begun = RecentSolves::Clock::now();

std::shared_ptr<Call> call_of(const std::string& user, const std::string& id = "one") {
    proto::Request request;
    request.id = id;
    request.method = "contact.solve";
    return std::make_shared<Call>(Route{"client", false, user}, request, Call::Clock::now(), proto::Priority::normal,
                                  limits, [](const Answer&) {});
}

ContactSolution solution_with(double pmax, const Grid& of = grid) {
    ContactSolution solution;
    solution.pmax = pmax;
    solution.forces = {10, 2, 1, 0};
    solution.pressure.assign(of.size(), pmax);
    solution.element_division.assign(of.size(), ElementState::slip);
    solution.evidence.normal = {7, 1e-8, true, 0.1};
    solution.evidence.tangential = SolverEvidence{5, 1e-6, true, 0.1};
    return solution;
}

std::string reason_of(const RecentSolves& solves, const std::string& user, std::uint64_t number) {
    try {
        solves.pressures(user, number);
        return "";
    } catch (const proto::StatusError& error) {
        return error.status().reason;
    }
}

}  // namespace

TEST_CASE("A solve is reported with its figures and its pressures") {
    RecentSolves solves({10, plenty});
    solves.add(*call_of("alice", "x7"), begun, solution_with(3), grid);

    const auto found = solves.of("alice");
    REQUIRE(found.size() == 1);
    CHECK(found[0].number == 1);
    CHECK(found[0].id == "x7");
    CHECK(found[0].method == "contact.solve");
    CHECK(found[0].converged);
    CHECK(found[0].iterations == 12);
    CHECK(found[0].residual == 1e-6);
    CHECK(found[0].forces == std::array{2.0, 1.0, 10.0});
    CHECK(found[0].elements == 6);
    CHECK(found[0].grid == grid);
    const RecentPressures patches = solves.pressures("alice", 1);
    REQUIRE(patches->size() == 1);
    CHECK(patches->front().pressure == std::vector<float>(6, 3.0F));
    CHECK(patches->front().element_division == std::vector(6, ElementState::slip));
}

TEST_CASE("No solve is reported to another user") {
    RecentSolves solves({10, plenty});
    solves.add(*call_of("alice"), begun, solution_with(3), grid);
    solves.add(*call_of("bob"), begun, solution_with(4), grid);

    CHECK(solves.of("alice").size() == 1);
    CHECK(solves.of("bob").front().number == 2);
    CHECK(solves.of("carol").empty());
    CHECK(reason_of(solves, "alice", 2) == "SOLVE_UNKNOWN");
    CHECK(reason_of(solves, "bob", 2).empty());
}

TEST_CASE("As many are kept as the limit says, the latest first") {
    RecentSolves solves({2, plenty});
    for (int i = 1; i <= 3; ++i) solves.add(*call_of("alice"), begun, solution_with(i), grid);

    const auto found = solves.of("alice");
    REQUIRE(found.size() == 2);
    CHECK(found[0].pmax == 3);
    CHECK(found[1].pmax == 2);
    CHECK(reason_of(solves, "alice", 1) == "SOLVE_UNKNOWN");
}

TEST_CASE("A limit of none keeps none") {
    RecentSolves solves({0, plenty});
    solves.add(*call_of("alice"), begun, solution_with(3), grid);
    CHECK(solves.of("alice").empty());
}

TEST_CASE("Pressures that are too many go, the oldest first, and their figures stay") {
    RecentSolves solves({10, 400});  // room for two of them
    for (int i = 1; i <= 4; ++i) solves.add(*call_of("alice"), begun, solution_with(i), grid);

    CHECK(solves.of("alice").size() == 4);
    CHECK(reason_of(solves, "alice", 2) == "SOLVE_UNKNOWN");
    CHECK(reason_of(solves, "alice", 3).empty());
    CHECK(reason_of(solves, "alice", 4).empty());

    const Grid large = Grid::of_elements(20, 20, 0.5, 0.5);
    solves.add(*call_of("alice"), begun, solution_with(5, large), large);
    CHECK_FALSE(solves.of("alice").front().pressures);  // more than the limit for all together
    CHECK(reason_of(solves, "alice", 4).empty());
}

TEST_CASE("What JSON cannot say is not kept") {
    RecentSolves solves({10, plenty});
    solves.add(*call_of("alice"), begun, solution_with(std::numeric_limits<double>::infinity()), grid);
    CHECK(solves.of("alice").empty());
}

TEST_CASE("Wheels on rails have a grid each place of contact, or none") {
    RecentSolves solves({10, plenty});
    WheelRailSolution wheel;
    solves.add(*call_of("alice"), begun, wheel);
    for (const double pmax : {3.0, 9.0}) {
        WheelRailPatch patch;
        patch.place.grid = grid;
        patch.solution = solution_with(pmax);
        wheel.patches.push_back(patch);
    }
    wheel.forces.track = {1, 2, 30, 0, 0, 0};
    solves.add(*call_of("alice"), begun, wheel);
    WheelsetSolution both{.left = wheel, .right = wheel, .roll_search = {}, .warnings = {}};
    solves.add(*call_of("alice"), begun, both);

    const auto found = solves.of("alice");
    CHECK(found[2].patches == 0);
    CHECK_FALSE(found[2].pressures);
    CHECK(found[1].patches == 2);
    CHECK(found[1].pmax == 9);
    CHECK(found[1].forces == std::array{1.0, 2.0, 30.0});
    CHECK(found[1].iterations == 24);
    CHECK_FALSE(found[1].grid);
    CHECK(found[0].elements == 24);
    CHECK(found[0].forces == std::array{2.0, 4.0, 60.0});
    CHECK_FALSE(found[0].converged);  // its search for the roll did not converge
}
