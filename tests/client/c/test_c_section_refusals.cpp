// What the C interface refuses of cross-sections and curved columns, before anything is sent.
#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <string>
#include <vector>

#include "c_contact.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
constexpr std::int32_t L = CONTACTD_LOWER;

struct Nowhere {
    Place place{"ipc:///nowhere/contactd", 0.05};
    Handle contact{place};

    void refuses(std::int32_t code, const std::string& field, const std::string& says = "") const {
        CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(contact) == field);
        CHECK(contactd_last_error(contact) == std::string(contactd_last_error(contact)));
        CHECK(std::string(contactd_last_error(contact)).find(says) != std::string::npos);
    }
};

}  // namespace

TEST_CASE("A ready-made section takes as many numbers as it has, and no others", "[c]") {
    const Nowhere at;
    contactd_contact* const c = at.contact;
    const double groove[] = {10, 10, 120, 70}, shallow[] = {10, 11, 120, 70}, rail[] = {0, 2, 0}, disc[] = {10, 0};
    CHECK(contactd_set_section(c, L, CONTACTD_GROOVE, groove, 4) == CONTACTD_OK);
    at.refuses(contactd_set_section(c, L, CONTACTD_GROOVE, groove, 3), "count", "radius, depth, width, height");
    at.refuses(contactd_set_section(c, L, CONTACTD_GROOVE, nullptr, 4), "numbers", "NULL");
    at.refuses(contactd_set_section(c, L, CONTACTD_GROOVE, groove, 0), "count");
    at.refuses(contactd_set_section(c, L, CONTACTD_GROOVE, shallow, 4), "ics.section.groove.depth", "radius");
    at.refuses(contactd_set_section(c, L, CONTACTD_RAIL_60E1, rail, 3), "ics.section.rail_60e1.support", "FOOT");
    at.refuses(contactd_set_section(c, L, CONTACTD_DISC, disc, 2), "ics.section", "clamped nowhere");
    for (const std::int32_t none : {-1, 0, 9, std::numeric_limits<std::int32_t>::max()})
        at.refuses(contactd_set_section(c, L, none, groove, 4), "shape");
    at.refuses(contactd_set_section(c, CONTACTD_PAIR, CONTACTD_GROOVE, groove, 4), "body");
    for (const double bad : {nan, infinite, -infinite}) {
        const double numbers[] = {10, bad, 120, 70};
        at.refuses(contactd_set_section(c, L, CONTACTD_GROOVE, numbers, 4), "ics.section.groove.depth");
        at.refuses(contactd_set_section_place(c, L, bad, 0), "ics.section.size");
        at.refuses(contactd_set_section_place(c, L, 1, bad), "ics.section.turn");
        at.refuses(contactd_set_section_accuracy(c, L, bad), "ics.accuracy");
    }
    at.refuses(contactd_set_section_accuracy(c, L, 0.5), "ics.accuracy", "half-spaces that turn");
    at.refuses(contactd_set_section_accuracy(c, L, -1), "ics.accuracy");
    CHECK(contactd_set_section_accuracy(c, L, 0) == CONTACTD_OK);
    CHECK(contactd_set_section_accuracy(c, L, 1e-2) == CONTACTD_OK);
}

TEST_CASE("What belongs to a section is refused before there is one", "[c]") {
    const Nowhere at;
    contactd_contact* const c = at.contact;
    const double slab[] = {5, 50};
    at.refuses(contactd_set_section_place(c, L, 1, 0), "ics.section", "contactd_set_section");
    at.refuses(contactd_set_section_accuracy(c, L, 0.01), "ics.section");
    at.refuses(contactd_add_line(c, L, 1, 0, 0), "ics.section");
    double y = 0, z = 0, angle = 0;
    at.refuses(contactd_get_frames(c, L, &y, &z, &angle, 1), "ics.section");
    REQUIRE(contactd_set_section(c, L, CONTACTD_SLAB, slab, 2) == CONTACTD_OK);
    at.refuses(contactd_add_line(c, L, 1, 0, 0), "ics.section.outline", "contactd_set_outline");
    at.refuses(contactd_add_hole(c, L, 1, 0), "ics.section.outline");
    at.refuses(contactd_set_first_column(c, L, 0, 0, 1), "ics.section.outline");
    at.refuses(contactd_set_section_place(c, CONTACTD_BOTH, 1, 0), "ics.section");  // the upper body has none
    at.refuses(contactd_get_frames(c, L, &y, &z, &angle, 1), "grid.nx");
    REQUIRE(contactd_set_grid_centred(c, 3, 4, 1, 1) == CONTACTD_OK);
    at.refuses(contactd_get_frames(c, L, &y, &z, &angle, 3), "length", "4 rows");
    at.refuses(contactd_get_frames(c, CONTACTD_BOTH, &y, &z, &angle, 4), "body");
    at.refuses(contactd_get_frames(c, L, nullptr, &z, &angle, 4), "y");
    at.refuses(contactd_get_frames(c, L, &y, nullptr, &angle, 4), "z");
    at.refuses(contactd_get_frames(c, L, &y, &z, nullptr, 4), "angle");
    double forces[6] = {};
    CHECK(contactd_get_resultant(c, nullptr) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_get_resultant(c, forces) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_last_reason(c) == std::string("NO_RESULT"));
}

TEST_CASE("Parts of an outline are refused where they are said, and leave it as it was", "[c]") {
    const Nowhere at;
    contactd_contact* const c = at.contact;
    const double y[] = {1, nan}, z[] = {0, 1};
    for (const double bad : {nan, infinite}) {
        at.refuses(contactd_set_outline(c, L, bad, 0), "ics.section.outline.outside.start.y");
        at.refuses(contactd_set_outline(c, L, 0, bad), "ics.section.outline.outside.start.z");
    }
    REQUIRE(contactd_set_outline(c, L, 0, 0) == CONTACTD_OK);
    for (const double bad : {nan, infinite}) {
        at.refuses(contactd_add_line(c, L, bad, 0, 0), "ics.section.outline.part.to.y");
        at.refuses(contactd_add_arc(c, L, 1, bad, 1, 0), "ics.section.outline.part.to.z");
        at.refuses(contactd_add_arc(c, L, 1, 1, bad, 0), "ics.section.outline.part.radius");
        at.refuses(contactd_add_hole(c, L, bad, 0), "ics.section.outline.holes.start.y");
        at.refuses(contactd_set_first_column(c, L, 0, 0, bad), "ics.section.outline.from");
    }
    at.refuses(contactd_add_spline(c, L, y, z, 2, 0), "ics.section.outline.part.through[1].y");
    at.refuses(contactd_add_spline(c, L, nullptr, z, 2, 0), "spline.y");
    at.refuses(contactd_add_spline(c, L, y, nullptr, 2, 0), "spline.z");
    at.refuses(contactd_add_spline(c, L, y, z, 0, 0), "count");
    at.refuses(contactd_add_line(c, L, 1, 0, 2), "clamped");
    at.refuses(contactd_set_first_column(c, L, -1, 0, 0), "ics.section.outline.carrier");
    at.refuses(contactd_set_first_column(c, L, 0, -1, 0), "ics.section.outline.part");
    set_sphere(c);
    CHECK(contactd_start(c) == CONTACTD_INVALID_ARGUMENT);  // no part was added
    CHECK(contactd_last_field(c) == std::string("ics.section.outline.outside.parts"));
}

TEST_CASE("Profiles and columns are refused where they are said", "[c]") {
    const Nowhere at;
    contactd_contact* const c = at.contact;
    const double y[] = {-30, -10, 0, 10, 30}, z[] = {3, 0.2, 0, 0.2, 3}, holed[] = {3, nan, 0, 0.2, 3};
    const std::string field = "ics.section.profile_section";
    CHECK(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, z, 5, 0, 40, -2) == CONTACTD_OK);
    at.refuses(contactd_set_profile_points(c, L, 2, y, z, 5, 0, 40, 0), "kind");
    at.refuses(contactd_set_profile_points(c, L, CONTACTD_RAIL, nullptr, z, 5, 0, 40, 0), "profile.y");
    at.refuses(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, nullptr, 5, 0, 40, 0), "profile.z");
    at.refuses(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, z, -5, 0, 40, 0), "count");
    at.refuses(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, holed, 5, 0, 40, 0), field + ".profile.points[1]");
    at.refuses(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, z, 5, nan, 40, 0),
               field + ".profile.smoothing_length");
    at.refuses(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, z, 5, 0, nan, 0), field + ".depth");
    at.refuses(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, z, 5, 0, 0, 0), field + ".depth");
    at.refuses(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, z, 5, 0, 40, infinite), field + ".from");
    at.refuses(contactd_set_profile_file(c, L, CONTACTD_RAIL, nullptr, 0, 40, 0), "path");
    CHECK(contactd_set_profile_file(c, L, CONTACTD_RAIL, "/nowhere/rail.prr", 0, 40, 0) == CONTACTD_INVALID_ARGUMENT);
    CHECK(std::string(contactd_last_error(c)).find("/nowhere/rail.prr") != std::string::npos);

    const double angle[] = {0, 0.1, nan, 0, 0};
    at.refuses(contactd_set_columns(c, nullptr, z, y, 5, 0, 0, 0), "columns.frames.y");
    at.refuses(contactd_set_columns(c, y, nullptr, y, 5, 0, 0, 0), "columns.frames.z");
    at.refuses(contactd_set_columns(c, y, z, nullptr, 5, 0, 0, 0), "columns.frames.angle");
    at.refuses(contactd_set_columns(c, y, z, angle, 5, 0, 0, 0), "columns.frames[2].angle");
    at.refuses(contactd_set_columns(c, y, z, z, 0, 0, 0, 0), "count");
    at.refuses(contactd_set_columns(c, y, z, z, 5, nan, 0, 0), "columns.direction");
    at.refuses(contactd_set_columns(c, y, z, z, 5, 0, nan, 0), "columns.origin.y");
    at.refuses(contactd_set_columns(c, y, z, z, 5, 0, 0, infinite), "columns.origin.z");
}
