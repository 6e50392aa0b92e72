// Contact on curved columns: where they lie.
#include <algorithm>
#include <array>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/proto/object.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr std::size_t numbers_of_frame = 3;  // y, z, angle

/// With their names; Part may be const.

}  // namespace

json encode_columns(const ContactColumns& columns, ArrayWriter& arrays) {
    std::vector<double> frames;
    for (const StripFrame& frame : columns.frames) frames.insert(frames.end(), {frame.y, frame.z, frame.angle});
    return object({{"frames", arrays.write(std::span<const double>(frames), {columns.frames.size(), numbers_of_frame})},
                   {"direction", finite_field(columns.direction, "columns.direction")},
                   {"origin", json::array({finite_field(columns.origin.y, "columns.origin"),
                                           finite_field(columns.origin.z, "columns.origin")})}});
}

ContactColumns decode_columns(const json& source, const Frames& frames, const Grid& grid) {
    const std::vector<double> numbers =
        read_array(source["frames"], frames, {static_cast<std::size_t>(grid.ny), numbers_of_frame}, "columns.frames");
    ContactColumns columns;
    for (std::size_t at = 0; at < numbers.size(); at += numbers_of_frame)
        columns.frames.push_back({numbers[at], numbers[at + 1], numbers[at + 2]});
    columns.direction = source.value("direction", columns.direction);
    if (source.contains("origin"))
        columns.origin = {source["origin"][0].get<double>(), source["origin"][1].get<double>()};
    return columns;
}

}  // namespace contactd::proto
