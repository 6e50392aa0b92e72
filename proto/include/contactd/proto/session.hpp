// The messages of sessions (docs/sessions.md).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/proto/message.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/session.hpp"

namespace contactd::proto {

// --- session.open ----------------------------------------------------------------------------------------------------
nlohmann::json encode_session_spec(const SessionSpec& spec, ArrayWriter& arrays);
/// `params` has passed its schema. Throws as decode_problem.
SessionSpec decode_session_spec(const nlohmann::json& params, const std::vector<std::string>& frames);

nlohmann::json encode_session_reply(const SessionReply& reply);
SessionReply decode_session_reply(const nlohmann::json& result);

// --- session.info ----------------------------------------------------------------------------------------------------
nlohmann::json encode_session_info(const SessionInfo& info);
/// Throws StatusError naming a field of the grid.
SessionInfo decode_session_info(const nlohmann::json& result);

// --- session.step ----------------------------------------------------------------------------------------------------
nlohmann::json encode_step(const std::string& session, long long step, const StepInput& input, const Grid& grid,
                           ArrayWriter& arrays);

/// Lays what a step says, `params`, which has passed its schema, over `problem`, which is as the session was opened.
/// `last` is the motion of the step before: the creepage it found for a prescribed force is the estimate now, unless
/// the step names another. Throws StatusError naming the field.
void apply_step(const nlohmann::json& params, const std::vector<std::string>& frames, const std::optional<Motion>& last,
                ContactProblem& problem);

/// Of several steps, by the schema of session.step_many.
struct StepAsked {
    std::string session;
    long long step = 0;
    const StepInput& input;
    const Grid& grid;
};
nlohmann::json encode_steps(std::span<const StepAsked> steps, ArrayWriter& arrays);

std::vector<StepOrStatus> decode_step_replies(const nlohmann::json& result, const std::vector<std::string>& frames,
                                              std::span<const Grid> grids);

nlohmann::json encode_step_reply(long long step, const ContactSolution& solution, const Grid& grid,
                                 const SolutionFields& fields, ArrayWriter& arrays);
StepReply decode_step_reply(const nlohmann::json& result, const std::vector<std::string>& frames, const Grid& grid);

}  // namespace contactd::proto
