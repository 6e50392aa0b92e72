#include "codec_profile.hpp"

#include <span>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/fields/profile_spec.hpp"
#include "contactd/proto/field_codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

void check_ends(const json& curve, const std::string& field) {
    if (!curve.contains("ends")) return;
    const json& ends = curve["ends"];
    if (!(ends[1].get<double>() >= ends[0].get<double>() + 1))
        throw invalid_field(field + ".ends",
                            "are " + ends.dump() + "; the second must be at least 1 mm above the first");
}

}  // namespace

json encode_pairs(const std::vector<ProfilePoint>& points, ArrayWriter& arrays) {
    std::vector<double> flat;
    for (const ProfilePoint& point : points) flat.insert(flat.end(), {point.y, point.z});
    return arrays.write(std::span<const double>(flat), {points.size(), 2});
}

std::vector<ProfilePoint> decode_pairs(const json& source, const Frames& frames, const std::string& field) {
    const std::vector<std::size_t> shape = claimed_shape(source, 2);
    if (shape.size() != 2 || shape[1] != 2)
        throw invalid_field(field, "has shape " + json(shape).dump() + "; it must be [n,2], of y and z",
                            reason::array_invalid);
    if (shape[0] > most_profile_points)
        throw invalid_field(field,
                            "has " + std::to_string(shape[0]) + " entries, but at most " +
                                std::to_string(most_profile_points) + " are allowed; omit some of them",
                            reason::limit_exceeded);
    const std::vector<double> flat = read_array(source, frames, shape, field);
    std::vector<ProfilePoint> points;
    for (std::size_t i = 0; i < shape[0]; ++i) points.push_back({flat[2 * i], flat[2 * i + 1]});
    return points;
}

json encode_profile(const ProfileSpec& profile, ArrayWriter& arrays) {
    return write_object(type_of<ProfileSpec>(), &profile, MemberPath("profile"), {&arrays});
}

// Parameters that are omitted have the defaults of the new shape, not the values of the current one. A formula has no
// settings of points.
void decode_profile(const json& source, ProfileSpec& profile, const Frames& frames, const std::string& field) {
    profile.shape = {};
    for (const char* curve : {"arc", "cone"})
        if (source.contains(curve)) check_ends(source[curve], field + "." + curve);
    const auto read = [&](const json& shape) {
        read_object(shape, type_of<ProfileSpec>(), &profile, MemberPath(field), {frames});
    };
    if (source.contains("points")) return read(source);
    json formula = source;
    for (const char* of_points : {"unit", "mirror_y", "mirror_z", "smoothing_length"}) formula.erase(of_points);
    read(formula);
}

}  // namespace contactd::proto
