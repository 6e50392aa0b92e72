// contact.solve_many: the messages of contact.solve, side by side.
#include <algorithm>
#include <string>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr std::size_t beyond_counting = std::size_t{1} << 40u;

/// Elements of the array that a reference, which has passed its schema, claims to have.
std::size_t claimed_elements(const json& reference) {
    std::size_t elements = 1;
    for (const json& extent : reference["shape"])
        elements = std::min(beyond_counting, elements * extent.get<std::size_t>());  // an extent is at most 4e6
    return elements;
}

/// Elements of all arrays below `node` that are references; those of lists were counted when the envelope was read.
std::size_t referred_elements(const json& node) {
    if (!node.is_object()) return 0;
    if (const auto reference = node.find("$array"); reference != node.end()) return claimed_elements(*reference);
    std::size_t elements = 0;
    for (const json& child : node) elements += referred_elements(child);
    return elements;
}

/// One frame of a small message may stand for the arrays of every problem: what these take is limited, too.
void check_referred_elements(const json& problems, const MessageLimits& limits) {
    std::size_t elements = 0;
    for (const json& problem : problems) elements += referred_elements(problem);
    if (elements > limits.max_array_elements)
        throw invalid_field("problems",
                            "name arrays of " + std::to_string(elements) + " elements together; they must not have " +
                                "more than " + std::to_string(limits.max_array_elements) +
                                " (limits.max_array_elements, an array counting as often as it is named)",
                            reason::limit_exceeded);
}

ProblemOrStatus decode_one(const json& params, const std::vector<std::string>& frames) {
    try {
        return decode_problem(params, frames);
    } catch (const StatusError& error) {
        return error.status();
    }
}

json encode_failure(const Status& status) {
    return {{"status", to_json(status)}};
}

json encode_one(const ReplyOrStatus& outcome, const Grid& grid, ArrayWriter& arrays, const SolutionFields& fields) {
    if (const auto* status = std::get_if<Status>(&outcome)) return encode_failure(*status);
    const std::size_t frames = arrays.frame_count();
    try {
        json result = encode_solve_reply(std::get<SolveReply>(outcome), grid, arrays, fields);
        return {{"status", to_json(Status{})}, {"result", std::move(result)}};
    } catch (const Error& error) {
        arrays.drop_frames_beyond(frames);
        return encode_failure({StatusCode::internal, error.what(), std::string(reason::unexpected), {}, 0});
    }
}

}  // namespace

json encode_problems(std::span<const ContactProblem> problems, ArrayWriter& arrays, const SolutionFields& fields) {
    json list = json::array();
    for (const ContactProblem& problem : problems) list.push_back(encode_problem(problem, arrays, fields));
    return {{"problems", std::move(list)}};
}

std::vector<ProblemOrStatus> decode_problems(const json& params, const std::vector<std::string>& frames,
                                             const MessageLimits& limits) {
    check_referred_elements(params["problems"], limits);
    std::vector<ProblemOrStatus> problems;
    for (const json& problem : params["problems"]) problems.push_back(decode_one(problem, frames));
    return problems;
}

json encode_solve_replies(std::span<const ReplyOrStatus> replies, std::span<const Grid> grids, ArrayWriter& arrays,
                          std::span<const SolutionFields> fields) {
    json solutions = json::array();
    for (std::size_t i = 0; i < replies.size(); ++i)
        solutions.push_back(encode_one(replies[i], grids[i], arrays, fields.empty() ? all_solution_fields : fields[i]));
    return {{"solutions", std::move(solutions)}};
}

std::vector<ReplyOrStatus> decode_solve_replies(const json& result, const std::vector<std::string>& frames) {
    std::vector<ReplyOrStatus> replies;
    for (const json& solution : result["solutions"]) {
        Status status = status_from_json(solution["status"]);
        if (status.ok())
            replies.emplace_back(decode_solve_reply(solution["result"], frames));
        else
            replies.emplace_back(std::move(status));
    }
    return replies;
}

}  // namespace contactd::proto
