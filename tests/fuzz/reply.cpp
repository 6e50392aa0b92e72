// An answer as the C++ client reads it: it conforms to its schema and is read, or it is refused.
#include "contactd/error.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/session.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "input.hpp"

using namespace contactd::proto;

namespace {

void decode(const std::string& method, const nlohmann::json& result, const Frames& frames) {
    if (method == "ic.get") decode_ic_reply(result, frames);
    if (method == "contact.solve") decode_solve_reply(result, frames);
    if (method == "contact.solve_many") decode_solve_replies(result, frames);
    if (method == "contact.subsurface") decode_subsurface_reply(result, frames);
    if (method == "contact.temperature")
        decode_temperature_reply(result, contactd::Grid::of_elements(2, 1, 1, 1), frames);
    if (method == "wheelrail.solve") decode_wheel_rail_solution(result, frames);
    if (method == "wheelrail.wheelset") decode_wheelset_solution(result, frames);
    if (method == "wheelrail.geometry") decode_wheel_rail_geometries(result);
    if (method == "wheelrail.geometry" && result.contains("conicities")) decode_conicities(result["conicities"]);
    if (method == "wheelrail.geometry" && result.contains("contacts")) decode_contacts(result["contacts"]);
    if (method == "wheelrail.geometry" && result.contains("profiles")) decode_profiles(result["profiles"], frames);
    if (method == "session.info") decode_session_info(result);
    if (method == "session.step") decode_step_reply(result, frames, contactd::Grid::of_elements(2, 1, 1, 1));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Input input = fuzz::split(fuzz::bytes_of(data, size));
    const auto reply = nlohmann::json::parse(input.text, nullptr, false);
    if (reply.is_discarded()) return 0;
    if (reply.is_object() && reply.contains("progress")) {
        (void)violations_of("progress", reply);
        return 0;
    }
    if (!violations_of("reply", reply).empty()) return 0;
    if (const Status status = status_from_json(reply.at("status")); !status.ok()) return 0;
    // The method is not in a reply; the client knows what it asked for.
    const nlohmann::json result = reply.value("result", nlohmann::json::object());
    for (const std::string& method : method_names()) {
        if (!violations_of(method + ".result", result).empty()) continue;
        try {
            decode(method, result, Frames(input.frames.begin(), input.frames.end()));
        } catch (const StatusError&) {
        }
    }
    return 0;
}
