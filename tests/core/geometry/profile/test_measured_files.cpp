// Tests measured files: public ones of the CONTACT program, read from their folder next to the repository.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/read_profile.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

const std::filesystem::path folder = std::filesystem::path(SHARED_FILES) / "contact/testbank/profiles";

/// Lists the expected top or tip of each file: z of the lowest point of a wheel, or of the highest of a rail (mm), and
/// whether z points upwards there.
struct Measured {
    const char* name;
    ProfileKind kind;
    double extreme;
    bool is_upwards;
};
constexpr auto wheel = ProfileKind::wheel, rail = ProfileKind::rail;
const std::vector<Measured> measured{
    {"avg_HR.BAN", rail, -0.21, true},
    {"avg_low2.ban", rail, -0.22, true},
    {"guard_rail_test.ban", rail, 0.0044, true},
    {"left-roller-v1-pre-dry.ban", rail, -0.2728, false},
    {"right-roller-v1-pre-dry.ban", rail, -0.2279, false},
    {"rail_left_iter288.ban", rail, -1.7325, true},
    {"rail_left_iter795.ban", rail, -6.011, true},
    {"Car7216_0001r.whl", wheel, 27.8119, false},
    {"Car7358_0001r.whl", wheel, 26.9738, false},
    {"Car7422_0001r.whl", wheel, 28.5935, false},
    {"Car7813_0001r.whl", wheel, 27.6835, false},
    {"avg_wheel.whl", wheel, 28.03, false},
    {"left-wheel-v1-pre-dry.whl", wheel, 28.1933, false},
    {"right-wheel-v1-pre-dry.whl", wheel, 28.1481, false},
    {"whl_left_iter288.whl", wheel, 28.3544, false},
    {"whl_left_iter795.whl", wheel, 34.9806, false},
    {"MBench_S1002_v3.prw", wheel, 27.9995, false},
    {"worn_high_mileage.prw", wheel, 35.3617, false},
    {"MBench_UIC60_v3.prr", rail, 6.03235e-05, false},
    {"site_b_hr.prr", rail, 0, false},
    {"uic60_true.prr", rail, 0, false},
};

/// Returns points as rows of text: `write` makes one row of y and z.
std::string text_of(const ProfilePoints& points, const auto& write) {
    std::ostringstream text;
    text.precision(12);
    for (const ProfilePoint& point : points.points) write(text, point.y, point.z);
    return text.str();
}

std::string with_commas(double value) {
    std::ostringstream text;
    text.precision(12);
    text << value;
    std::string digits = text.str();
    std::ranges::replace(digits, '.', ',');
    return digits;
}

}  // namespace

TEST_CASE("measured files are read, each the right way up", "[profile]") {
    if (!std::filesystem::exists(folder)) SKIP("there is no " + folder.string());
    for (const Measured& file : measured) {
        INFO(file.name);
        const ProfileSpec spec =
            read_profile(folder / file.name, file.name[0] == 'a' ? std::optional(file.kind) : std::nullopt);
        const auto& points = std::get<ProfilePoints>(spec.shape);
        CHECK(spec.kind == file.kind);
        CHECK(points.mirror_z == file.is_upwards);
        const auto z = [&](const ProfilePoint& point) { return file.is_upwards ? -point.z : point.z; };
        const auto [highest, lowest] = std::ranges::minmax_element(points.points, {}, z);
        const double extreme = (file.kind == wheel ? lowest : highest)->z;
        CHECK_THAT(extreme, WithinAbs(file.extreme, 5e-4));
        const Profile made = make_profile(spec);
        CHECK(made.evidence.points_kept > points.points.size() / 2);
        if (file.kind == rail) continue;
        const ProfilePoint tip = *std::ranges::max_element(made.curve.points(), {}, &ProfilePoint::z);
        CHECK(tip.y < (made.curve.points().front().y + made.curve.points().back().y) / 2);
    }
}

TEST_CASE("measured points give the same curve in whatever form they are written", "[profile]") {
    if (!std::filesystem::exists(folder)) SKIP("there is no " + folder.string());
    for (const Measured& file : measured) {
        INFO(file.name);
        const ProfileSpec spec = read_profile(folder / file.name);
        const auto& given = std::get<ProfilePoints>(spec.shape);
        ProfilePoints upright = given;
        for (ProfilePoint& point : upright.points)
            point = {given.mirror_y ? -point.y : point.y, given.mirror_z ? -point.z : point.z};
        upright.mirror_y = upright.mirror_z = false;
        ProfilePoints reversed = upright;
        std::ranges::reverse(reversed.points);
        const ProfileCurve expected = make_profile({file.kind, upright}).curve;
        const auto plain = [](auto& text, double y, double z) { text << y << ' ' << z << '\n'; };
        const auto mirrored = [](auto& text, double y, double z) { text << y << '\t' << -z << " # point\r\n"; };
        const auto commas = [](auto& text, double y, double z) {
            text << with_commas(y) << ';' << with_commas(z) << '\n';
        };
        const auto table = [](auto& text, double y, double z) { text << '"' << y << "\",\"" << -z << "\"\r\n"; };
        for (const auto& [form, text] :
             {std::pair("reversed", text_of(reversed, plain)),
              std::pair("upside down", "% y z\n" + text_of(upright, mirrored)),
              std::pair("decimal commas", "y;z\n" + text_of(upright, commas)),
              std::pair("table", "\xef\xbb\xbf\"Y\",\"Z\"\r\n" + text_of(reversed, table))}) {
            INFO(form);
            const ProfileCurve curve =
                make_profile(read_profile(std::string_view(text), "points.csv", file.kind)).curve;
            REQUIRE(curve.points().size() == expected.points().size());
            double largest = 0;
            for (std::size_t i = 0; i < curve.points().size(); ++i)
                largest = std::max({largest, std::abs(curve.points()[i].y - expected.points()[i].y),
                                    std::abs(curve.points()[i].z - expected.points()[i].z)});
            CHECK(largest < 1e-6);
        }
    }
}
