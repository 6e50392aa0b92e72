// Encodes and decodes session.open, session.step and their replies for wheels on rails: the fields of wheelrail.solve
// below `wheelrail`.
#include <utility>

#include "codec_parts.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/session.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {

using nlohmann::json;

namespace {

StatusError of_left_out(const std::string& field) {
    return invalid_field(field, "requests arrays of patches, but wheelrail.patches excludes them");
}

}  // namespace

bool is_of_wheel_rail(const json& message) {
    return message.contains("wheelrail");
}

Status below_wheel_rail(Status status) {
    if (status.violations.empty()) return status;
    const Violation& refused = status.violations.front();
    return invalid_field("wheelrail." + refused.field, refused.description, status.reason).status();
}

json encode_session_spec(const WheelRailSessionSpec& spec, ArrayWriter& arrays) {
    json params = object({{"wheelrail", object({{"setup", encode_wheel_rail_setup(spec.setup, arrays)}})}});
    if (spec.lease_seconds) params["lease_seconds"] = finite_field(*spec.lease_seconds, "lease_seconds");
    params["accept_unconverged"] = spec.accept_unconverged;
    return params;
}

WheelRailSessionSpec decode_wheel_rail_session_spec(const json& params, const Frames& frames) {
    WheelRailSessionSpec spec;
    spec.setup = decode_wheel_rail_setup(params["wheelrail"], frames);
    if (params.contains("lease_seconds")) spec.lease_seconds = params["lease_seconds"].get<double>();
    spec.accept_unconverged = params.value("accept_unconverged", false);
    return spec;
}

json encode_step(const std::string& session, long long step, const WheelRailStepInput& input) {
    json inputs = object({{"state", write_fields(input.state, MemberPath("state"))}});
    if (input.friction) inputs["friction"] = encode_wheel_rail_friction(*input.friction);
    if (input.gap) inputs["gap"] = true;
    if (!input.patches) inputs["patches"] = false;
    json params = object({{"session", session}, {"step", step}, {"wheelrail", std::move(inputs)}});
    if (input.again) params["again"] = true;
    if (!input.fields.empty()) params["fields"] = encode_fields(input.fields);
    return params;
}

WheelRailStepInput decode_wheel_rail_step(const json& params) {
    const json& inputs = params["wheelrail"];
    WheelRailStepInput input;
    input.state = read_value<WheelRailState>(inputs["state"], "state");
    if (inputs.contains("friction")) input.friction = decode_wheel_rail_friction(inputs["friction"]);
    input.again = params.value("again", false);
    input.fields = decode_fields(params, {});
    input.gap = inputs.value("gap", false);
    input.patches = inputs.value("patches", true);
    if (!input.patches && input.gap) throw of_left_out("wheelrail.gap");
    if (!input.patches && !input.fields.empty()) throw of_left_out("fields");
    return input;
}

std::string write_step_reply(long long step, const WheelRailSolution& solution, const PatchFields& fields,
                             ArrayWriter& arrays) {
    return "{\"step\":" + std::to_string(step) +
           ",\"wheelrail\":" + write_wheel_rail_solution(solution, fields, arrays) + "}";
}

WheelRailStepReply decode_wheel_rail_step_reply(const json& result, const Frames& frames) {
    return {result["step"].get<long long>(), decode_wheel_rail_solution(result["wheelrail"], frames)};
}

WheelRailStepReply decode_wheel_rail_step_reply(const AnswerValue& result, const Frames& frames) {
    return {result["step"].integer(), decode_wheel_rail_solution(result["wheelrail"], frames)};
}

}  // namespace contactd::proto
