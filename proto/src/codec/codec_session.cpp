// Encodes and decodes session.open, session.info and session.step: the messages of contact.solve, reduced in a step to
// the fields that change.
#include "contactd/proto/session.hpp"

#include <array>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/fields/session.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/status.hpp"
#include "wire/json_access.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

/// Writes all components of the force, so that a step does not inherit one from session.open by accident.
void say_force(json& motion) {
    if (!motion.contains("force")) motion["force"] = {nullptr, nullptr};
}

/// Takes the creepages of the previous step as the estimate for a prescribed force, unless the step gives one: they are
/// closer than those of session.open. A previous shift is not a useful estimate of the next one.
void take_estimates(const json& friction, const Motion& last, Motion& motion) {
    const auto* before = std::get_if<Rolling>(&last);
    auto* rolling = std::get_if<Rolling>(&motion);
    if (!before || !rolling) return;
    const json named = friction.value("rolling", json::object());
    if (before->force.Fx && rolling->force.Fx && !named.contains("xi")) rolling->xi = before->xi;
    if (before->force.Fy && rolling->force.Fy && !named.contains("eta")) rolling->eta = before->eta;
}

void apply_friction(const json& params, const Frames& frames, ContactProblem& problem) {
    const json& friction = params["friction"];
    if (!problem.friction && !friction.contains("mu"))
        throw invalid_field("friction.mu",
                            "is missing; give it in every step with friction, because session.open gave none");
    if (!problem.friction) problem.friction.emplace();
    read_fields(friction, type_of<FrictionFields<ContactProblem>>(), &problem, MemberPath("friction"),
                {frames, &problem.grid});
}

}  // namespace

json encode_session_spec(const SessionSpec& spec, ArrayWriter& arrays) {
    ContactProblem problem{spec.setup, spec.load};
    problem.initial = {};  // steps of a session start where the previous step ended
    json params = encode_opening(problem, arrays);
    if (spec.lease_seconds) params["lease_seconds"] = finite_field(*spec.lease_seconds, "lease_seconds");
    params["accept_unconverged"] = spec.accept_unconverged;
    return params;
}

SessionSpec decode_session_spec(const json& params, const Frames& frames) {
    const ContactProblem opening = decode_opening(params, frames);
    SessionSpec spec{opening, opening};
    if (params.contains("lease_seconds")) spec.lease_seconds = params["lease_seconds"].get<double>();
    spec.accept_unconverged = params.value("accept_unconverged", false);
    return spec;
}

json encode_session_reply(const SessionReply& reply) {
    json result = write_answer(reply, MemberPath("session"));
    result["step"] = 0;
    return result;
}

SessionReply decode_session_reply(const json& result) {
    SessionReply reply;
    read_fields(result, reply, MemberPath("session"));
    return reply;
}

json encode_session_info(const SessionInfo& info) {
    return write_answer(info, MemberPath("session"));
}

SessionInfo decode_session_info(const json& result) {
    SessionInfo info;
    read_fields(result, info, MemberPath("session"));
    return info;
}

json encode_step(const std::string& session, long long step, const StepInput& input, const Grid& grid,
                 ArrayWriter& arrays) {
    json params{{"session", session}, {"step", step}};
    if (input.Fn && input.approach)
        throw InvalidArgument("Fn", "cannot be combined with an approach; remove one of them");
    params.update(write_fields(input, MemberPath(""), {&arrays, &grid}));
    if (input.motion) {
        json& friction = params["friction"];
        say_force(friction.contains("rolling") ? friction["rolling"] : friction);
    }
    return params;
}

void apply_step(const json& params, const Frames& frames, const std::optional<Motion>& last, ContactProblem& problem) {
    if (params.contains("approach")) {
        problem.Fn.reset();
        problem.approach = params["approach"].get<double>();
    } else if (params.contains("Fn")) {
        problem.approach.reset();
        problem.Fn = params["Fn"].get<double>();
    } else if (!problem.approach && !problem.Fn) {
        throw invalid_field("approach", "is missing; give it or Fn in every step, because session.open gave neither");
    }
    if (params.contains("gap"))
        read_fields(params["gap"], problem.gap.emplace(), MemberPath("gap"), {frames, &problem.grid});
    else if (!problem.gap)
        throw invalid_field("gap", "is missing; give it in every step, because session.open gave none");
    if (params.contains("friction")) apply_friction(params, frames, problem);
    problem.derivatives = params.value("derivatives", problem.derivatives);
    problem.displacements = params.value("displacements", problem.displacements);
    if (last && problem.friction) take_estimates(params.value("friction", json::object()), *last, problem.motion);
}

json encode_step_reply(long long step, const ContactSolution& solution, const Grid& grid, const SolutionFields& fields,
                       ArrayWriter& arrays) {
    json result = encode_summary(solution, grid);
    result["step"] = step;
    encode_arrays(solution, fields, grid, arrays, result);
    return result;
}

namespace {

template <class Source>
StepReply read_step_reply(const Source& result, const Frames& frames, const Grid& grid) {
    StepReply reply;
    reply.step = integer_of(result["step"]);
    decode_summary(result, reply.solution);
    decode_arrays(result, frames, shape_of(grid), reply.solution);
    return reply;
}

}  // namespace

StepReply decode_step_reply(const json& result, const Frames& frames, const Grid& grid) {
    return read_step_reply(result, frames, grid);
}

StepReply decode_step_reply(const AnswerValue& result, const Frames& frames, const Grid& grid) {
    return read_step_reply(result, frames, grid);
}

}  // namespace contactd::proto
