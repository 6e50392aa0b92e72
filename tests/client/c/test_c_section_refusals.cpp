// Tests refusals of cross-sections and curved columns by the C interface, before anything is sent.
#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <string>

#include "c_contact.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::string section = "bodies.lower.ics.section";

struct Nowhere {
    Place place{"ipc:///nowhere/contactd", 0.05};
    Handle contact{place};

    void refuses(std::int32_t code, const std::string& field, const std::string& says = "") const {
        CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(contact) == field);
        CHECK(std::string(contactd_last_error(contact)).find(says) != std::string::npos);
    }
};

}  // namespace

TEST_CASE("Fields of a section are refused by their paths", "[c]") {
    const Nowhere at;
    contactd_contact* const c = at.contact;
    const auto refuses = [&](const std::string& field, double value, const std::string& says) {
        const std::string path = section + field;
        at.refuses(contactd_set(c, path.c_str(), value), path, says);
    };
    refuses(".groove.depht", 10, "radius, depth, width, height");
    refuses(".outline.holes[1].start.y", 1, "skips entries");
    refuses(".outline.outside.parts[0].clamped", 2, "0 or 1");
    refuses(".outline.part", 1.5, "a whole number");
    refuses(".rail_60e1", 1, "name one of its fields");
    const std::string support = section + ".rail_60e1.support", path = section + ".outline.outside.parts[0].arc";
    at.refuses(contactd_set_word(c, support.c_str(), "web"), support, "cut, foot");
    const double numbers[] = {1, nan, 2};
    at.refuses(contactd_set_array(c, path.c_str(), numbers, 3), path + ".to.z");
    at.refuses(contactd_set_array(c, path.c_str(), numbers, 2), "count", "has 3 numbers");
}

TEST_CASE("A section that cannot be is refused by the start", "[c]") {
    const Nowhere at;
    contactd_contact* const c = at.contact;
    set_sphere(c);
    set(c, {{"bodies.lower.G", 200}, {"bodies.lower.nu", 0.3}});
    set_word(c, "bodies.lower.ics.source", "fem");
    set_word(c, "bodies.lower.ics.body", "longitudinally_uniform");
    const auto start_refuses = [&](const std::string& field, const std::string& says) {
        at.refuses(contactd_start(c), field, says);
    };
    start_refuses("ics.section", "");
    set(c, {{section + ".groove.radius", 10}, {section + ".groove.depth", 11}});
    set(c, {{section + ".groove.width", 120}, {section + ".groove.height", 70}});
    start_refuses("ics.section.groove.depth", "radius");
    set(c, {{section + ".disc.radius", 10}, {section + ".disc.core", 0}});
    start_refuses("ics.section", "");
    set(c, {{section + ".outline.outside.start.y", 0}});
    start_refuses("ics.section.outline.outside.parts", "");
    set_word(c, section + ".profile_section.kind", "rail");
    set_array(c, section + ".profile_section.profile.points", {-30, 3, -10, 0.2, 0, 0, 10, 0.2, 30, 3});
    start_refuses("ics.section.profile_section.depth", "");
}

TEST_CASE("Frames are those of a section, on a grid", "[c]") {
    const Nowhere at;
    contactd_contact* const c = at.contact;
    double y = 0, z = 0, angle = 0;
    set(c, {{"bodies.lower.G", 200}, {"bodies.lower.nu", 0.3}, {"bodies.upper.rigid", 1}});
    at.refuses(contactd_get_frames(c, "lower", &y, &z, &angle, 1), section, "is missing");
    set_word(c, "bodies.lower.ics.body", "longitudinally_uniform");
    set(c, {{section + ".slab.thickness", 5}, {section + ".slab.width", 50}});
    at.refuses(contactd_get_frames(c, "lower", &y, &z, &angle, 1), "grid.nx");
    set(c, {{"grid.nx", 3}, {"grid.ny", 4}, {"grid.dx", 1}, {"grid.dy", 1}});
    at.refuses(contactd_get_frames(c, "lower", &y, &z, &angle, 3), "length", "4 rows");
    at.refuses(contactd_get_frames(c, "both", &y, &z, &angle, 4), "body", "upper, lower");
    at.refuses(contactd_get_frames(c, "lower", nullptr, &z, &angle, 4), "y");
    at.refuses(contactd_get_frames(c, "lower", &y, nullptr, &angle, 4), "z");
    at.refuses(contactd_get_frames(c, "lower", &y, &z, nullptr, 4), "angle");
    double forces[6] = {};
    CHECK(contactd_get_array(c, "resultant", forces, 6) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_last_reason(c) == std::string("NO_RESULT"));
}

TEST_CASE("Files of profiles are refused by their names", "[c]") {
    const Nowhere at;
    contactd_contact* const c = at.contact;
    const std::string profile = section + ".profile_section.profile";
    CHECK(contactd_read_profile(c, profile.c_str(), "/nowhere/rail.prr") == CONTACTD_INVALID_ARGUMENT);
    CHECK(std::string(contactd_last_error(c)).find("/nowhere/rail.prr") != std::string::npos);
    at.refuses(contactd_read_profile(c, section.c_str(), "rail.prr"), section, "is not a profile");
}
