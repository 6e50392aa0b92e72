// Results of contact.solve.
#include "codec_parts.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/fields/ic_reply.hpp"
#include "contactd/fields/solve_reply.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

/// With friction; a step that the request left out is told.
json encode_motion_of(const Motion& motion, const Grid& grid) {
    try {
        json result = encode_motion(motion);
        if (const auto* rolling = std::get_if<Rolling>(&motion))
            result["dq"] = finite_field(step_length(*rolling, grid), "friction.rolling.dq");
        return result;
    } catch (const InvalidArgument& error) {
        throw Error(error.what());  // found, not asked for
    }
}

}  // namespace

json encode_summary(const ContactSolution& solution, const Grid& grid) {
    json result = write_answer(solution, MemberPath("solution"));
    result["converged"] = solution.converged();
    if (solution.motion) result["motion"] = encode_motion_of(*solution.motion, grid);
    return result;
}

void decode_summary(const json& result, ContactSolution& solution) {
    read_fields(result, solution, MemberPath("solution"));
    if (result.contains("motion")) solution.motion = decode_motion(result["motion"]);
}

json encode_solve_reply(const SolveReply& reply, const Grid& grid, ArrayWriter& arrays, const SolutionFields& fields) {
    json result = encode_summary(reply.solution, grid);
    result["evidence"]["ics"] = write_answer(reply.ics, MemberPath("ics"));
    if (reply.operators) result["evidence"]["operators"] = write_answer(*reply.operators, MemberPath("operators"));
    encode_arrays(reply.solution, fields, grid, arrays, result);
    return result;
}

SolveReply decode_solve_reply(const json& result, const Frames& frames) {
    SolveReply reply;
    decode_summary(result, reply.solution);
    decode_arrays(result, frames, {}, reply.solution);
    const json& evidence = result["evidence"];
    read_fields(evidence["ics"], reply.ics, MemberPath("ics"));
    if (evidence.contains("operators"))
        read_fields(evidence["operators"], reply.operators.emplace(), MemberPath("operators"));
    return reply;
}

}  // namespace contactd::proto
