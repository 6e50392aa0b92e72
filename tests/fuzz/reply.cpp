// Fuzzes an answer as the clients of C and C++ read it: it conforms to its schema and is read, or it is refused. A
// document of nlohmann-json with the same content conforms equally.
#include <cstdlib>

#include "contactd/error.hpp"
#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/session.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "input.hpp"

using namespace contactd::proto;

namespace {

const contactd::Grid grid = contactd::Grid::of_elements(2, 1, 1, 1);

/// Decodes the answers that are read without an intermediate document.
void decode(const std::string& method, const AnswerValue& result, const Frames& frames) {
    if (method == "contact.solve") decode_solve_reply(result, frames);
    if (method == "wheelrail.solve") decode_wheel_rail_solution(result, frames);
    if (method == "session.step") decode_step_reply(result, frames, grid);
}

void decode(const std::string& method, const nlohmann::json& result, const Frames& frames) {
    if (method == "ic.get") decode_ic_reply(result, frames);
    if (method == "contact.solve") decode_solve_reply(result, frames);
    if (method == "contact.solve_many") decode_solve_replies(result, frames);
    if (method == "contact.subsurface") decode_subsurface_reply(result, frames);
    if (method == "contact.temperature") decode_temperature_reply(result, grid, frames);
    if (method == "wheelrail.solve") decode_wheel_rail_solution(result, frames);
    if (method == "wheelrail.wheelset") decode_wheelset_solution(result, frames);
    if (method == "wheelrail.geometry") decode_wheel_rail_geometries(result);
    if (method == "wheelrail.geometry" && result.contains("conicities")) decode_conicities(result["conicities"]);
    if (method == "wheelrail.geometry" && result.contains("contacts")) decode_contacts(result["contacts"]);
    if (method == "wheelrail.geometry" && result.contains("profiles")) decode_profiles(result["profiles"], frames);
    if (method == "session.info") decode_session_info(result);
    if (method == "session.step") decode_step_reply(result, frames, grid);
}

/// Decodes a result in either form if it conforms to the schema of a method.
template <class Value>
void read(const std::string& method, const Value& result, const Frames& frames) {
    if (!violations_of(method + ".result", result).empty()) return;
    try {
        decode(method, result, frames);
    } catch (const StatusError&) {
    }
}

/// Returns whether a reply has a result that a client would read.
template <class Value>
bool succeeded(const Value& reply) {
    return violations_of("reply", reply).empty();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Input input = fuzz::split(fuzz::bytes_of(data, size));
    const auto text = AnswerText::parsed(input.text);
    if (!text || !text->root().is_object()) return 0;
    const AnswerValue answer = text->root();
    const nlohmann::json reply = answer.json();
    if (answer.contains("progress")) {
        (void)violations_of("progress", answer);
        return 0;
    }
    // A duplicate name in an object is refused only while the document contains both.
    if (succeeded(answer) && !succeeded(reply)) std::abort();
    if (!succeeded(answer)) return 0;
    if (const Status status = status_from_json(reply.at("status")); !status.ok()) return 0;
    // A reply does not contain the method, which the client remembers.
    const auto result = answer.find("result");
    const Frames frames(input.frames.begin(), input.frames.end());
    for (const std::string& method : method_names()) {
        if (result) read(method, *result, frames);
        read(method, reply.value("result", nlohmann::json::object()), frames);
    }
    return 0;
}
