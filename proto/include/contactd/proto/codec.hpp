// Converts JSON to plain values and back, for the server, contactd-ic and the C++ client. Each message is written and
// read in one place.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/contact.hpp"
#include "contactd/ic_reply.hpp"
#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/solve_reply.hpp"
#include "contactd/subsurface_stress.hpp"
#include "contactd/temperature.hpp"

namespace contactd::proto {

// --- ic.get; contactd-ic reads the same object from a file ---------------------------------------------------------
nlohmann::json encode_ic_spec(const IcSpec& spec);
/// `params` has passed its schema. Applies preset and defaults; contactd::validate checks bounds.
IcSpec decode_ic_spec(const nlohmann::json& params);

/// The table must be finite, like those of table_for.
nlohmann::json encode_ic_reply(IcReply reply, ArrayWriter& arrays);
IcReply decode_ic_reply(const nlohmann::json& result, const Frames& frames);

nlohmann::json encode_evidence(const IcEvidence& evidence);
IcEvidence decode_evidence(const nlohmann::json& json);

// --- contact.solve ---------------------------------------------------------------------------------------------------
nlohmann::json encode_problem(const ContactProblem& problem, ArrayWriter& arrays);
/// Does the same with only these arrays of the solution.
nlohmann::json encode_problem(const ContactProblem& problem, ArrayWriter& arrays, const SolutionFields& fields);
/// `params` has passed its schema. Throws StatusError naming the field for a grid that is too large (before memory is
/// allocated) and for arrays that do not match; contactd::validate checks the rest. `ics` is only read for the model
/// full, because others do not use it.
ContactProblem decode_problem(const nlohmann::json& params, const Frames& frames);

/// Returns the requested fields of a request that has passed its schema; `otherwise` if it has none.
nlohmann::json encode_fields(const SolutionFields& fields);
SolutionFields decode_fields(const nlohmann::json& params, const SolutionFields& otherwise);

nlohmann::json encode_solve_reply(const SolveReply& reply, const Grid& grid, ArrayWriter& arrays,
                                  const SolutionFields& fields = all_solution_fields);
SolveReply decode_solve_reply(const nlohmann::json& result, const Frames& frames);
SolveReply decode_solve_reply(const AnswerValue& result, const Frames& frames);

// --- contact.solve_many ----------------------------------------------------------------------------------------------
nlohmann::json encode_problems(std::span<const ContactProblem> problems, ArrayWriter& arrays,
                               const SolutionFields& fields = all_solution_fields);
/// `problems` have passed their schema; decode_problem decodes them one by one. Throws StatusError (LIMIT_EXCEEDED) if
/// all their arrays together, counting a frame for each reference, have more than limits.max_array_elements, because
/// each problem gets its own arrays.
void check_referred_elements(const nlohmann::json& problems, const MessageLimits& limits = {});

/// Holds a result with its frames, or the reason why there is none.
struct Result {
    std::shared_ptr<const std::string> text;  ///< the result, as JSON
    Frames frames;
};
using ResultOrStatus = std::variant<Result, Status>;
/// A reply with a number that is not finite cannot be sent and becomes INTERNAL.
ResultOrStatus encode_outcome(const SolveReply& reply, const Grid& grid, ArrayEncoding encoding,
                              const SolutionFields& fields = all_solution_fields);
/// Returns the text of {list: [{status, result}, ...]} for a method with several parts. Moves the frames to `frames`,
/// one after the other.
std::string encode_results(std::string_view list, std::vector<ResultOrStatus> results, Frames& frames);
std::vector<ReplyOrStatus> decode_solve_replies(const nlohmann::json& result, const Frames& frames);

// --- contact.subsurface ----------------------------------------------------------------------------------------------
nlohmann::json encode_subsurface_request(const SubsurfaceRequest& request, ArrayWriter& arrays);
/// `params` has passed its schema. Throws StatusError naming the field for a grid or points that are too large
/// (LIMIT_EXCEEDED; all arrays of the result together have at most limits.max_array_elements), before memory is
/// allocated, for arrays that do not match and for a body that is not a half-space; contactd::subsurface_stress checks
/// the rest.
SubsurfaceRequest decode_subsurface_request(const nlohmann::json& params, const Frames& frames,
                                            const MessageLimits& limits = {});
nlohmann::json encode_subsurface_reply(const SubsurfaceReply& reply, ArrayWriter& arrays);
SubsurfaceReply decode_subsurface_reply(const nlohmann::json& result, const Frames& frames);

// --- contact.temperature ---------------------------------------------------------------------------------------------
nlohmann::json encode_temperature_request(const TemperatureRequest& request, ArrayWriter& arrays);
/// `params` has passed its schema. Throws StatusError naming the field for a grid that is too large and for arrays that
/// do not match; contactd::surface_temperature checks the rest.
TemperatureRequest decode_temperature_request(const nlohmann::json& params, const Frames& frames);
nlohmann::json encode_temperature_reply(const SurfaceTemperatures& reply, const Grid& grid, ArrayWriter& arrays);
SurfaceTemperatures decode_temperature_reply(const nlohmann::json& result, const Grid& grid, const Frames& frames);

// --- ic.export -------------------------------------------------------------------------------------------------------
nlohmann::json encode_ic_export(const IcExport& requested);
/// `params` has passed its schema.
IcExport decode_ic_export(const nlohmann::json& params);
nlohmann::json encode_hdf5_reply(std::span<const unsigned char> file, const IcUse& body, ArrayWriter& arrays);
nlohmann::json encode_contact_text_reply(std::string text, const IcUse& upper, const IcUse& lower);
/// Reads the file in either format. Throws StatusError (ARRAY_INVALID).
std::string decode_ic_file(const nlohmann::json& result, const Frames& frames);

}  // namespace contactd::proto
