#include "codec_contact_place.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "contactd/proto/object.hpp"
#include "named_numbers.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr double straight = std::numeric_limits<double>::infinity();

// Each of something that may be const.
template <class Part>
auto numbers_of_reference(Part& reference) {
    return named(std::pair("x", &reference.x), std::pair("y", &reference.y), std::pair("z", &reference.z),
                 std::pair("angle", &reference.angle));
}

template <class Part>
auto numbers_of_creepages(Part& creepages) {
    return named(std::pair("xi", &creepages.xi), std::pair("eta", &creepages.eta), std::pair("phi", &creepages.phi),
                 std::pair("chi", &creepages.chi), std::pair("velocity", &creepages.velocity));
}

template <class Part>
auto numbers_of_radii(Part& radii) {
    return named(std::pair("wheel_along", &radii.wheel_along), std::pair("wheel_across", &radii.wheel_across),
                 std::pair("rail_along", &radii.rail_along), std::pair("rail_across", &radii.rail_across));
}

json encode_extent(const Extent& extent) {
    return {finite(extent.from, "An end of a region"), finite(extent.to, "An end of a region")};
}

Extent decode_extent(const json& source) {
    return {source[0].get<double>(), source[1].get<double>()};
}

json encode_region(const OverlapRegion& region) {
    return object({{"reference", encode_numbers(numbers_of_reference(region.reference))},
                   {"x", encode_extent(region.x)},
                   {"y", encode_extent(region.y)},
                   {"z", encode_extent(region.z)},
                   {"penetration", finite(region.penetration, "The penetration of a region")},
                   {"size", finite(region.size, "The size of a region")}});
}

OverlapRegion decode_region(const json& source) {
    OverlapRegion region;
    decode_numbers(source["reference"], numbers_of_reference(region.reference));
    region.x = decode_extent(source["x"]);
    region.y = decode_extent(source["y"]);
    region.z = decode_extent(source["z"]);
    region.penetration = source["penetration"].get<double>();
    region.size = source["size"].get<double>();
    return region;
}

json encode_rows(const std::vector<ContactRow>& rows) {
    json result = json::array();
    for (const ContactRow& row : rows)
        result.push_back(object({{"y", finite(row.y, "y of a row")},
                                 {"z", finite(row.z, "z of a row")},
                                 {"angle", finite(row.angle, "The angle of a row")}}));
    return result;
}

json encode_radii(const ContactRadii& radii) {
    json result = json::object();
    for (const auto& [name, radius] : numbers_of_radii(radii))
        if (!std::isinf(*radius)) result[name] = finite(*radius, name);
    return result;
}

ContactRadii decode_radii(const json& source) {
    ContactRadii radii{straight, straight, straight, straight};
    decode_numbers(source, numbers_of_radii(radii));
    return radii;
}

}  // namespace

json encode_place(const ContactPlace& place) {
    json regions = json::array(), shares = json::array();
    for (const OverlapRegion& region : place.regions) regions.push_back(encode_region(region));
    for (const double share : place.shares) shares.push_back(finite(share, "A share of displacements"));
    json result = object({{"reference", encode_numbers(numbers_of_reference(place.reference))},
                          {"regions", std::move(regions)},
                          {"shares", std::move(shares)},
                          {"grid", encode_grid(place.grid)},
                          {"approach", finite(place.approach, "The approach of a place")},
                          {"penetration", finite(place.penetration, "The penetration of a place")},
                          {"creepages", encode_numbers(numbers_of_creepages(place.creepages))},
                          {"radii", encode_radii(place.radii)}});
    if (!place.rows.empty()) result["rows"] = encode_rows(place.rows);
    return result;
}

ContactPlace decode_place(const json& source) {
    ContactPlace place;
    decode_numbers(source["reference"], numbers_of_reference(place.reference));
    for (const json& region : source["regions"]) place.regions.push_back(decode_region(region));
    place.shares = source["shares"].get<std::vector<double>>();
    place.grid = decode_grid(source["grid"]);
    place.approach = source["approach"].get<double>();
    place.penetration = source["penetration"].get<double>();
    decode_numbers(source["creepages"], numbers_of_creepages(place.creepages));
    place.radii = decode_radii(source["radii"]);
    if (const auto rows = source.find("rows"); rows != source.end())
        for (const json& row : *rows)
            place.rows.push_back({row["y"].get<double>(), row["z"].get<double>(), row["angle"].get<double>()});
    return place;
}

}  // namespace contactd::proto
