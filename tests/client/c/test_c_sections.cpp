// Bodies by their cross-sections, and contact on curved columns: in process and behind a daemon to the last bit.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <array>
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

Frames frames_of(contactd_contact* c, std::int32_t body = CONTACTD_LOWER) {
    Frames frames;
    require_ok(contactd_get_frames(c, body, frames.y.data(), frames.z.data(), frames.angle.data(), ny), c);
    return frames;
}

/// A rigid body that fits a section but for a rise along and across, on half-spaces that turn from column to column.
void set_contact(contactd_contact* c, const std::function<void(contactd_contact*)>& section) {
    require_ok(contactd_set_grid_centred(c, nx, ny, size, size), c);
    require_ok(contactd_set_rigid(c, CONTACTD_UPPER), c);
    require_ok(contactd_set_material(c, CONTACTD_LOWER, 82000, 0.28), c);
    section(c);
    require_ok(contactd_set_section_accuracy(c, CONTACTD_LOWER, 0), c);
    const Frames frames = frames_of(c);
    const double direction = frames.angle[ny / 2];  // a wheel's rim faces down
    require_ok(
        contactd_set_columns(c, frames.y.data(), frames.z.data(), frames.angle.data(), ny, direction, 0.5, -0.25), c);
    std::vector<double> gap;
    for (int row = 0; row < ny; ++row)
        for (int k = 0; k < nx; ++k) {
            const double x = (k - (nx - 1) / 2) * size, s = (row - (ny - 1) / 2.0) * size;
            gap.push_back(x * x / 100 + s * s / 200);
        }
    require_ok(contactd_set_gap(c, gap.data(), nx * ny), c);
    require_ok(contactd_set_Fn(c, 3000), c);
    require_ok(contactd_set_mu(c, 0.3), c);
    require_ok(contactd_set_rolling(c, CONTACTD_STEADY, 1e-3, 5e-4, 1e-4), c);
}

struct Told {
    Frames frames;
    Read step;
    std::array<double, 6> resultant{};
    bool operator==(const Told&) const = default;
};

Told told(contactd_connection* place, const std::function<void(contactd_contact*)>& section) {
    const Handle c(place);
    set_contact(c, section);
    Told all{frames_of(c), {}, {}};
    require_ok(contactd_start(c), c);
    all.step = stepped(c);
    require_ok(contactd_get_resultant(c, all.resultant.data()), c);
    return all;
}

std::function<void(contactd_contact*)> ready_made(std::int32_t shape, const std::vector<double>& numbers) {
    return [=](contactd_contact* c) {
        require_ok(
            contactd_set_section(c, CONTACTD_LOWER, shape, numbers.data(), static_cast<std::int32_t>(numbers.size())),
            c);
    };
}

/// A block whose top rises as a spline, with a hole in it.
void set_outline(contactd_contact* c) {
    constexpr std::int32_t L = CONTACTD_LOWER;
    const double y[] = {-10, 0, 10, 20}, z[] = {0.6, 0.8, 0.6, 0};
    require_ok(contactd_set_outline(c, L, -20, 0), c);
    require_ok(contactd_add_spline(c, L, y, z, 4, 0), c);
    require_ok(contactd_add_line(c, L, 20, -30, 0), c);
    require_ok(contactd_add_line(c, L, -20, -30, 1), c);
    require_ok(contactd_add_line(c, L, -20, 0, 0), c);
    require_ok(contactd_add_hole(c, L, 5, -15), c);
    require_ok(contactd_add_arc(c, L, -5, -15, -5, 0), c);
    require_ok(contactd_add_arc(c, L, 5, -15, -5, 0), c);
    require_ok(contactd_set_first_column(c, L, 0, 0, 15), c);
}

void set_profile(contactd_contact* c) {
    std::vector<double> y, z;
    for (int i = -34; i <= 34; ++i) {
        y.push_back(i);
        z.push_back(i * i / 600.0);
    }
    require_ok(contactd_set_profile_points(c, CONTACTD_LOWER, CONTACTD_RAIL, y.data(), z.data(),
                                           static_cast<std::int32_t>(y.size()), 0, 40, -5),
               c);
}

}  // namespace

TEST_CASE("Sections are solved alike in process and behind a daemon", "[c]") {
    Daemon daemon;
    const Place remote(daemon.endpoint()), local("local");
    const std::vector<std::pair<std::string, std::function<void(contactd_contact*)>>> sections{
        {"groove", ready_made(CONTACTD_GROOVE, {20, 20, 120, 70})},
        {"rail", ready_made(CONTACTD_RAIL_60E1, {0.025, CONTACTD_FOOT, 2})},
        {"rim", ready_made(CONTACTD_RIM_S1002, {60, 3})},
        {"edge", ready_made(CONTACTD_EDGE_BLOCK, {100, 50, 1})},
        {"round end", ready_made(CONTACTD_ROUND_END, {19.7, 60})},
        {"disc", ready_made(CONTACTD_DISC, {25, 2})},
        {"hole", ready_made(CONTACTD_PLATE_HOLE, {25, 200})},
        {"slab", ready_made(CONTACTD_SLAB, {5, 50})},
        {"half the size, upside down",
         [](contactd_contact* c) {
             ready_made(CONTACTD_GROOVE, {40, 40, 240, 140})(c);
             require_ok(contactd_set_section_place(c, CONTACTD_LOWER, 0.5, 0.1), c);
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
    require_ok(contactd_set_grid_centred(c, nx, ny, size, size), c);
    ready_made(CONTACTD_GROOVE, {20, 20, 120, 70})(c);
    const Frames groove = frames_of(c);
    set_profile(c);
    const Frames profile = frames_of(c);
    for (std::size_t i = 0; i < groove.y.size(); ++i) {
        CHECK(std::hypot(groove.y[i], groove.z[i]) == Approx(20).epsilon(1e-9));
        CHECK(groove.angle[i] == Approx(-std::asin(groove.y[i] / 20)).margin(1e-9));
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
    require_ok(contactd_set_grid_centred(c, nx, ny, size, size), c);
    set_profile(c);
    const Frames points = frames_of(c);
    require_ok(contactd_set_profile_file(c, CONTACTD_LOWER, CONTACTD_RAIL, file.c_str(), 0, 40, -5), c);
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
    require_ok(contactd_set_grid_centred(c, nx, ny, size, size), c);
    require_ok(contactd_set_rigid(c, CONTACTD_UPPER), c);
    require_ok(contactd_set_material(c, CONTACTD_LOWER, 82000, 0.28), c);
    ready_made(CONTACTD_EDGE_BLOCK, {100, 50, 1})(c);
    require_ok(contactd_set_section_accuracy(c, CONTACTD_LOWER, 0), c);
    require_ok(contactd_set_paraboloid(c, 50, 50), c);
    require_ok(contactd_set_Fn(c, 1000), c);
    require_ok(contactd_start(c), c);
    CHECK(stepped(c).Fn == Approx(1000).epsilon(1e-6));
    std::array<double, 6> forces{};
    CHECK(contactd_get_resultant(c, forces.data()) == CONTACTD_NOT_FOUND);
    const double flat[1] = {0};
    CHECK(contactd_set_columns(c, flat, flat, flat, 1, 0, 0, 0) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_add_line(c, CONTACTD_LOWER, 1, 1, 0) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_last_reason(c) == std::string("WRONG_ORDER"));
}

TEST_CASE("Of sections the same is refused in process and behind a daemon", "[c]") {
    Daemon daemon;
    const Place remote(daemon.endpoint()), local("local");
    constexpr std::int32_t L = CONTACTD_LOWER;
    const std::vector<std::pair<std::string, std::function<void(contactd_contact*)>>> bad{
        {"past a corner", ready_made(CONTACTD_EDGE_BLOCK, {9, 50, 1})},
        {"crossing",
         [](contactd_contact* c) {
             require_ok(contactd_set_outline(c, L, 0, 0), c);
             require_ok(contactd_add_line(c, L, 30, 0, 0), c);
             require_ok(contactd_add_line(c, L, 0, -20, 1), c);
             require_ok(contactd_add_line(c, L, 30, -20, 0), c);
             require_ok(contactd_add_line(c, L, 0, 0, 0), c);
         }},
        {"a cut above the profile",
         [](contactd_contact* c) {
             const double y[] = {-34, 0, 34}, z[] = {2, 0, 2};
             require_ok(contactd_set_profile_points(c, L, CONTACTD_RAIL, y, z, 3, 0, 1, 0), c);
         }},
        {"a part that is none",
         [](contactd_contact* c) {
             set_outline(c);
             require_ok(contactd_set_first_column(c, L, 0, 9, 0), c);
         }},
    };
    for (const auto& [name, section] : bad) {
        INFO(name);
        std::vector<std::tuple<std::int32_t, std::string, std::string>> frames;
        for (contactd_connection* place :
             {static_cast<contactd_connection*>(local), static_cast<contactd_connection*>(remote)}) {
            const Handle c(place);
            require_ok(contactd_set_grid_centred(c, nx, ny, size, size), c);
            require_ok(contactd_set_material(c, CONTACTD_BOTH, 82000, 0.28), c);
            require_ok(contactd_set_paraboloid(c, 50, 50), c);
            require_ok(contactd_set_Fn(c, 1000), c);
            section(c);
            Frames none;
            const std::int32_t code = contactd_get_frames(c, L, none.y.data(), none.z.data(), none.angle.data(), ny);
            frames.emplace_back(code, contactd_last_field(c), contactd_last_error(c));
            require_ok(contactd_set_section_accuracy(c, L, 0), c);
            CHECK(contactd_start(c) == CONTACTD_INVALID_ARGUMENT);
            CHECK(std::string(contactd_last_field(c)).find("section") != std::string::npos);
        }
        INFO(std::get<2>(frames[0]) << "\n" << std::get<2>(frames[1]));
        CHECK(frames[0] == frames[1]);
        CHECK(std::get<0>(frames[0]) == CONTACTD_INVALID_ARGUMENT);
        CHECK(std::get<1>(frames[0]).starts_with("ics.section"));
    }
}
