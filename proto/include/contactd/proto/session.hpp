// Sessions: the numbered steps of a simulation (docs/sessions.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/contact.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

// --- session.open ----------------------------------------------------------------------------------------------------
struct SessionSpec {
    ContactSetup setup;  ///< what all steps have in common
    /// What holds for the steps that do not say it; `previous` is where the first one starts. Of gap, approach and Fn
    /// what is absent is named by every step.
    ContactLoad load{};
    std::optional<double> lease_seconds{};
    bool accept_unconverged = false;  ///< whether steps count that missed a tolerance
};
nlohmann::json encode_session_spec(const SessionSpec& spec, ArrayWriter& arrays);
/// `params` has passed its schema. Throws as decode_problem.
SessionSpec decode_session_spec(const nlohmann::json& params, const std::vector<std::string>& frames);

/// An open session.
struct SessionReply {
    std::string session;
    double lease_seconds = 0;
    std::size_t bytes = 0;
    std::optional<IcUse> upper{}, lower{}, pair{};  ///< as in SolveReply
};
nlohmann::json encode_session_reply(const SessionReply& reply);

// --- session.info ----------------------------------------------------------------------------------------------------
/// Where a session is, and what all its steps have in common.
struct SessionInfo {
    long long step = 0;  ///< number of the last one
    double lease_seconds = 0;
    std::size_t states = 0;  ///< saved ones
    std::size_t bytes = 0;   ///< with those
    Grid grid;
    std::optional<bool> rolls{};                    ///< or shifts; none without friction
    std::optional<IcUse> upper{}, lower{}, pair{};  ///< as in SolveReply
};
nlohmann::json encode_session_info(const SessionInfo& info);
/// Without the coefficients. Throws StatusError naming a field of the grid.
SessionInfo decode_session_info(const nlohmann::json& result);

// --- session.step ----------------------------------------------------------------------------------------------------
/// The arrays that an answer may hold.
enum class SolutionField { element_division, pressure, traction_x, traction_y, slip_x, slip_y };

/// What a step says; what it leaves out is as the session was opened.
struct StepInput {
    std::optional<double> approach{}, Fn{};  ///< one at most
    std::optional<Gap> gap{};
    std::optional<FrictionLaw> friction{};
    std::optional<Motion> motion{};  ///< whole: all its fields are sent
    RigidSlip rigid_slip{};          ///< empty: as before
    std::vector<SolutionField> fields{};  ///< wanted back
};
nlohmann::json encode_step(const std::string& session, long long step, const StepInput& input, const Grid& grid,
                           ArrayWriter& arrays);

/// Lays what a step says, `params`, which has passed its schema, over `problem`, which is as the session was opened.
/// `last` is the motion of the step before: the creepage it found for a prescribed force is the estimate now, unless
/// the step names another. Throws StatusError naming the field.
void apply_step(const nlohmann::json& params, const std::vector<std::string>& frames, const std::optional<Motion>& last,
                ContactProblem& problem);

std::vector<SolutionField> decode_fields(const nlohmann::json& params);

struct StepReply {
    long long step = 0;
    ContactSolution solution;  ///< its arrays are empty unless they were asked for
};
nlohmann::json encode_step_reply(long long step, const ContactSolution& solution, const Grid& grid,
                                 const std::vector<SolutionField>& fields, ArrayWriter& arrays);
StepReply decode_step_reply(const nlohmann::json& result, const std::vector<std::string>& frames, const Grid& grid);

}  // namespace contactd::proto
