#include "contactd/proto/message.hpp"

#include <algorithm>
#include <utility>

#include "contactd/proto/json_reader.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/status.hpp"
#include "schema/shown.hpp"

namespace contactd::proto {
namespace {

constexpr std::size_t max_id_characters = 128;
/// Largest number of values in an envelope in addition to those of its arrays.
constexpr std::size_t values_beside_arrays = 10'000;

[[noreturn]] void limit_exceeded(const std::string& what, std::size_t is, std::size_t limit) {
    throw StatusError(StatusCode::invalid_argument, reason::limit_exceeded,
                      what + " is " + std::to_string(is) + "; at most " + std::to_string(limit) + " are allowed.");
}

void find_id(const nlohmann::json& envelope, std::string& id_out) {
    if (!envelope.is_object()) return;
    const auto id = envelope.find("id");
    if (id == envelope.end() || !id->is_string()) return;
    const auto& text = id->get_ref<const std::string&>();
    if (characters(text) <= max_id_characters) id_out = text;
}

void check_limits(std::size_t envelope_bytes, const Frames& frames, const MessageLimits& limits) {
    if (frames.size() + 1 > limits.max_frames)
        limit_exceeded("The number of frames", frames.size() + 1, limits.max_frames);
    std::size_t bytes = envelope_bytes;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (frames[i].size() > limits.max_frame_bytes)
            limit_exceeded("The number of bytes of frame " + std::to_string(i + 1), frames[i].size(),
                           limits.max_frame_bytes);
        bytes += frames[i].size();
    }
    if (bytes > limits.max_message_bytes)
        limit_exceeded("The number of bytes of the message", bytes, limits.max_message_bytes);
}

/// This check comes first, because the rest of the envelope may differ in another version.
void check_version(const nlohmann::json& envelope) {
    const auto at = envelope.find("contactd");
    if (at == envelope.end() || !at->is_number_integer()) return;  // the schema reports it
    const auto served = [&](int version) { return *at == version; };
    if (std::any_of(protocol_versions.begin(), protocol_versions.end(), served)) return;
    Status status{StatusCode::unimplemented, {}, std::string(reason::protocol_version), {}, 0};
    status.versions.assign(protocol_versions.begin(), protocol_versions.end());
    const bool newer = *at > protocol_versions.back();
    status.message = "The request is of version " + shown(*at) + " of the protocol; this daemon, contactd " +
                     CONTACTD_VERSION + ", serves version " + std::to_string(protocol_version) + ": upgrade the " +
                     (newer ? "daemon" : "client") + ".";
    throw StatusError(std::move(status));
}

std::optional<Priority> priority_of(const nlohmann::json& envelope) {
    const auto at = envelope.find("priority");
    if (at == envelope.end()) return std::nullopt;
    return *at == "high" ? Priority::high : *at == "low" ? Priority::low : Priority::normal;
}

void check_envelope(const nlohmann::json& envelope) {
    std::vector<Violation> violations = violations_of("envelope", envelope);
    if (violations.empty()) return;
    std::string message = violations[0].field + " " + violations[0].description;
    throw StatusError(Status{StatusCode::invalid_argument, std::move(message), std::string(reason::envelope_invalid),
                             std::move(violations), 0});
}

nlohmann::json member_or_empty(nlohmann::json& envelope, const char* key) {
    const auto at = envelope.find(key);
    return at == envelope.end() ? nlohmann::json::object() : std::move(*at);
}

}  // namespace

nlohmann::json to_json(const MessageLimits& limits) {
    return {{"max_frame_bytes", limits.max_frame_bytes},
            {"max_frames", limits.max_frames},
            {"max_message_bytes", limits.max_message_bytes},
            {"max_array_elements", limits.max_array_elements}};
}

Request parse_request(std::string_view text, Frames frames, const MessageLimits& limits, std::string& id_out) {
    id_out.clear();
    if (text.size() > limits.max_frame_bytes)
        limit_exceeded("The number of bytes of the envelope", text.size(), limits.max_frame_bytes);
    nlohmann::json envelope;
    try {
        read_json(text, limits.max_array_elements + values_beside_arrays, envelope);
    } catch (const StatusError&) {
        find_id(envelope, id_out);
        throw;
    }
    find_id(envelope, id_out);
    check_limits(text.size(), frames, limits);
    if (!envelope.is_object())
        throw StatusError(StatusCode::invalid_argument, reason::not_an_object,
                          std::string("The envelope is a JSON ") + envelope.type_name() + "; it must be an object.");
    check_version(envelope);
    check_envelope(envelope);

    Request request;
    request.id = envelope["id"].get<std::string>();
    request.method = envelope["method"].get<std::string>();
    request.params = member_or_empty(envelope, "params");
    request.metadata = member_or_empty(envelope, "metadata");
    request.timeout_ms = envelope.value("timeout_ms", 0);
    request.arrays = envelope.value("arrays", "frame") == "list" ? ArrayEncoding::list : ArrayEncoding::frame;
    request.priority = priority_of(envelope);
    request.bytes = text.size();
    for (const Frame& frame : frames) request.bytes += frame.size();
    request.frames = std::move(frames);
    return request;
}

std::string dump(const nlohmann::json& json) {
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace contactd::proto
