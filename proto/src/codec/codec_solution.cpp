// Results of contact.solve.
#include "codec_parts.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"
#include "field_codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

json encode_operators(const OperatorUse& use) {
    return object({{"made", use.made}, {"bytes", use.bytes}, {"budget_bytes", use.budget_bytes}});
}

OperatorUse decode_operators(const json& source) {
    return {source["made"].get<bool>(), source["bytes"].get<std::size_t>(), source["budget_bytes"].get<std::size_t>()};
}

IcUse decode_use(const json& source) {
    return {source["origin"].get<std::string>(), source["key"].get<std::string>(), decode_evidence(source["evidence"])};
}

/// Uses may be const.
template <class Uses>
auto parts_of(Uses& uses) {
    return std::array{std::pair("upper", &uses.upper), std::pair("lower", &uses.lower), std::pair("pair", &uses.pair)};
}

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

json encode_use(const IcUse& use) {
    return object({{"origin", use.origin}, {"key", use.key}, {"evidence", encode_evidence(use.evidence)}});
}

json encode_uses(const IcUses& uses) {
    json result = json::object();
    for (const auto& [name, use] : parts_of(uses))
        if (*use) result[name] = encode_use(**use);
    return result;
}

IcUses decode_uses(const json& source) {
    IcUses uses;
    for (const auto& [name, use] : parts_of(uses))
        if (source.contains(name)) *use = decode_use(source[name]);
    return uses;
}

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
    result["evidence"]["ics"] = encode_uses(reply.ics);
    if (reply.operators) result["evidence"]["operators"] = encode_operators(*reply.operators);
    encode_arrays(reply.solution, fields, grid, arrays, result);
    return result;
}

SolveReply decode_solve_reply(const json& result, const Frames& frames) {
    SolveReply reply;
    decode_summary(result, reply.solution);
    decode_arrays(result, frames, {}, reply.solution);
    reply.ics = decode_uses(result["evidence"]["ics"]);
    if (result["evidence"].contains("operators")) reply.operators = decode_operators(result["evidence"]["operators"]);
    return reply;
}

}  // namespace contactd::proto
