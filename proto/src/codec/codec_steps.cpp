// Encodes and decodes session.step_many: the messages of session.step, side by side.
#include <utility>

#include "contactd/proto/session.hpp"
#include "contactd/proto/status.hpp"
#include "wire/json_access.hpp"

namespace contactd::proto {

using nlohmann::json;

json encode_step(const StepAsked& asked, ArrayWriter& arrays) {
    if (const auto* wheel = std::get_if<const WheelRailStepInput*>(&asked.input))
        return encode_step(asked.session, asked.step, **wheel);
    return encode_step(asked.session, asked.step, *std::get<const StepInput*>(asked.input), *asked.grid, arrays);
}

namespace {

template <class Source>
AnyStepOrStatus read_step_reply(const Source& result, const Frames& frames, const StepAsked& asked) {
    if (std::holds_alternative<const WheelRailStepInput*>(asked.input))
        return decode_wheel_rail_step_reply(result, frames);
    return decode_step_reply(result, frames, *asked.grid);
}

template <class Source>
std::vector<AnyStepOrStatus> read_step_replies(const Source& result, const Frames& frames,
                                               std::span<const StepAsked> asked) {
    const Source& steps = result["steps"];
    if (steps.size() != asked.size())
        throw StatusError(StatusCode::unknown, reason::unexpected, "The reply contains a different number of steps.");
    std::vector<AnyStepOrStatus> replies;
    for (const auto& step : steps) {
        Status status = status_from_json(as_json(step["status"]));
        if (status.ok())
            replies.push_back(read_step_reply<Source>(step["result"], frames, asked[replies.size()]));
        else
            replies.emplace_back(std::move(status));
    }
    return replies;
}

}  // namespace

AnyStepOrStatus decode_step_reply(const json& result, const Frames& frames, const StepAsked& asked) {
    return read_step_reply(result, frames, asked);
}

AnyStepOrStatus decode_step_reply(const AnswerValue& result, const Frames& frames, const StepAsked& asked) {
    return read_step_reply(result, frames, asked);
}

json encode_steps(std::span<const StepAsked> steps, ArrayWriter& arrays) {
    json list = json::array();
    for (const StepAsked& asked : steps) list.push_back(encode_step(asked, arrays));
    return {{"steps", std::move(list)}};
}

std::vector<AnyStepOrStatus> decode_step_replies(const json& result, const Frames& frames,
                                                 std::span<const StepAsked> asked) {
    return read_step_replies(result, frames, asked);
}

std::vector<AnyStepOrStatus> decode_step_replies(const AnswerValue& result, const Frames& frames,
                                                 std::span<const StepAsked> asked) {
    return read_step_replies(result, frames, asked);
}

}  // namespace contactd::proto
