// Encodes the messages of sessions (docs/sessions.md).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "contactd/session.hpp"

namespace contactd::proto {

// --- session.open ----------------------------------------------------------------------------------------------------
nlohmann::json encode_session_spec(const SessionSpec& spec, ArrayWriter& arrays);
/// `params` has passed its schema. Throws as decode_problem.
SessionSpec decode_session_spec(const nlohmann::json& params, const Frames& frames);

nlohmann::json encode_session_reply(const SessionReply& reply);
SessionReply decode_session_reply(const nlohmann::json& result);

// --- session.info ----------------------------------------------------------------------------------------------------
nlohmann::json encode_session_info(const SessionInfo& info);
/// Throws StatusError naming a field of the grid.
SessionInfo decode_session_info(const nlohmann::json& result);

// --- session.step ----------------------------------------------------------------------------------------------------
nlohmann::json encode_step(const std::string& session, long long step, const StepInput& input, const Grid& grid,
                           ArrayWriter& arrays);

/// Applies the fields of a step, `params`, which has passed its schema, to `problem` from the opening of the session.
/// `last` is the motion of the previous step: its creepage for a prescribed force is the estimate, unless the step has
/// another. Throws StatusError naming the field.
void apply_step(const nlohmann::json& params, const Frames& frames, const std::optional<Motion>& last,
                ContactProblem& problem);

/// Holds a step, or one of several in session.step_many.
struct StepAsked {
    std::string session;
    long long step = 0;
    std::variant<const StepInput*, const WheelRailStepInput*> input;
    std::optional<Grid> grid{};  ///< of a contact
};
nlohmann::json encode_step(const StepAsked& asked, ArrayWriter& arrays);
nlohmann::json encode_steps(std::span<const StepAsked> steps, ArrayWriter& arrays);

/// Returns the answer to a solved step.
AnyStepOrStatus decode_step_reply(const nlohmann::json& result, const Frames& frames, const StepAsked& asked);
AnyStepOrStatus decode_step_reply(const AnswerValue& result, const Frames& frames, const StepAsked& asked);
std::vector<AnyStepOrStatus> decode_step_replies(const nlohmann::json& result, const Frames& frames,
                                                 std::span<const StepAsked> asked);
std::vector<AnyStepOrStatus> decode_step_replies(const AnswerValue& result, const Frames& frames,
                                                 std::span<const StepAsked> asked);

nlohmann::json encode_step_reply(long long step, const ContactSolution& solution, const Grid& grid,
                                 const SolutionFields& fields, ArrayWriter& arrays);
StepReply decode_step_reply(const nlohmann::json& result, const Frames& frames, const Grid& grid);
StepReply decode_step_reply(const AnswerValue& result, const Frames& frames, const Grid& grid);

// --- of wheels on rails ----------------------------------------------------------------------------------------------
/// Params of session.open and session.step, and results of steps, for a wheel on its rail.
bool is_of_wheel_rail(const nlohmann::json& message);
/// Returns the error with fields of wheelrail.solve at their place in these messages: "wheelrail.setup.dx".
Status below_wheel_rail(Status status);

nlohmann::json encode_session_spec(const WheelRailSessionSpec& spec, ArrayWriter& arrays);
/// `params` has passed its schema. Throws as decode_wheel_rail_setup.
WheelRailSessionSpec decode_wheel_rail_session_spec(const nlohmann::json& params, const Frames& frames);

nlohmann::json encode_step(const std::string& session, long long step, const WheelRailStepInput& input);
WheelRailStepInput decode_wheel_rail_step(const nlohmann::json& params);

/// Returns the text of the result as JSON.
std::string write_step_reply(long long step, const WheelRailSolution& solution, const PatchFields& fields,
                             ArrayWriter& arrays);
WheelRailStepReply decode_wheel_rail_step_reply(const nlohmann::json& result, const Frames& frames);
WheelRailStepReply decode_wheel_rail_step_reply(const AnswerValue& result, const Frames& frames);

}  // namespace contactd::proto
