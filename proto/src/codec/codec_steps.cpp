// session.step_many: the messages of session.step, side by side.
#include <utility>

#include "contactd/proto/session.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {

using nlohmann::json;

json encode_step(const StepAsked& asked, ArrayWriter& arrays) {
    if (const auto* wheel = std::get_if<const WheelRailStepInput*>(&asked.input))
        return encode_step(asked.session, asked.step, **wheel);
    return encode_step(asked.session, asked.step, *std::get<const StepInput*>(asked.input), *asked.grid, arrays);
}

AnyStepOrStatus decode_step_reply(const json& result, const Frames& frames, const StepAsked& asked) {
    if (std::holds_alternative<const WheelRailStepInput*>(asked.input))
        return decode_wheel_rail_step_reply(result, frames);
    return decode_step_reply(result, frames, *asked.grid);
}

json encode_steps(std::span<const StepAsked> steps, ArrayWriter& arrays) {
    json list = json::array();
    for (const StepAsked& asked : steps) list.push_back(encode_step(asked, arrays));
    return {{"steps", std::move(list)}};
}

std::vector<AnyStepOrStatus> decode_step_replies(const json& result, const Frames& frames,
                                                 std::span<const StepAsked> asked) {
    const json& steps = result["steps"];
    if (steps.size() != asked.size())
        throw StatusError(StatusCode::unknown, reason::unexpected, "The reply answers another number of steps.");
    std::vector<AnyStepOrStatus> replies;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        Status status = status_from_json(steps[i]["status"]);
        if (status.ok())
            replies.push_back(decode_step_reply(steps[i]["result"], frames, asked[i]));
        else
            replies.emplace_back(std::move(status));
    }
    return replies;
}

}  // namespace contactd::proto
