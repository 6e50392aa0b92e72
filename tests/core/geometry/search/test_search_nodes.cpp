// Tests the nodes of reference programs for the search for contacts.
#include "geometry/search/search_nodes.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <memory>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using namespace contactd;
using namespace contactd::geometry;

TEST_CASE("Search nodes of a round wheel are an odd number of lines of its profile's points") {
    const WheelSurface wheel(make_profile({ProfileKind::wheel, S1002{}}).curve, Wheelset{}, {});
    const NodeMesh mesh = search_nodes(wheel, 0.2);
    CHECK(mesh.columns() == 385);  // 115 mm over 0.3 mm, plus two
    CHECK_THAT(mesh.node(0, 3).x, WithinAbs(-460.0 / 8, 1e-12));
    CHECK_THAT(mesh.node(192, 3).x, WithinAbs(0, 1e-12));
    CHECK_THAT(mesh.node(384, 3).x, WithinAbs(460.0 / 8, 1e-12));
    const Vector3 first = mesh.node(0, 7), lowest = mesh.node(192, 7);
    const double rho = 460 + lowest.z;
    CHECK_THAT(first.z, WithinAbs(std::sqrt(rho * rho - 57.5 * 57.5) - 460, 1e-9));
    CHECK(first.y == lowest.y);
}

TEST_CASE("Search nodes of an out-of-round wheel reach so far as an angle") {
    const ProfileCurve profile = make_profile({ProfileKind::wheel, S1002{}}).curve;
    const WheelSurface wheel(
        profile, Wheelset{}, {}, {},
        std::make_shared<const OutOfRound>(std::vector<double>{-1, 1}, std::vector<ProfileCurve>{profile, profile}));
    const NodeMesh mesh = search_nodes(wheel, 0.2);
    CHECK(mesh.columns() == 233);  // 184 mm over 0.8 mm, plus two, made odd
    const Vector3 last = mesh.node(232, 100), lowest = mesh.node(116, 100);
    CHECK_THAT(std::atan2(last.x, last.z + 460), WithinAbs(0.2, 1e-12));
    CHECK_THAT(lowest.x, WithinAbs(0, 1e-12));
    CHECK_THAT(std::hypot(last.x, last.z + 460), WithinAbs(lowest.z + 460, 1e-9));
}

TEST_CASE("A mesh of a wheel that is too fine is refused before any of its nodes is made") {
    const ProfileCurve profile = make_profile({ProfileKind::wheel, S1002{}}).curve;
    const WheelSurface round(profile, Wheelset{}, {});
    const WheelSurface sliced(
        profile, Wheelset{}, {}, {},
        std::make_shared<const OutOfRound>(std::vector<double>{-1, 1}, std::vector<ProfileCurve>{profile, profile}));
    for (const double dx : {1e-4, 1e-300})
        for (const WheelSurface* wheel : {&round, &sliced})
            CHECK_THROWS_MATCHES(search_nodes(*wheel, dx), InvalidArgument,
                                 MessageMatches(ContainsSubstring("too small for a wheel with")));
}
