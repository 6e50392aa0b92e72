// Encodes and decodes contact.solve_many, the messages of contact.solve side by side, and the results of all methods
// with several parts.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr std::size_t beyond_counting = std::size_t{1} << 40u;

/// Returns the number of elements that a reference claims. The reference has passed its schema.
std::size_t claimed_elements(const json& reference) {
    std::size_t elements = 1;
    for (const json& extent : reference["shape"])
        elements = std::min(beyond_counting, elements * extent.get<std::size_t>());  // an extent is at most 4e6
    return elements;
}

/// Returns the number of elements of all referenced arrays below `node`. Those of lists were counted when the envelope
/// was read.
std::size_t referred_elements(const json& node) {
    if (!node.is_object()) return 0;
    if (const auto reference = node.find("$array"); reference != node.end()) return claimed_elements(*reference);
    std::size_t elements = 0;
    for (const json& child : node) elements += referred_elements(child);
    return elements;
}

}  // namespace

json encode_problems(std::span<const ContactProblem> problems, ArrayWriter& arrays, const SolutionFields& fields) {
    json list = json::array();
    for (const ContactProblem& problem : problems) list.push_back(encode_problem(problem, arrays, fields));
    return {{"problems", std::move(list)}};
}

// One frame of a small message can provide the arrays of every problem, so their total size is limited, too.
void check_referred_elements(const json& problems, const MessageLimits& limits) {
    std::size_t elements = 0;
    for (const json& problem : problems) elements += referred_elements(problem);
    if (elements > limits.max_array_elements)
        throw invalid_field("problems",
                            "name arrays of " + std::to_string(elements) + " elements together, but at most " +
                                std::to_string(limits.max_array_elements) +
                                " are allowed (limits.max_array_elements, counting an array each time it is named)",
                            reason::limit_exceeded);
}

ResultOrStatus encode_outcome(const SolveReply& reply, const Grid& grid, ArrayEncoding encoding,
                              const SolutionFields& fields) {
    try {
        ArrayWriter arrays(encoding);
        json result = encode_solve_reply(reply, grid, arrays, fields);
        return Result{std::make_shared<const std::string>(dump(result)), arrays.take_frames()};
    } catch (const Error& error) {
        return Status{StatusCode::internal, error.what(), std::string(reason::unexpected), {}, 0};
    }
}

std::string encode_results(std::string_view list, std::vector<ResultOrStatus> results, Frames& frames) {
    const std::string success = dump(to_json(Status{}));
    std::string text = "{\"" + std::string(list) + "\":[";
    for (ResultOrStatus& outcome : results) {
        if (text.back() != '[') text += ',';
        if (const auto* status = std::get_if<Status>(&outcome)) {
            text += "{\"status\":" + dump(to_json(*status)) + "}";
            continue;
        }
        Result& one = std::get<Result>(outcome);
        text += "{\"status\":" + success + ",\"result\":";
        append_moved(text, *one.text, frames.size());
        text += '}';
        std::move(one.frames.begin(), one.frames.end(), std::back_inserter(frames));
    }
    return text + "]}";
}

std::vector<ReplyOrStatus> decode_solve_replies(const json& result, const Frames& frames) {
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
