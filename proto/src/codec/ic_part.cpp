#include "contactd/proto/ic_part.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 9> names{"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
/// Reserves bytes for the envelope beside the frame.
constexpr std::size_t envelope_bytes = 64 << 10;

std::size_t most_numbers(const MessageLimits& limits) {
    const std::size_t message = limits.max_message_bytes > 2 * envelope_bytes
                                    ? limits.max_message_bytes - envelope_bytes
                                    : limits.max_message_bytes / 2;
    return std::min(limits.max_frame_bytes, message) / sizeof(double);
}

std::size_t count(const IcPart& part) {
    return part.components.empty() ? names.size() : part.components.size();
}

int component_of(const json& name) {
    const auto at = std::find(names.begin(), names.end(), name.get_ref<const std::string&>());
    return static_cast<int>(at - names.begin());
}

/// Describes a request whose answer fits.
std::string advice(const IcPart& part, int nx, std::size_t most) {
    const auto columns = static_cast<std::size_t>(nx);
    if (const std::size_t rows = most / (columns * count(part)); rows > 0)
        return "request at most " + std::to_string(rows) +
               " at a time, {\"first\": 0, \"count\": " + std::to_string(rows) + "}";
    if (const std::size_t components = most / columns; components > 0)
        return "request one row and at most " + std::to_string(components) + " of the components at a time";
    return "a single component of one row is already too large";
}

}  // namespace

IcPart decode_ic_part(const json& params, int ny) {
    IcPart part{0, ny, {}, true};
    if (const auto rows = params.find("rows"); rows != params.end()) {
        part.is_whole = false;
        const auto first = (*rows)["first"].get<long long>(), count = (*rows)["count"].get<long long>();
        if (first >= ny)
            throw invalid_field("rows.first", "is " + std::to_string(first) + "; the table has " + std::to_string(ny) +
                                                  " rows, the first of which is 0");
        if (count > ny - first)
            throw invalid_field("rows.count", "is " + std::to_string(count) + ", but only " +
                                                  std::to_string(ny - first) + " rows remain from row " +
                                                  std::to_string(first));
        part.first_row = static_cast<int>(first);
        part.rows = static_cast<int>(count);
    }
    if (const auto components = params.find("components"); components != params.end()) {
        part.is_whole = false;
        for (const json& name : *components) part.components.push_back(component_of(name));
    }
    return part;
}

json encode_ic_part(const IcPart& part) {
    json request{{"rows", {{"first", part.first_row}, {"count", part.rows}}}};
    for (const int component : part.components)
        request["components"].push_back(names[static_cast<std::size_t>(component)]);
    return request;
}

void check_size(const IcPart& part, int nx, const MessageLimits& limits) {
    const std::size_t most = most_numbers(limits);
    const std::size_t numbers = count(part) * static_cast<std::size_t>(part.rows) * static_cast<std::size_t>(nx);
    if (numbers <= most) return;
    throw invalid_field("rows",
                        "result in a table of " + std::to_string(numbers * sizeof(double)) +
                            " bytes, but a message may contain at most " + std::to_string(most * sizeof(double)) +
                            " (limits.max_frame_bytes, limits.max_message_bytes): " + advice(part, nx, most),
                        reason::answer_too_large);
}

namespace {

json write_part(const IcTable& table, const IcPart& part, ArrayWriter& arrays) {
    const auto nx = static_cast<std::size_t>(table.nx), rows = static_cast<std::size_t>(part.rows);
    std::vector<int> components = part.components;
    if (components.empty()) {
        components.resize(names.size());
        std::iota(components.begin(), components.end(), 0);
    }
    UnsetArray values;
    values.reserve(components.size() * rows * nx);
    for (const int component : components) {
        const auto row = static_cast<std::size_t>(component) * static_cast<std::size_t>(table.ny) +
                         static_cast<std::size_t>(part.first_row);
        const auto begin = table.values.begin() + static_cast<std::ptrdiff_t>(row * nx);
        values.insert(values.end(), begin, begin + static_cast<std::ptrdiff_t>(rows * nx));
    }
    std::vector<std::size_t> shape{components.size(), rows, nx};
    if (part.components.empty()) shape = {3, 3, rows, nx};
    return arrays.write_finite(std::move(values), std::move(shape));
}

}  // namespace

json encode_ic_part_reply(IcReply reply, const IcPart& part, ArrayWriter& arrays) {
    if (part.is_whole) return encode_ic_reply(std::move(reply), arrays);
    json result = encode_ic_part(part);
    result["key"] = reply.key;
    result["origin"] = reply.origin;
    result["spec"] = encode_ic_spec(reply.spec);
    result["table"] = write_part(reply.table, part, arrays);
    result["evidence"] = encode_evidence(reply.evidence);
    if (!reply.frames.empty()) result["frames"] = encode_frames(reply.frames, arrays);
    return result;
}

void read_part(const json& result, const Frames& frames, const IcPart& part, IcReply& whole) {
    const auto nx = static_cast<std::size_t>(whole.table.nx), rows = static_cast<std::size_t>(part.rows);
    const std::vector<double> values = read_array(result["table"], frames, {part.components.size(), rows, nx}, "table");
    auto from = values.begin();
    for (const int component : part.components) {
        const auto row = static_cast<std::size_t>(component) * static_cast<std::size_t>(whole.table.ny) +
                         static_cast<std::size_t>(part.first_row);
        std::copy_n(from, rows * nx, whole.table.values.begin() + static_cast<std::ptrdiff_t>(row * nx));
        from += static_cast<std::ptrdiff_t>(rows * nx);
    }
    const auto key = result["key"].get<std::string>();
    if (!whole.origin.empty() && key != whole.key)
        throw invalid_field("key", "is " + key + ", but the previous parts belong to " + whole.key);
    if (!whole.origin.empty()) return;
    whole.key = key;
    whole.origin = result["origin"].get<std::string>();
    whole.spec = decode_ic_spec(result["spec"]);
    whole.evidence = decode_evidence(result["evidence"]);
    if (result.contains("frames")) whole.frames = decode_frames(result["frames"], frames, whole.spec.ny, "frames");
}

std::vector<IcPart> parts_within(const MessageLimits& limits, int nx, int ny) {
    const std::size_t columns = static_cast<std::size_t>(nx), most = std::max(columns, most_numbers(limits));
    const int together = static_cast<int>(std::min(names.size(), most / columns));
    const int rows = static_cast<int>(most / (columns * static_cast<std::size_t>(together)));
    std::vector<IcPart> parts;
    for (int begin = 0; begin < static_cast<int>(names.size()); begin += together) {
        std::vector<int> components(
            static_cast<std::size_t>(std::min(together, static_cast<int>(names.size()) - begin)));
        std::iota(components.begin(), components.end(), begin);
        for (int first = 0; first < ny; first += rows)
            parts.push_back({first, std::min(rows, ny - first), components, false});
    }
    return parts;
}

}  // namespace contactd::proto
