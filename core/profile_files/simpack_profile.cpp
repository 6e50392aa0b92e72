// Reads Simpack's files: keys with values in sections, and the points in the unit of a user. Keys also define
// operations on the points, in the order shift, rotation, bounds, mirroring, units.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "profile_lines.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

/// Lists the used keys; keys that describe how a file was made, and how splines are fitted, are ignored.
using Keys = std::map<std::string, double, std::less<>>;

const Keys defaults{{"shift.y", 0},     {"shift.z", 0},     {"rotate", 0},      {"bound.y.min", 1},
                    {"bound.y.max", 0}, {"bound.z.min", 1}, {"bound.z.max", 0}, {"mirror.y", 0},
                    {"mirror.z", 0},    {"units.len.f", 1}, {"units.ang.f", 1}};

/// Returns whether the key of the line affects the profile.
bool read_key(const ProfileLines& lines, bool in_header, ProfileKind kind, Keys& keys) {
    const auto at = lines.line().find('=');
    if (at == std::string_view::npos)
        lines.fail("is " + quoted(lines.line()) +
                   "; a line outside point.begin and point.end must have the form key = value");
    const std::string_view key = trimmed(lines.line().substr(0, at)), value = trimmed(lines.line().substr(at + 1));
    if (in_header && key == "type") {
        const bool wheel = kind == ProfileKind::wheel;
        if (lines.number(value) != (wheel ? 1 : 0))
            lines.fail("has the type " + quoted(value) + ", but the file's name means " +
                       (wheel ? "wheel, type 1; name a rail's file .prr" : "rail, type 0; name a wheel's file .prw"));
    } else if (const auto known = keys.find(key); !in_header && known != keys.end()) {
        known->second = lines.number(value);
        if (key.starts_with("units.") && !(known->second > 0))
            lines.fail("has the unit " + quoted(value) +
                       "; it must be the positive number of units in a metre or radian");
    } else {
        return false;
    }
    return true;
}

std::vector<ProfilePoint> read_points(ProfileLines& lines) {
    std::vector<ProfilePoint> points;
    while (lines.next()) {
        if (lines.line() == "point.end") return points;
        const auto values = lines.numbers();
        if (values.size() != 2 && values.size() != 3)
            lines.fail("has " + std::to_string(values.size()) +
                       " numbers; a point has two, y and z, and optionally its weight");
        add_point(points, {values[0], values[1]}, lines);
    }
    lines.fail_file("ends within its points; it must end with point.end and may be truncated");
}

std::vector<ProfilePoint> processed(const std::vector<ProfilePoint>& read, const Keys& keys) {
    const auto of = [&](std::string_view key) { return keys.find(key)->second; };
    const double angle = of("rotate") / of("units.ang.f");
    const auto within = [&](double value, std::string_view least, std::string_view most) {
        return of(least) >= of(most) || (value >= of(least) && value <= of(most));
    };
    std::vector<ProfilePoint> points;
    for (const auto& [y, z] : read) {
        const ProfilePoint shifted{y + of("shift.y"), z + of("shift.z")};
        const ProfilePoint rotated{std::cos(angle) * shifted.y - std::sin(angle) * shifted.z,
                                   std::sin(angle) * shifted.y + std::cos(angle) * shifted.z};
        if (within(rotated.y, "bound.y.min", "bound.y.max") && within(rotated.z, "bound.z.min", "bound.z.max"))
            points.push_back(rotated);
    }
    return points;
}

}  // namespace

FilePoints read_simpack(std::string_view text, const std::string& name, ProfileKind kind) {
    ProfileLines lines(text, name, "!%");
    Keys keys = defaults;
    std::vector<ProfilePoint> read;
    FilePoints found;
    bool in_header = false, has_points = false;
    while (lines.next()) {
        const auto line = lines.line();
        if (line == "header.begin" || line == "header.end")
            in_header = line == "header.begin";
        else if (line == "point.begin") {
            if (has_points) lines.fail("begins a second list of points; a file must contain one profile: split it");
            has_points = true;
            read = read_points(lines);
        } else if (line == "spline.end")
            break;
        else if (line != "spline.begin" && !read_key(lines, in_header, kind, keys))
            ++found.lines_left_out;
        if (!in_header && line.starts_with("units.len.f")) found.says_unit = true;
    }
    if (!has_points) lines.fail_file("has no line point.begin, which must precede the points of a Simpack profile");
    ProfilePoints& given = found.points;
    given.points = processed(read, keys);
    if (given.points.empty() && !read.empty())
        lines.fail_file("has no points within its bounds, bound.y.min to bound.z.max; widen them");
    given.unit = 1000 / keys["units.len.f"];
    given.mirror_y = keys["mirror.y"] == 1;
    given.mirror_z = keys["mirror.z"] == 1;
    found.says_mirror_z = true;
    return found;
}

}  // namespace contactd::geometry
