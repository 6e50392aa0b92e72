// Tests profiles from files: the formats, and damaged files.
#include "contactd/read_profile.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;

namespace {

const ProfilePoints& points_of(const ProfileSpec& spec) {
    return std::get<ProfilePoints>(spec.shape);
}

std::string simpack(const std::string& keys, const std::string& points, int type = 1) {
    return "! a comment\n header.begin\n version = 1\n type = " + std::to_string(type) +
           "  ! wheel\n header.end\n spline.begin\n approx.smooth = 0.0\n file = '-'\n comment = 'none = at all'\n" +
           keys + " units.len = 'mm'\n point.begin\n ! y z\n" + points + " point.end\n spline.end\n";
}

/// Creates S1002 and 60E1 in the four formats of files.
std::string file_text(const std::string& ending) {
    const bool wheel = ending == "prw" || ending == "whl" || ending == "txt";
    const Profile profile = make_profile(wheel ? ProfileSpec{ProfileKind::wheel, S1002{}}
                                               : ProfileSpec{ProfileKind::rail, Rail60E1{0.025}});
    std::ostringstream points;
    points.precision(9);
    const bool upwards = ending == "whl" || ending == "ban";
    for (double s = 0; s < profile.curve.end(); s += 0.7) {
        const auto at = profile.curve.at(s);
        points << at.y << ' ' << (upwards ? -at.z : at.z) << (upwards ? " 0.1 0.2\n" : "\n");
    }
    if (upwards) return "ProgramName=MINIPROF\nDate=01-02-2020\nColumnDef=X,Y,A,C\nXYPoints=5\n\n" + points.str();
    if (ending == "txt") return "# y z\n" + points.str();
    return simpack(" units.len.f = 1000.\n", points.str(), wheel);
}

void refused(const std::string& text, const std::string& name, const std::string& what) {
    CHECK_THROWS_MATCHES(read_profile(std::string_view(text), name, ProfileKind::wheel), InvalidArgument,
                         MessageMatches(ContainsSubstring(what)));
}

}  // namespace

TEST_CASE("each format gives the profile that was written", "[profile]") {
    const std::string ending = GENERATE("prw", "prr", "whl", "ban", "txt");
    const auto kind = ending == "txt" ? std::optional(ProfileKind::wheel) : std::nullopt;
    const auto spec = read_profile(std::string_view(file_text(ending)), "profile." + ending, kind);
    const Profile made = make_profile(spec);
    const ProfileCurve exact =
        make_profile(made.kind == ProfileKind::wheel ? ProfileSpec{ProfileKind::wheel, S1002{}}
                                                     : ProfileSpec{ProfileKind::rail, Rail60E1{0.025}})
            .curve;
    CHECK(made.kind == (ending == "prr" || ending == "ban" ? ProfileKind::rail : ProfileKind::wheel));
    for (const double y : {-25.0, -3.0, 10.0, 20.0})
        CHECK_THAT(made.curve.at(made.curve.s_at_y(y)).z, WithinAbs(exact.at(exact.s_at_y(y)).z, 2e-4));
}

TEST_CASE("what a file of Simpack says is done with its points", "[profile]") {
    const std::string keys =
        " shift.y = 1\n shift.z = -2\n rotate = 90\n units.ang.f = 57.29577951308232\n units.len.f = 1\n"
        " bound.y.min = -10\n bound.y.max = 10\n mirror.y = 1\n mirror.z = 0\n inversion = 1\n";
    const auto spec = read_profile(std::string_view(simpack(keys, "3 4\n5 6 1.0\n7 99\n")), "wheel.PRW");
    const auto& given = points_of(spec);
    REQUIRE(given.points.size() == 2);  // the third is beyond the bounds
    CHECK_THAT(given.points[0].y, WithinAbs(-2, 1e-12));
    CHECK_THAT(given.points[0].z, WithinAbs(4, 1e-12));
    CHECK(given.unit == 1000);
    CHECK(given.mirror_y);
    CHECK_FALSE(given.mirror_z);
}

TEST_CASE("the columns of MiniProf have names", "[profile]") {
    const auto text = "Rail=left\r\nColumnDef=N,Y,X\r\n\r\n1 2 3\r\n2 5 6\r\n";
    CHECK(points_of(read_profile(std::string_view(text), "a.ban")).points == std::vector<ProfilePoint>{{3, 2}, {6, 5}});
    CHECK(points_of(read_profile(std::string_view(text), "a.ban")).mirror_z);
}

TEST_CASE("columns take what separates them in practice", "[profile]") {
    const auto text = "\xef\xbb\xbf# y, z\n1 2\n 3,4 % comment\n5;\t6\n+7 , -8e0\n\n";
    CHECK(points_of(read_profile(std::string_view(text), "a.csv", ProfileKind::rail)).points ==
          std::vector<ProfilePoint>{{1, 2}, {3, 4}, {5, 6}, {7, -8}});
}

TEST_CASE("columns of tables are taken with their headings, quotation marks and decimal commas", "[profile]") {
    const auto points = [](const std::string& text) {
        return points_of(read_profile(std::string_view(text), "a.csv", ProfileKind::rail)).points;
    };
    const std::vector<ProfilePoint> expected{{-30, 1.5}, {0, 0}, {30, 1.5}};
    CHECK(points("y;z\n-30;1,5\n0;0\n30;1,5\n") == expected);
    CHECK(points("Y [mm]\tZ [mm]\r\n-30\t1,5\r\n0\t0\r\n30\t1,5\r\n") == expected);
    CHECK(points("-30,0 1,5\n0,0 0,0\n30,0 1,5\n") == expected);
    CHECK(points("\"y\",\"z\"\n-30,1.5\n0,0\n30,1.5\n") == expected);
    CHECK(points("\"-30\",\"1.5\"\n\"0\",\"0\"\n\"30\",\"1.5\"\n") == expected);
    CHECK(points("-3.0d1 .15D+1 \"a remark\n0 0\n30 1.5\n") == expected);
    CHECK(points("-30, 1,5\n0, 0\n30, 1,5\n") == expected);
}

TEST_CASE("heads of MiniProf of all years are read", "[profile]") {
    const std::string points = "-30 -3\n0 0\n30 -3\n";
    const auto read = [](const std::string& text) { return points_of(read_profile(std::string_view(text), "a.ban")); };
    const std::vector<ProfilePoint> expected{{-30, -3}, {0, 0}, {30, -3}};
    CHECK(read("#MINIPROF\na.ban\nStock.......:\n32.5 37.1 14.7\n(Sd/Sh/qR)\n\n" + points).points == expected);
    CHECK(read("Stock=%Talent\nTilt=\nXOffset=\nXYPoints=3\n\"ColumnDef=Y,X\n\n" + points).points == expected);
    CHECK(read("Date=1/2/2020\n" + points).points == expected);
    CHECK(read("ColumnDef=X,Y,A\n\n-30,0 -3,0 0,1\n0,0 0,0 0,1 left\n30,0 -3,0 0,1\n").points == expected);
    CHECK(read("Date=1/2/2020\n\n-30; -3,0\n0; 0\n30; -3,0\n").points == expected);
    CHECK(read("\n-30, -3\n0, 0\n30, -3\n").points == expected);
    CHECK(read("Date=1/2/2020\n\n-30 -3 % dent\n\"5 5\n0 0\n30 -3 added by hand\n").points == expected);
    CHECK(read("Xoffset=1\nYOffset=-2\n\n-31 -1\n-1 2\n29 -1\n").points == expected);
}

TEST_CASE("which way z points is seen by the shape, where the file does not say it", "[profile]") {
    const std::string ending = GENERATE("whl", "ban", "txt");
    const auto kind = ending == "ban" ? ProfileKind::rail : ProfileKind::wheel;
    std::string text = file_text(ending), image;
    const std::size_t points = text.find("\n\n") == text.npos ? text.find('\n') + 1 : text.find("\n\n") + 2;
    std::istringstream lines(text.substr(points));
    image = text.substr(0, points);
    for (double y, z; lines >> y >> z; lines.ignore(1000, '\n'))
        image += std::to_string(y) + " " + std::to_string(-z) + "\n";
    if (ending != "txt") image.replace(image.find("X,Y,A,C"), 7, "X,Y");
    const auto as_written = read_profile(std::string_view(text), "a." + ending, kind);
    const auto upside_down = read_profile(std::string_view(image), "a." + ending, kind);
    CHECK(points_of(as_written).mirror_z != points_of(upside_down).mirror_z);
    const ProfileCurve one = make_profile(as_written).curve, other = make_profile(upside_down).curve;
    for (const double y : {-25.0, -3.0, 10.0, 20.0})
        CHECK_THAT(one.at(one.s_at_y(y)).z, WithinAbs(other.at(other.s_at_y(y)).z, 1e-4));
}

TEST_CASE("a wheel that was measured from the tip of its flange to its chamfer is the right way up", "[profile]") {
    const double sign = GENERATE(1.0, -1.0), face = GENERATE(0.0, 20.0, 60.0);
    std::ostringstream text;
    if (face > 0) text << "-60.1 " << -sign * face << "\n-60 " << sign * 5 << '\n';
    for (const auto& [y, z] : std::vector<std::pair<double, double>>{{-55, 28},
                                                                     {-50, 26},
                                                                     {-44, 18},
                                                                     {-40, 12},
                                                                     {-36, 7},
                                                                     {-30, 3.6},
                                                                     {-24, 2},
                                                                     {-18, 1},
                                                                     {-12, .6},
                                                                     {-6, .3},
                                                                     {0, 0},
                                                                     {10, -.3},
                                                                     {20, -.6},
                                                                     {30, -.9},
                                                                     {40, -1.2},
                                                                     {50, -1.5},
                                                                     {56, -1.6},
                                                                     {59, 2},
                                                                     {60, 5}})
        text << y << ' ' << sign * z << '\n';
    const auto spec = read_profile(std::string_view(text.str()), "a.txt", ProfileKind::wheel);
    CHECK(points_of(spec).mirror_z == (sign < 0));
    const ProfileCurve curve = make_profile(spec).curve;
    CHECK(std::ranges::max(curve.points(), {}, &ProfilePoint::z).z > 25);
    ProfileSpec image = spec;
    std::get<ProfilePoints>(image.shape).mirror_z = sign > 0;
    CHECK_THROWS_MATCHES(make_profile(image), InvalidArgument, MessageMatches(ContainsSubstring("change mirror_z")));
}

TEST_CASE("Simpack's files have comments of both kinds, and end where their spline does", "[profile]") {
    const auto spec = read_profile(
        std::string_view("% a rail\nspline.begin\n units.len.f = 1000. ! mm\n point.begin\n -30 3 % left\n 0 0\n 30 3\n"
                         "point.end\nspline.end\nwritten by somebody\n"),
        "a.prr");
    CHECK(points_of(spec).points == std::vector<ProfilePoint>{{-30, 3}, {0, 0}, {30, 3}});
}

TEST_CASE("what is wrong with a file is said with its line", "[profile]") {
    refused("1 2\n3 x\n", "a.txt", "a.txt, line 2, has \"x\" instead of a number");
    refused("1 2\n3 nan\n", "a.txt", "a.txt, line 2, has \"nan\"");
    refused("1 1e400\n", "a.txt", "a.txt, line 1, has \"1e400\"");
    refused("1,5,2,5\n", "a.txt", "a.txt, line 1, has 4 numbers, but a point has two");
    refused("1 2\ny z\n", "a.txt", "a.txt, line 2, has \"y\" instead of a number");
    refused("\"1\",\"x\"\n1 2\n", "a.txt", "a.txt, line 1, has");
    refused("1.234,5 1.234,5\n", "a.txt", "a.txt, line 1, has 4 numbers");
    refused("1 \xff\x01\n", "a.txt", "has \"??\" instead");
    refused(std::string("1 2\n\0\n", 6), "a.txt", "a.txt is not a text file");
    refused(std::string(5000, '1'), "a.txt", "a.txt, line 1, has 5000 characters");
    refused(std::string(most_profile_bytes + 1, '\n'), "a.txt", "at most 16 MiB");
    std::string many;
    for (std::size_t i = 0; i <= most_profile_points; ++i) many += "1 2\n";
    refused(many, "a.txt", "line 20001, exceeds the limit of 20000");
    refused("1 2\n", "a.prr", "a.prr is the file of a rail, but a wheel is requested");
    refused(simpack("", "1 2\n", 0), "a.prw", "a.prw, line 4, has the type \"0\", but the file's name means wheel");
    refused(simpack("", "1\n"), "a.prw", "has 1 numbers; a point has two, y and z");
    refused(simpack(" units.len.f = 0\n", "1 2\n"), "a.prw", "must be the positive number");
    refused(simpack(" shift.y = one\n", "1 2\n"), "a.prw", "a.prw, line 10, has \"one\"");
    refused(simpack(" bound.y.min = 5\n bound.y.max = 6\n", "1 2\n"), "a.prw", "no points within its bounds");
    refused("header.begin\n", "a.prw", "has no line point.begin");
    refused("spline.begin\npoint.begin\n1 2\n", "a.prw", "ends within its points");
    refused("point.begin\npoint.end\npoint.begin\n", "a.prw", "line 3, begins a second list of points");
    refused("PK\x03\x04\n", "a.prw", "outside point.begin and point.end");
    refused("ColumnDef=A,Y\n1 2\n", "a.whl", "a.whl, line 1, has the columns \"A,Y\"; X and Y must be among them");
    refused("ColumnDef=X,Y,A\n1 2\n", "a.whl", "a.whl, line 2, has 2 numbers; it must have 3");
    refused("1 2\nXYPoints=1\n", "a.whl", "after points");
    refused("Date=1\n\n1,2,,3\n", "a.whl", "a.whl, line 3, has \"\" instead of a number");
    CHECK_THROWS_MATCHES(read_profile(std::string_view("1 2"), "a.txt"), InvalidArgument,
                         MessageMatches(ContainsSubstring("give the kind")));
    CHECK_THROWS_MATCHES(read_profile(std::filesystem::path("/nowhere/a.prw")), InvalidArgument,
                         MessageMatches(ContainsSubstring("/nowhere/a.prw cannot be read: No such file")));
    CHECK_THROWS_MATCHES(read_profile(std::filesystem::path("/tmp")), InvalidArgument,
                         MessageMatches(ContainsSubstring("/tmp cannot be read")));
}

TEST_CASE("a file without points is left to what makes a profile", "[profile]") {
    const auto spec = read_profile(std::string_view("# nothing\n"), "a.txt", ProfileKind::wheel);
    CHECK_THROWS_MATCHES(make_profile(spec), InvalidArgument,
                         MessageMatches(ContainsSubstring("points has 0 entries")));
}

TEST_CASE("damaged files neither crash nor hang, and are refused by a sentence or make a curve", "[profile]") {
    std::mt19937 dice(5);
    int refusals = 0, made = 0;
    for (const std::string ending : {"prw", "prr", "whl", "ban", "txt"}) {
        const std::string whole = file_text(ending);
        for (int round = 0; round < 300; ++round) {
            std::string text = whole.substr(0, dice() % 3 ? whole.size() : dice() % whole.size());
            for (auto damage = dice() % 6; damage-- > 0 && !text.empty();) {
                const std::size_t at = dice() % text.size(),
                                  length = std::min<std::size_t>(dice() % 200, text.size() - at);
                switch (dice() % 4) {
                    case 0:
                        text[at] = static_cast<char>(dice() % 256);
                        break;
                    case 1:
                        text.erase(at, length);
                        break;
                    case 2:
                        text.insert(at, text.substr(at, length));
                        break;
                    default:
                        text[at] = "0123456789-.e\n "[dice() % 15];
                }
            }
            try {
                const auto spec = read_profile(std::string_view(text), "damaged." + ending,
                                               ending == "txt" ? std::optional(ProfileKind::wheel) : std::nullopt);
                const double end = make_profile(spec).curve.end();
                REQUIRE(std::isfinite(end));
                ++made;
            } catch (const InvalidArgument& refusal) {
                ++refusals;
                const bool named = refusal.field().starts_with("damaged.") || refusal.field().starts_with("profile.");
                REQUIRE(named);
                for (const char c : std::string(refusal.what())) REQUIRE((c >= ' ' && c <= '~'));
            }
        }
    }
    CHECK(refusals > 100);
    CHECK(made > 100);
}
