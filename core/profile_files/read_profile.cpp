#include "contactd/read_profile.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "points_upwards.hpp"
#include "profile_lines.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using geometry::FilePoints;

constexpr double narrowest_wheel = 25, narrowest_rail = 12, widest = 500;  // mm: larger values have another unit

/// Returns the extension of a file's name, in small letters.
std::string ending_of(const std::string& name) {
    const auto dot = name.rfind('.');
    std::string ending = dot == name.npos ? "" : name.substr(dot + 1);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

void check_kind(const std::string& name, ProfileKind of_file, std::optional<ProfileKind> kind) {
    if (kind && *kind != of_file)
        throw InvalidArgument(name, "is the file of a " + std::string(name_of(of_file)) + ", but a " +
                                        std::string(name_of(*kind)) +
                                        " is requested; give another file, or change the kind");
}

struct FileOfKind {
    ProfileKind kind;
    ProfileFormat format;
    FilePoints found;
};

FileOfKind read(std::string_view text, const std::string& name, std::optional<ProfileKind> kind) {
    if (text.size() > most_profile_bytes)
        throw InvalidArgument(name,
                              "has " + std::to_string(text.size()) + " bytes; a profile file may have at most 16 MiB");
    const std::string ending = ending_of(name);
    const bool simpack = ending == "prr" || ending == "prw", miniprof = ending == "ban" || ending == "whl";
    if (simpack || miniprof) {
        const auto of_file = ending == "prw" || ending == "whl" ? ProfileKind::wheel : ProfileKind::rail;
        check_kind(name, of_file, kind);
        if (simpack) return {of_file, ProfileFormat::simpack, geometry::read_simpack(text, name, of_file)};
        return {of_file, ProfileFormat::miniprof, geometry::read_miniprof(text, name)};
    }
    if (!kind)
        throw InvalidArgument(name,
                              "has an extension that does not determine the kind, wheel or rail (.prw, .prr, .whl and "
                              ".ban do); give the kind");
    return {*kind, ProfileFormat::columns, geometry::read_columns(text, name)};
}

/// Returns the text after the last separator of folders, without unprintable characters.
std::string shown_name(const std::string& name) {
    std::string shown = name.substr(name.find_last_of("/\\") + 1);
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < ' ') c = '?';
    return shown.size() > 100 ? shown.substr(0, 60) + "..." + shown.substr(shown.size() - 30) : shown;
}

/// A wheel in inches would be narrower than any wheel in mm, and so on. A unit stated by the file takes precedence.
void check_width(const std::vector<ProfilePoint>& points, double unit, ProfileKind kind, bool heading_says_unit) {
    const auto [left, right] = std::ranges::minmax(points, {}, &ProfilePoint::y);
    const double width = (right.y - left.y) * unit;
    const bool is_wheel = kind == ProfileKind::wheel;
    if (!(width < (is_wheel ? narrowest_wheel : narrowest_rail) || width > widest)) return;
    throw InvalidArgument(
        "points", "span " + short_text(width) + " laterally, but " +
                      (is_wheel ? "130 mm are usual for a wheel" : "70 mm are usual for a rail") +
                      (heading_says_unit ? ", by the unit of their heading: " : ", and the unit is not given: ") +
                      "give unit, 25.4 for inches, 1000 for metres, or 1 if this width is correct");
}

/// Refuses points without an order, which turning z would not correct. Profiles that double back, such as the face of a
/// flange, are below this limit.
void check_order(const std::vector<ProfilePoint>& points, double unit) {
    constexpr double most = 3;  // times the width
    const auto [left, right] = std::ranges::minmax(points, {}, &ProfilePoint::y);
    double run = 0;
    for (std::size_t i = 1; i < points.size(); ++i) run += std::abs(points[i].y - points[i - 1].y);
    if (run <= most * (right.y - left.y)) return;
    throw InvalidArgument("points", "are out of order in the file: the line through them runs back and forth, " +
                                        short_text(run * unit) + " mm across a profile that is " +
                                        short_text((right.y - left.y) * unit) +
                                        " mm wide; order them along the profile, from one end to the other");
}

/// Which way z points where the file does not say it.
bool mirrored_by_shape(const std::vector<ProfilePoint>& points, double unit, ProfileKind kind) {
    std::vector<ProfilePoint> in_mm = points;
    for (ProfilePoint& point : in_mm) point = {point.y * unit, point.z * unit};
    const std::optional<bool> upwards = geometry::points_upwards(in_mm, kind);
    if (!upwards)
        throw InvalidArgument(
            "points", std::string("do not determine the direction of z: ") +
                          (kind == ProfileKind::wheel ? "there is no flange at one end"
                                                      : "their ends turn down for neither or both directions of z") +
                          "; give mirror_z, true if z points upwards, false if it points downwards");
    return *upwards;
}

PointsOfFile points_of_content(const ProfileFile& file, const std::string& name, ProfileKind kind) {
    FileOfKind read_file = read(file.text, name, kind);
    FilePoints& found = read_file.found;
    std::vector<ProfilePoint>& points = found.points.points;
    PointsOfFile result;
    ProfileReading& reading = result.reading;
    reading.format = read_file.format;
    reading.unit = file.unit.value_or(found.points.unit);
    reading.mirror_y = found.points.mirror_y != file.mirror_y;
    reading.lines_left_out = found.lines_left_out;
    if (points.size() < 2)
        throw InvalidArgument("points",
                              "has " + std::to_string(points.size()) +
                                  " entries; a profile needs at least two points, and a measured one about fifty");
    if (!file.unit && !found.says_unit) check_width(points, reading.unit, kind, found.heading_says_unit);
    if (file.mirror_z || found.says_mirror_z) {
        reading.mirror_z = found.points.mirror_z != file.mirror_z.value_or(false);
        reading.oriented_by = file.mirror_z ? OrientedBy::request : OrientedBy::file;
    } else {
        check_order(points, reading.unit);
        reading.mirror_z = mirrored_by_shape(points, reading.unit, kind);
        reading.oriented_by = OrientedBy::shape;
    }
    result.rounded_to = reading.unit * geometry::rounding_of(points);
    const double along_y = reading.mirror_y ? -reading.unit : reading.unit,
                 along_z = reading.mirror_z ? -reading.unit : reading.unit;
    for (ProfilePoint& point : points) {
        point.y *= along_y;
        point.z *= along_z;
        if (file.shift_y != 0) point.y += file.shift_y;
        if (file.shift_z != 0) point.z += file.shift_z;
    }
    if (kind == ProfileKind::rail && reading.oriented_by != OrientedBy::shape &&
        geometry::points_upwards(points, kind).value_or(false))
        result.warnings.push_back(
            "The rail seems to be upside down with the mirror_z of the request or the file: an end of its points lies "
            "above its neighbours. Unless it is a grooved rail, change mirror_z.");
    result.points.points = std::move(points);
    result.points.smoothing_length = file.smoothing_length;
    return result;
}

}  // namespace

ProfileSpec read_profile(std::string_view text, const std::string& name, std::optional<ProfileKind> kind) {
    FileOfKind file = read(text, name, kind);
    ProfilePoints& points = file.found.points;
    if (!file.found.says_mirror_z)
        points.mirror_z =
            geometry::points_upwards(points.points, file.kind).value_or(file.format == ProfileFormat::miniprof);
    return {file.kind, std::move(points)};
}

ProfileSpec read_profile(const std::filesystem::path& file, std::optional<ProfileKind> kind) {
    return read_profile(std::string_view(text_of_profile(file)), file.filename().string(), kind);
}

std::string text_of_profile(const std::filesystem::path& file) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(file, error);
    if (error) throw InvalidArgument(file.string(), "cannot be read: " + error.message() + ". Check its path");
    if (bytes > most_profile_bytes)
        throw InvalidArgument(file.filename().string(),
                              "has " + std::to_string(bytes) + " bytes; a profile file may have at most 16 MiB");
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw InvalidArgument(file.string(), "cannot be read; check its permissions");
    return text;
}

PointsOfFile points_of(const ProfileFile& file, ProfileKind kind) {
    validate(ProfileSpec{kind, file});
    return naming_file(file, [&] { return points_of_content(file, shown_name(file.name), kind); });
}

ProfileSpec with_points(const ProfileSpec& profile) {
    const auto* file = std::get_if<ProfileFile>(&profile.shape);
    if (file == nullptr) return profile;
    if (file->smoothing_order != 2 || file->smoothing_lambda != 0 || file->kinks != KinkRule{})
        throw InvalidArgument("profile.file",
                              "has smoothing_order, smoothing_lambda or kinks, which profiles by points do not "
                              "support; remove them and use smoothing_length");
    return {profile.kind, points_of(*file, profile.kind).points};
}

std::string problem_of_file(const ProfileFile& file, const InvalidArgument& error) {
    const std::string name = shown_name(file.name);
    std::string_view field = error.field();
    if (field.starts_with("profile.")) field.remove_prefix(std::string_view("profile.").size());
    const bool says_name = field.starts_with(name);
    return "cannot be used: " + (says_name ? "" : name + ": its ") + std::string(field) + " " + error.problem();
}

}  // namespace contactd
