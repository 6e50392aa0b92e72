// Tests bodies by their cross-sections, and contact on curved columns, in process and with a daemon to the last bit.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "c_contact.hpp"
#include "client/cpp/own_daemon.hpp"

using Catch::Approx;

namespace {

constexpr int nx = 15, ny = 20;
constexpr double size = 0.5;

struct Frames {
    std::vector<double> y = std::vector<double>(ny), z = y, angle = y;
    bool operator==(const Frames&) const = default;
};

Frames frames_of(contactd_contact* c, const char* body = "lower") {
    Frames frames;
    require_ok(contactd_get_frames(c, body, frames.y.data(), frames.z.data(), frames.angle.data(), ny), c);
    return frames;
}

const std::string ics = "bodies.lower.ics";
const std::string section_path = ics + ".section";

void set_grid(contactd_contact* c) {
    set(c, {{"grid.nx", nx}, {"grid.ny", ny}, {"grid.dx", size}, {"grid.dy", size}});
    set(c, {{"bodies.upper.rigid", 1}, {"bodies.lower.G", 82000}, {"bodies.lower.nu", 0.28}});
    set_word(c, ics + ".body", "longitudinally_uniform");
}

/// Creates a rigid body that fits a section except for a rise along and across, on half-spaces that rotate from column
/// to column.
void set_contact(contactd_contact* c, const std::function<void(contactd_contact*)>& section) {
    set_grid(c);
    section(c);
    const Frames frames = frames_of(c);
    Numbers all;
    for (std::size_t row = 0; row < ny; ++row) all.insert(all.end(), {frames.y[row], frames.z[row], frames.angle[row]});
    set_array(c, "columns.frames", all);
    set(c, "columns.direction", frames.angle[ny / 2]);  // a wheel's rim faces down
    set_array(c, "columns.origin", {0.5, -0.25});
    Numbers gap;
    for (int row = 0; row < ny; ++row)
        for (int k = 0; k < nx; ++k) {
            const double x = (k - (nx - 1) / 2) * size, s = (row - (ny - 1) / 2.0) * size;
            gap.push_back(x * x / 100 + s * s / 200);
        }
    set_array(c, "gap.array", gap);
    set(c, {{"Fn", 3000}, {"friction.mu", 0.3}, {"friction.rolling.xi", 1e-3}});
    set(c, {{"friction.rolling.eta", 5e-4}, {"friction.rolling.phi", 1e-4}});
}

struct Told {
    Frames frames;
    Read step;
    Numbers resultant{};
    bool operator==(const Told&) const = default;
};

Told told(contactd_connection* place, const std::function<void(contactd_contact*)>& section) {
    const Handle c(place);
    set_contact(c, section);
    Told all{frames_of(c), {}, {}};
    require_ok(contactd_start(c), c);
    all.step = stepped(c);
    all.resultant = get_array(c, "resultant");
    return all;
}

using Fields = std::vector<std::pair<std::string, double>>;

std::function<void(contactd_contact*)> ready_made(const std::string& shape, const Fields& fields) {
    return [=](contactd_contact* c) {
        for (const auto& [name, value] : fields) set(c, section_path + "." + shape + "." + name, value);
    };
}
const auto groove = ready_made("groove", {{"radius", 20}, {"depth", 20}, {"width", 120}, {"height", 70}});

/// Sets a straight part of the outside.
void set_line(contactd_contact* c, int part, double y, double z, bool clamped = false) {
    const std::string path = section_path + ".outline.outside.parts[" + std::to_string(part) + "]";
    set_array(c, path + ".line.to", {y, z});
    set(c, path + ".clamped", clamped);
}

/// Creates a block with a spline as its top, and a hole.
void set_outline(contactd_contact* c) {
    const std::string outline = section_path + ".outline", hole = outline + ".holes[0]";
    set_array(c, outline + ".outside.start", {-20, 0});
    set_array(c, outline + ".outside.parts[0].spline.through", {-10, 0.6, 0, 0.8, 10, 0.6, 20, 0});
    set_line(c, 1, 20, -30);
    set_line(c, 2, -20, -30, true);
    set_line(c, 3, -20, 0);
    set_array(c, hole + ".start", {5, -15});
    set_array(c, hole + ".parts[0].arc", {-5, -15, -5});
    set_array(c, hole + ".parts[1].arc", {5, -15, -5});
    set(c, outline + ".from", 15);
}

void set_profile(contactd_contact* c) {
    Numbers points;
    for (int i = -34; i <= 34; ++i) points.insert(points.end(), {double(i), i * i / 600.0});
    const std::string profile = section_path + ".profile_section";
    set_word(c, profile + ".kind", "rail");
    set_array(c, profile + ".profile.points", points);
    set(c, {{profile + ".depth", 40}, {profile + ".from", -5}});
}

}  // namespace

TEST_CASE("Sections are solved alike in process and behind a daemon", "[c]") {
    Daemon daemon;
    const Place remote(daemon.endpoint()), local("local");
    const std::vector<std::pair<std::string, std::function<void(contactd_contact*)>>> sections{
        {"groove", groove},
        {"rail",
         [](contactd_contact* c) {
             ready_made("rail_60e1", {{"inclination", 0.025}, {"from", 2}})(c);
             set_word(c, section_path + ".rail_60e1.support", "foot");
         }},
        {"rim", ready_made("rim_s1002", {{"thickness", 60}, {"from", 3}})},
        {"edge", ready_made("edge_block", {{"width", 100}, {"height", 50}, {"edge_distance", 1}})},
        {"round end", ready_made("round_end", {{"radius", 19.7}, {"length", 60}})},
        {"disc", ready_made("disc", {{"radius", 25}, {"core", 2}})},
        {"hole", ready_made("plate_hole", {{"radius", 25}, {"plate_radius", 200}})},
        {"slab", ready_made("slab", {{"thickness", 5}, {"width", 50}})},
        {"half the size, rotated",
         [](contactd_contact* c) {
             ready_made("groove", {{"radius", 40}, {"depth", 40}, {"width", 240}, {"height", 140}})(c);
             set(c, {{section_path + ".size", 0.5}, {section_path + ".turn", 0.1}});
         }},
        {"outline", set_outline},
        {"profile", set_profile},
    };
    for (const auto& [name, section] : sections) {
        INFO(name);
        const Told here = told(local, section);
        CHECK(told(remote, section) == here);
        CHECK(here.step.Fn == Approx(3000).epsilon(1e-6));
        CHECK(here.step.Fx != 0);
        CHECK(here.resultant[0] == Approx(here.step.Fx).epsilon(1e-9));
    }
}

TEST_CASE("Columns of a groove lie on its circle, and those of a profile on it", "[c]") {
    const Place local("local");
    const Handle c(local);
    set_grid(c);
    groove(c);
    const Frames round = frames_of(c);
    set_profile(c);
    const Frames profile = frames_of(c);
    for (std::size_t i = 0; i < round.y.size(); ++i) {
        CHECK(std::hypot(round.y[i], round.z[i]) == Approx(20).epsilon(1e-9));
        CHECK(round.angle[i] == Approx(-std::asin(round.y[i] / 20)).margin(1e-9));
        CHECK(profile.z[i] == Approx(-profile.y[i] * profile.y[i] / 600).margin(2e-4));
    }
}

TEST_CASE("A profile's file is that of its points", "[c]") {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / "contactd-test-profile.txt";
    std::ofstream text(file);
    for (int i = -34; i <= 34; ++i) text << i << " " << i * i / 600.0 << "\n";
    text.close();
    const Place local("local");
    const Handle c(local);
    set_grid(c);
    set_profile(c);
    const Frames points = frames_of(c);
    require_ok(contactd_read_profile(c, (section_path + ".profile_section.profile").c_str(), file.c_str()), c);
    const Frames read = frames_of(c);
    std::filesystem::remove(file);
    for (std::size_t i = 0; i < points.y.size(); ++i) {
        CHECK(read.y[i] == Approx(points.y[i]).margin(1e-4));
        CHECK(read.angle[i] == Approx(points.angle[i]).margin(1e-4));
    }
}

TEST_CASE("Columns of a flat contact may be left out, and then there is no resultant", "[c]") {
    const Place local("local");
    const Handle c(local);
    set_grid(c);
    ready_made("edge_block", {{"width", 100}, {"height", 50}, {"edge_distance", 1}})(c);
    set(c, {{"gap.paraboloid.Rx", 50}, {"gap.paraboloid.Ry", 50}, {"Fn", 1000}});
    require_ok(contactd_start(c), c);
    CHECK(stepped(c).Fn == Approx(1000).epsilon(1e-6));
    CHECK_FALSE(has(c, "resultant"));
    CHECK(contactd_set(c, "columns.direction", 0) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_last_reason(c) == std::string("WRONG_ORDER"));
}

TEST_CASE("Of sections the same is refused in process and behind a daemon", "[c]") {
    Daemon daemon;
    const Place remote(daemon.endpoint()), local("local");
    const std::vector<std::pair<std::string, std::function<void(contactd_contact*)>>> bad{
        {"past a corner", ready_made("edge_block", {{"width", 9}, {"height", 50}, {"edge_distance", 1}})},
        {"crossing",
         [](contactd_contact* c) {
             set_array(c, section_path + ".outline.outside.start", {0, 0});
             set_line(c, 0, 30, 0);
             set_line(c, 1, 0, -20, true);
             set_line(c, 2, 30, -20);
             set_line(c, 3, 0, 0);
         }},
        {"a cut above the profile",
         [](contactd_contact* c) {
             set_profile(c);
             set(c, section_path + ".profile_section.depth", 1);
         }},
        {"a part that is none",
         [](contactd_contact* c) {
             set_outline(c);
             set(c, section_path + ".outline.part", 9);
         }},
    };
    for (const auto& [name, section] : bad) {
        INFO(name);
        std::vector<std::tuple<std::int32_t, std::string, std::string>> frames;
        for (contactd_connection* place :
             {static_cast<contactd_connection*>(local), static_cast<contactd_connection*>(remote)}) {
            const Handle c(place);
            set_grid(c);
            set(c, {{"gap.paraboloid.Rx", 50}, {"gap.paraboloid.Ry", 50}, {"Fn", 1000}});
            section(c);
            Frames none;
            const std::int32_t code =
                contactd_get_frames(c, "lower", none.y.data(), none.z.data(), none.angle.data(), ny);
            frames.emplace_back(code, contactd_last_field(c), contactd_last_error(c));
            CHECK(contactd_start(c) == CONTACTD_INVALID_ARGUMENT);
            CHECK(std::string(contactd_last_field(c)).find("section") != std::string::npos);
        }
        INFO(std::get<2>(frames[0]) << "\n" << std::get<2>(frames[1]));
        CHECK(frames[0] == frames[1]);
        CHECK(std::get<0>(frames[0]) == CONTACTD_INVALID_ARGUMENT);
        CHECK(std::get<1>(frames[0]).starts_with("ics.section"));
    }
}
