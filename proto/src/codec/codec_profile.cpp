#include "codec_profile.hpp"

#include <span>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/proto/object.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

json encode_ends(double from, double to) {
    return {finite(from, "An end of a profile"), finite(to, "An end of a profile")};
}

json encode(const S1002&, ArrayWriter&) {
    return {{"s1002", true}};
}

json encode(const Rail60E1& rail, ArrayWriter&) {
    return object({{"rail_60e1", object({{"inclination", finite(rail.inclination, "inclination")}})}});
}

json encode(const ArcProfile& arc, ArrayWriter&) {
    return object({{"arc", object({{"radius", finite(arc.radius, "radius")},
                                   {"slope", finite(arc.slope, "slope")},
                                   {"ends", encode_ends(arc.from, arc.to)}})}});
}

json encode(const ConeProfile& cone, ArrayWriter&) {
    return object(
        {{"cone", object({{"slope", finite(cone.slope, "slope")}, {"ends", encode_ends(cone.from, cone.to)}})}});
}

json encode(const ProfilePoints& points, ArrayWriter& arrays) {
    return object({{"points", encode_pairs(points.points, arrays)},
                   {"unit", finite(points.unit, "unit")},
                   {"mirror_y", points.mirror_y},
                   {"mirror_z", points.mirror_z},
                   {"smoothing_length", finite(points.smoothing_length, "smoothing_length")}});
}

/// Of an arc or a cone.
template <class Shape>
void decode_ends(const json& source, const std::string& field, Shape& shape) {
    shape.slope = source.value("slope", shape.slope);
    if (!source.contains("ends")) return;
    shape.from = source["ends"][0].get<double>();
    shape.to = source["ends"][1].get<double>();
    if (!(shape.to >= shape.from + 1))
        throw invalid_field(field + ".ends",
                            "are " + source["ends"].dump() + "; the second must be at least 1 mm above the first");
}

ProfilePoints decode_points(const json& source, const Frames& frames, const std::string& field) {
    ProfilePoints points;
    points.points = decode_pairs(source["points"], frames, field + ".points");
    points.unit = source.value("unit", points.unit);
    points.mirror_y = source.value("mirror_y", points.mirror_y);
    points.mirror_z = source.value("mirror_z", points.mirror_z);
    points.smoothing_length = source.value("smoothing_length", points.smoothing_length);
    return points;
}

ProfileShape decode_shape(const json& source, const Frames& frames, const std::string& field) {
    if (source.contains("s1002")) return S1002{};
    if (source.contains("rail_60e1")) return Rail60E1{source["rail_60e1"].value("inclination", 0.0)};
    if (source.contains("arc")) {
        ArcProfile arc{source["arc"]["radius"].get<double>()};
        decode_ends(source["arc"], field + ".arc", arc);
        return arc;
    }
    if (source.contains("cone")) {
        ConeProfile cone;
        decode_ends(source["cone"], field + ".cone", cone);
        return cone;
    }
    return decode_points(source, frames, field);
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
                            "are " + std::to_string(shape[0]) + "; " + std::to_string(most_profile_points) +
                                " are the most, leave some of them out",
                            reason::limit_exceeded);
    const std::vector<double> flat = read_array(source, frames, shape, field);
    std::vector<ProfilePoint> points;
    for (std::size_t i = 0; i < shape[0]; ++i) points.push_back({flat[2 * i], flat[2 * i + 1]});
    return points;
}

json encode_profile(const ProfileSpec& profile, ArrayWriter& arrays) {
    return std::visit([&](const auto& shape) { return encode(shape, arrays); }, profile.shape);
}

ProfileSpec decode_profile(const json& source, ProfileKind kind, const Frames& frames, const std::string& field) {
    return {kind, decode_shape(source, frames, field)};
}

}  // namespace contactd::proto
