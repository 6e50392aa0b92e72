#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact/outer/outer_tolerances.hpp"

using namespace contactd;
using Catch::Matchers::WithinRel;

TEST_CASE("outer iterations are solved the better the less they change, and the last ones as asked for",
          "[dissimilar]") {
    const ContactSetup setup;
    OuterTolerances tolerances(setup, true);
    CHECK_FALSE(tolerances.are_final());
    SolverSettings normal = tolerances.normal(), tangential = tolerances.tangential();
    for (const double change : {1.0, 0.05, 0.06, 3e-3, 2e-4, 1e-5}) {
        tolerances.follow(change);
        CHECK(tolerances.normal().tolerance <= normal.tolerance);
        CHECK(tolerances.tangential().tolerance <= tangential.tolerance);
        CHECK(tolerances.normal().tolerance >= setup.settings.normal.tolerance);
        CHECK(tolerances.normal().tolerance < change);
        CHECK(tolerances.tangential().tolerance < change);
        normal = tolerances.normal();
        tangential = tolerances.tangential();
    }
    tolerances.follow(1e-6);
    CHECK(tolerances.are_final());
    tolerances.follow(1e-2);
    CHECK(tolerances.are_final());
}

TEST_CASE("outer iterations that may not be loose are solved as asked for from the first on", "[dissimilar]") {
    const ContactSetup setup;
    OuterTolerances tolerances(setup, false);
    CHECK(tolerances.are_final());
    tolerances.follow(0.5);
    CHECK(tolerances.are_final());
}

TEST_CASE("tolerances that are asked for are not tightened", "[dissimilar]") {
    ContactSetup setup;
    setup.settings.normal.tolerance = setup.settings.tangential.tolerance = 0.1;
    OuterTolerances tolerances(setup, true);
    CHECK(tolerances.are_final());
    tolerances.follow(1e-3);
    CHECK(tolerances.are_final());
}

TEST_CASE("what is left to change is the rest of the series that changes make", "[dissimilar]") {
    const ContactSetup setup;
    OuterTolerances tolerances(setup, true);
    tolerances.follow(1);
    CHECK(tolerances.left() == 1);  // nothing is known yet
    tolerances.follow(0.2);
    CHECK_THAT(tolerances.left(), WithinRel(0.05, 1e-12));  // 0.04 + 0.008 + ...
    tolerances.follow(0.2 * 0.3);                           // slower by the residual of the previous iteration
    CHECK_THAT(tolerances.left(), WithinRel(0.06 * 0.25, 1e-12));
    tolerances.follow(0.06 * 1e-3);  // luck
    CHECK_THAT(tolerances.left(), WithinRel(0.06e-3 / 9, 1e-12));
}

TEST_CASE("changes that do not get smaller by half say nothing of those to come", "[dissimilar]") {
    const ContactSetup setup;
    OuterTolerances tolerances(setup, true);
    tolerances.follow(1);
    tolerances.follow(0.8);
    CHECK(tolerances.left() == 0.8);
    tolerances.follow(0.6);
    CHECK(tolerances.left() == 0.6);
}

TEST_CASE("the last change of iterations that are not loose is what is left", "[dissimilar]") {
    const ContactSetup setup;
    OuterTolerances tolerances(setup, false);
    tolerances.follow(1);
    tolerances.follow(1e-3);
    CHECK(tolerances.left() == 1e-3);
}

TEST_CASE("the last outer iteration that is allowed is solved as asked for", "[dissimilar]") {
    ContactSetup setup;
    setup.settings.outer.max_iterations = 1;
    CHECK(OuterTolerances(setup, true).are_final());
    setup.settings.outer.max_iterations = 3;
    OuterTolerances tolerances(setup, true);
    CHECK_FALSE(tolerances.are_final());
    tolerances.follow(1);
    CHECK_FALSE(tolerances.are_final());
    tolerances.follow(0.05);
    CHECK(tolerances.are_final());
    tolerances.follow(4e-3);
    CHECK(tolerances.left() == 4e-3);  // iterations of different tolerances form no series
}
