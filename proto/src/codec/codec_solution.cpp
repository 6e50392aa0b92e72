// Encodes and decodes results of contact.solve.
#include "codec_parts.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/fields/ic_reply.hpp"
#include "contactd/fields/solve_reply.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"
#include "field_text.hpp"
#include "wire/json_access.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

/// Encodes the motion of a problem with friction, including dq if the request omitted it.
json encode_motion_of(const Motion& motion, const Grid& grid) {
    try {
        json result = encode_motion(motion);
        if (const auto* rolling = std::get_if<Rolling>(&motion))
            result["dq"] = finite_field(step_length(*rolling, grid), "friction.rolling.dq");
        return result;
    } catch (const InvalidArgument& error) {
        throw Error(error.what());  // the value was computed, not requested
    }
}

}  // namespace

json encode_summary(const ContactSolution& solution, const Grid& grid) {
    json result = write_answer(solution, MemberPath("solution"));
    result["converged"] = solution.converged();
    if (solution.motion) result["motion"] = encode_motion_of(*solution.motion, grid);
    return result;
}

void append_summary(std::string& text, const ContactSolution& solution, const Grid& grid) {
    append_members(text, solution, MemberPath("solution"));
    append_name(text, "converged");
    text += solution.converged() ? "true" : "false";
    if (!solution.motion) return;
    append_name(text, "motion");
    text += dump(encode_motion_of(*solution.motion, grid));
}

namespace {

template <class Source>
void read_summary(const Source& result, ContactSolution& solution) {
    read_fields(result, solution, MemberPath("solution"));
    if (const auto motion = member_of(result, "motion")) solution.motion = decode_motion(as_json(*motion));
}

template <class Source>
SolveReply read_solve_reply(const Source& result, const Frames& frames) {
    SolveReply reply;
    decode_summary(result, reply.solution);
    decode_arrays(result, frames, {}, reply.solution);
    const Source& evidence = result["evidence"];
    read_fields(evidence["ics"], reply.ics, MemberPath("ics"));
    if (const auto operators = member_of(evidence, "operators"))
        read_fields(*operators, reply.operators.emplace(), MemberPath("operators"));
    return reply;
}

}  // namespace

void decode_summary(const json& result, ContactSolution& solution) {
    read_summary(result, solution);
}

void decode_summary(const AnswerValue& result, ContactSolution& solution) {
    read_summary(result, solution);
}

json encode_solve_reply(const SolveReply& reply, const Grid& grid, ArrayWriter& arrays, const SolutionFields& fields) {
    json result = encode_summary(reply.solution, grid);
    result["evidence"]["ics"] = write_answer(reply.ics, MemberPath("ics"));
    if (reply.operators) result["evidence"]["operators"] = write_answer(*reply.operators, MemberPath("operators"));
    encode_arrays(reply.solution, fields, grid, arrays, result);
    return result;
}

SolveReply decode_solve_reply(const json& result, const Frames& frames) {
    return read_solve_reply(result, frames);
}

SolveReply decode_solve_reply(const AnswerValue& result, const Frames& frames) {
    return read_solve_reply(result, frames);
}

}  // namespace contactd::proto
