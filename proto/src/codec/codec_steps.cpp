// session.step_many: the messages of session.step, side by side.
#include <utility>

#include "contactd/proto/session.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {

using nlohmann::json;

json encode_steps(std::span<const StepAsked> steps, ArrayWriter& arrays) {
    json list = json::array();
    for (const auto& [session, step, input, grid] : steps)
        list.push_back(encode_step(session, step, input, grid, arrays));
    return {{"steps", std::move(list)}};
}

std::vector<StepOrStatus> decode_step_replies(const json& result, const std::vector<std::string>& frames,
                                              std::span<const Grid> grids) {
    const json& steps = result["steps"];
    if (steps.size() != grids.size())
        throw StatusError(StatusCode::unknown, reason::unexpected, "The reply answers another number of steps.");
    std::vector<StepOrStatus> replies;
    for (std::size_t i = 0; i < grids.size(); ++i) {
        Status status = status_from_json(steps[i]["status"]);
        if (status.ok())
            replies.emplace_back(decode_step_reply(steps[i]["result"], frames, grids[i]));
        else
            replies.emplace_back(std::move(status));
    }
    return replies;
}

}  // namespace contactd::proto
