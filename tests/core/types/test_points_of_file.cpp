// Tests profiles by the content of a file: options, and properties that neither the file nor the options define.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/read_profile.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;

namespace {

ProfileCurve exact(ProfileKind kind) {
    return make_profile(kind == ProfileKind::wheel ? ProfileSpec{kind, S1002{}} : ProfileSpec{kind, Rail60E1{0.025}})
        .curve;
}

/// Returns rows of S1002 or 60E1, y and z times these factors.
std::string rows(ProfileKind kind, double y_factor = 1, double z_factor = 1) {
    const ProfileCurve curve = exact(kind);
    std::ostringstream text;
    text.precision(12);
    for (double s = 0; s < curve.end(); s += 0.7)
        text << y_factor * curve.at(s).y << ' ' << z_factor * curve.at(s).z << '\n';
    return text.str();
}

std::string simpack(ProfileKind kind, const std::string& keys, double factor = 1) {
    return std::string("header.begin\ntype = ") + (kind == ProfileKind::wheel ? "1" : "0") +
           "\nheader.end\nspline.begin\ncomment = 'none'\n" + keys + "point.begin\n" + rows(kind, factor, factor) +
           "point.end\nspline.end\n";
}

/// Checks whether the curve of a file equals that of the formula, except for the shift.
void is_exact(const ProfileFile& file, ProfileKind kind) {
    const ProfileCurve curve = make_profile({kind, file}).curve, expected = exact(kind);
    for (const double y : {-25.0, -3.0, 10.0, 20.0})
        CHECK_THAT(curve.at(curve.s_at_y(y + file.shift_y)).z,
                   WithinAbs(expected.at(expected.s_at_y(y)).z + file.shift_z, 2e-4));
}

ProfileReading reading_of(const ProfileFile& file, ProfileKind kind) {
    return *make_profile({kind, file}).evidence.file;
}

void refused(const ProfileFile& file, ProfileKind kind, const std::string& field, const std::string& what) {
    try {
        make_profile({kind, file});
        FAIL("was taken, in place of " + what);
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == field);
        CHECK_THAT(error.problem(), ContainsSubstring(what));
    }
}

constexpr auto wheel = ProfileKind::wheel, rail = ProfileKind::rail;

}  // namespace

TEST_CASE("the points of a file are mirrored as their shape asks for, and evidence says so", "[profile]") {
    const auto kind = GENERATE(wheel, rail);
    const double sense = GENERATE(1.0, -1.0);
    const std::string name = GENERATE("points.csv", "measured", "old");
    CAPTURE(name_of(kind), sense, name);
    const bool miniprof = name == "measured";
    const std::string ending = miniprof ? (kind == wheel ? ".WHL" : ".ban") : "";
    const ProfileFile file{.name = "C:\\data\\" + name + ending,
                           .text = (miniprof ? "Rail=left\nXYPoints=3\n\n" : "y z\n") + rows(kind, 1, sense)};
    is_exact(file, kind);
    const ProfileReading reading = reading_of(file, kind);
    CHECK(reading == ProfileReading{miniprof ? ProfileFormat::miniprof : ProfileFormat::columns, 1, false, sense < 0,
                                    OrientedBy::shape, miniprof ? 2u : 1u});
}

TEST_CASE("what is said beside a file holds after what it says itself", "[profile]") {
    SECTION("of columns") {
        is_exact({.name = "a.txt", .text = rows(wheel, -1, -1), .mirror_y = true, .mirror_z = true}, wheel);
        CHECK(reading_of({.name = "a.txt", .text = rows(wheel), .mirror_z = false}, wheel).oriented_by ==
              OrientedBy::request);
        is_exact({.name = "a.txt", .text = rows(rail), .shift_y = 3, .shift_z = -0.5}, rail);
    }
    SECTION("of Simpack") {
        const std::string keys = "units.len.f = 1000\nmirror.y = 1\nmirror.z = 1\n";
        const ProfileFile file{.name = "a.prr", .text = simpack(rail, keys, -1)};
        is_exact(file, rail);
        CHECK(reading_of(file, rail) == ProfileReading{ProfileFormat::simpack, 1, true, true, OrientedBy::file, 1});
        ProfileFile mirrored = file;
        mirrored.mirror_y = true;
        CHECK_FALSE(reading_of(mirrored, rail).mirror_y);
        mirrored.mirror_z = true;
        refused(mirrored, rail, "profile.file", "change mirror_z");
    }
}

TEST_CASE("a file whose unit nothing says is refused, and read in the unit that is said", "[profile]") {
    const auto kind = GENERATE(wheel, rail);
    const double unit = GENERATE(25.4, 1000.0);
    const ProfileFile file{.name = "a.txt", .text = rows(kind, 1 / unit, 1 / unit)};
    refused(file, kind, "profile.file", "a.txt: its points span");
    refused(file, kind, "profile.file", "give unit, 25.4 for inches, 1000 for metres");
    ProfileFile with_unit = file;
    with_unit.unit = unit;
    is_exact(with_unit, kind);
    CHECK(reading_of(with_unit, kind).unit == unit);
    // Simpack's default unit is the metre, but the caller may override it.
    const std::string name = kind == wheel ? "a.prw" : "a.prr";
    is_exact({.name = name, .text = simpack(kind, "", 1e-3)}, kind);
    refused({.name = name, .text = simpack(kind, "")}, kind, "profile.file", "give unit");
    is_exact({.name = name, .text = simpack(kind, ""), .unit = 1}, kind);
}

TEST_CASE("a file of which nothing shows which way z points is refused until that is said", "[profile]") {
    const auto [kind, text] = GENERATE(table<ProfileKind, std::string>({
        {wheel, "-40 2\n0 0\n40 -2\n"},
        {wheel, "-40 0\n0 0\n40 0\n"},
        {rail, "-40 2\n0 0\n40 -2\n"},
        {rail, "-40 0\n0 0\n40 0\n"},
    }));
    ProfileFile file{.name = "cone.txt", .text = text};
    refused(file, kind, "profile.file", "cone.txt: its points do not determine the direction of z");
    refused(file, kind, "profile.file", "give mirror_z, true if z points upwards");
    file.mirror_z = GENERATE(false, true);
    const ProfileCurve curve = make_profile({kind, file}).curve;
    CHECK_THAT(curve.at(0).z, WithinAbs((*file.mirror_z ? -1 : 1) * (text.starts_with("-40 2") ? 2 : 0), 1e-12));
}

TEST_CASE("points in no order are refused as such, whatever z is", "[profile]") {
    const ProfileKind kind = GENERATE(wheel, rail);
    std::istringstream text(rows(kind));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line + '\n');
    std::shuffle(lines.begin(), lines.end(), std::mt19937(7));
    std::string shuffled;
    for (const std::string& line : lines) shuffled += line;
    const ProfileFile file{.name = "a.txt", .text = shuffled};
    refused(file, kind, "profile.file", "are out of order in the file: the line through them runs back and forth");
    refused(file, kind, "profile.file", "order them along the profile, from one end to the other");
}

TEST_CASE("a refusal names the file and the line, and not where the file lies", "[profile]") {
    refused({.name = "/home/me/a.csv", .text = "0 0\n1 x\n"}, rail, "profile.file", "a.csv, line 2, has \"x\"");
    refused({.name = "a.whl", .text = rows(rail)}, rail, "profile.file", "is the file of a wheel");
    refused({.name = "a.whl", .text = rows(wheel, -1, 1)}, wheel, "profile.file", "change mirror_y");
    refused({.name = "a.mpt", .text = "[FileInfo]\nMPD1=L 27.1 -43.5 27.3 -42.9\n"}, rail, "profile.file", "a.mpt");
    refused({.name = "a.csv", .text = "y;z\n"}, rail, "profile.file", "has 0 entries");
    refused({.name = "a.csv", .text = {}}, rail, "profile.file.text", "1 to 2097152 bytes");
    refused({.name = "a.csv", .text = std::string((2 << 20) + 1, ' ')}, rail, "profile.file.text", "2097152");
    refused({.name = "", .text = "0 0\n"}, rail, "profile.file.name", "is empty");
    refused({.name = "a", .text = "0 0\n", .unit = 0}, rail, "profile.file.unit", "is 0");
    refused({.name = "a", .text = "0 0\n", .shift_z = NAN}, rail, "profile.file.shift_z", "is nan");
    refused({.name = "a", .text = "0 0\n", .smoothing_length = -1}, rail, "profile.file.smoothing_length", "is -1");
    refused({.name = "a", .text = "0 0\n", .smoothing_order = 1}, rail, "profile.file.smoothing_order",
            "2 to penalize the curvature");
    refused({.name = "a", .text = "0 0\n", .smoothing_lambda = -1}, rail, "profile.file.smoothing_lambda", "is -1");
    refused({.name = "a", .text = "0 0\n", .smoothing_length = 5, .smoothing_lambda = 1}, rail,
            "profile.file.smoothing_lambda", "cannot be combined with smoothing_length");
    refused({.name = "a", .text = "0 0\n", .kinks = {.angle = 30}}, rail, "profile.file.kinks.angle", "in rad");
    refused({.name = "a", .text = "0 0\n", .kinks = {.width = -1}}, rail, "profile.file.kinks.width", "is -1");
}

TEST_CASE("the points of a file make the same curve in its place", "[profile]") {
    const ProfileSpec by_file{wheel, ProfileFile{.name = "a.txt",
                                                 .text = rows(wheel, -1 / 25.4, -1 / 25.4),
                                                 .unit = 25.4,
                                                 .mirror_y = true,
                                                 .shift_y = 1.5,
                                                 .smoothing_length = 4}};
    const ProfileSpec by_points = with_points(by_file);
    REQUIRE(std::holds_alternative<ProfilePoints>(by_points.shape));
    CHECK(make_profile(by_points).curve.points() == make_profile(by_file).curve.points());
    CHECK(with_points(by_points) == by_points);
    const ProfileFile by_lambda{.name = "a.txt", .text = rows(wheel), .smoothing_lambda = 1};
    CHECK_THROWS_MATCHES(with_points({wheel, by_lambda}), InvalidArgument,
                         MessageMatches(ContainsSubstring("remove them and use smoothing_length")));
}

TEST_CASE("smoothing tells its cut-off, and keeps kinks by the rule that is given", "[profile]") {
    // Creates a roof of 45 degrees on both sides, with points at 0.1 mm and no other turn near its ridge.
    std::string roof;
    for (int i = -200; i <= 200; ++i) roof += std::to_string(0.1 * i) + " " + std::to_string(0.1 * std::abs(i)) + "\n";
    ProfileFile file{.name = "roof.txt", .text = roof, .mirror_z = false};
    const auto ridge = [&] { return make_profile({rail, file}).curve; };
    const auto evidence = [&] { return make_profile({rail, file}).evidence; };
    CHECK(evidence().cut_off == 0);
    const int order = GENERATE(0, 2, 3);
    CAPTURE(order);
    if (order == 0) {
        file.smoothing_lambda = 10;
    } else {
        file.smoothing_length = 5;
        file.smoothing_order = order;
    }
    const double spacing = 0.1 * std::sqrt(2);
    CHECK_THAT(evidence().cut_off,
               WithinAbs(order == 0 ? 2 * std::numbers::pi * std::pow(10 * spacing, 0.25) : 5, 1e-9));
    CHECK(evidence().kinks == std::vector<double>{0});
    CHECK_THAT(ridge().at(ridge().s_at_y(0)).z, WithinAbs(0, 1e-3));
    CHECK(evidence().largest_distance < 1e-3);
    file.kinks.angle = 2;  // larger than the turn of 90 degrees
    CHECK(evidence().kinks.empty());
    CHECK(ridge().at(ridge().s_at_y(0)).z > 0.1);
    CHECK(evidence().largest_distance > 0.1);
}

TEST_CASE("points that scatter are told of, with a smoothing length that suits them", "[profile]") {
    std::mt19937 random(7);
    std::normal_distribution<double> error(0, 3e-3);
    const ProfileCurve curve = exact(rail);
    const auto warned = [&](double spacing, double scatter, double smoothing) {
        std::ostringstream text;
        text.precision(12);
        for (double s = 0; s < curve.end(); s += spacing) {
            const double by = scatter * error(random), angle = curve.angle(s);
            text << curve.at(s).y - std::sin(angle) * by << ' ' << curve.at(s).z + std::cos(angle) * by << '\n';
        }
        const ProfileFile file{.name = "a.txt", .text = text.str(), .smoothing_length = smoothing};
        std::string all;
        for (const std::string& warning : make_profile({rail, file}).evidence.warnings) all += warning;
        return all;
    };
    CHECK_THAT(warned(0.2, 1, 0), ContainsSubstring("points of the rail scatter by about") &&
                                      ContainsSubstring("smoothing_length of about 4 mm"));
    CHECK(warned(0.2, 1, 4) == "");
    CHECK(warned(0.2, 0, 0) == "");
    CHECK(warned(2, 1, 0) == "");  // too far apart for that
}

TEST_CASE("evidence tells how dense and how rounded points are, and where they are broken", "[profile]") {
    std::string roof = "-20 10\n";
    for (int y = -10; y <= 10; ++y) roof += std::to_string(y) + " " + std::to_string(std::abs(y)) + "\n";
    roof += "20 10\n";
    const ProfileEvidence found =
        make_profile({rail, ProfileFile{.name = "a", .text = roof, .mirror_z = false}}).evidence;
    CHECK(found.points_given == 23);
    CHECK(found.points_kept == 23);
    CHECK(found.rounded_to == 1);
    CHECK_THAT(found.spacing, WithinAbs((20 * std::sqrt(2) + 20) / 22, 1e-12));
    CHECK(std::ranges::count(found.kinks, 0.0) == 1);
}

TEST_CASE("a heading states the unit of the points below it", "[profile]") {
    const auto kind = GENERATE(ProfileKind::wheel, ProfileKind::rail);
    const auto& [heading, unit] =
        GENERATE(table<std::string, double>({{"# unit: m", 1e3},
                                             {"y [m]; z [m]", 1e3},
                                             {"Units are inches", 25.4},
                                             {"\"Y (inch)\",\"Z (inch)\"", 25.4},
                                             {"% points in metres", 1e3},
                                             {"! unit of length = um", 1e-3},
                                             {"# y [\xc2\xb5m]", 1e-3},
                                             {"y [cm] z [cm]", 10},
                                             {"# y [mm], z in mm", 1},
                                             {"# measured on (M) street, in the morning", 1}}));
    CAPTURE(heading);
    ProfileFile file{"points.csv", heading + "\n" + rows(kind, 1 / unit, 1 / unit)};
    is_exact(file, kind);
    CHECK(reading_of(file, kind).unit == unit);
    file.text = heading + "\n" + rows(kind);
    file.unit = 1;  // whatever it says
    is_exact(file, kind);
}

TEST_CASE("headings with two units, or with one that makes no profile, are refused", "[profile]") {
    refused({"rail.csv", "y [mm]; z [um]\n" + rows(ProfileKind::rail, 1, 1000)}, ProfileKind::rail, "profile.file",
            "states two units above its points, \"mm\" and \"um\"");
    refused({"rail.csv", "# unit: m\n" + rows(ProfileKind::rail)}, ProfileKind::rail, "profile.file",
            "by the unit of their heading: give unit");
}
