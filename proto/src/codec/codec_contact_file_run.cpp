// contact_file.run and contact_file.convert: cases of the CONTACT program after a run.
#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "codec_parts.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/contact_file.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/grid.hpp"
#include "contactd/proto/wheel_rail.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 7> statuses{"solved", "not converged", "read", "refused",
                                                   "failed", "follows",       "wrong"};

/// Writes displacements and stresses of a block by CONTACT's names.
template <class Block>
auto values_of_block(Block& block) {
    return std::array{std::pair("UX", &block.displacement.x), std::pair("UY", &block.displacement.y),
                      std::pair("UZ", &block.displacement.z), std::pair("SIGXX", &block.stress.xx),
                      std::pair("SIGXY", &block.stress.xy),   std::pair("SIGXZ", &block.stress.xz),
                      std::pair("SIGYY", &block.stress.yy),   std::pair("SIGYZ", &block.stress.yz),
                      std::pair("SIGZZ", &block.stress.zz)};
}

template <class Block>
auto axes_of_block(Block& block) {
    return std::array{std::pair("X", &block.points.x), std::pair("Y", &block.points.y),
                      std::pair("Z", &block.points.z)};
}

json encode_block(const ContactFileBlock& block, ArrayWriter& arrays) {
    json encoded;
    for (const auto& [name, values] : axes_of_block(block))
        encoded[name] = arrays.write(std::span<const double>(*values), {values->size()});
    const auto& [x, y, z] = block.points;
    for (const auto& [name, values] : values_of_block(block))
        encoded[name] = arrays.write(std::span<const double>(*values), {z.size(), y.size(), x.size()});
    return encoded;
}

ContactFileBlock decode_block(const json& encoded, const Frames& frames) {
    ContactFileBlock block;
    for (const auto& [name, values] : axes_of_block(block))
        *values = read_array(encoded.at(name), frames, claimed_shape(encoded.at(name), 1), name);
    const auto& [x, y, z] = block.points;
    for (const auto& [name, values] : values_of_block(block))
        *values = read_array(encoded.at(name), frames, {z.size(), y.size(), x.size()}, name);
    return block;
}

json encode_patch(const ContactFilePatch& patch, bool with_arrays, ArrayWriter& arrays) {
    json encoded = {{"grid", encode_grid(patch.grid)},
                    {"numbers", patch.numbers},
                    {"mu", patch.mu},
                    {"friction_bound", patch.friction_bound}};
    if (patch.previous) encoded["previous"] = *patch.previous;
    if (!with_arrays) return encoded;
    for (const auto& [name, values] : patch.arrays)
        encoded["arrays"][name] = arrays.write(std::span<const double>(values), shape_of(patch.grid));
    encoded["blocks"] = json::array();
    for (const ContactFileBlock& block : patch.blocks) encoded["blocks"].push_back(encode_block(block, arrays));
    return encoded;
}

ContactFilePatch decode_patch(const json& encoded, const Frames& frames) {
    ContactFilePatch patch;
    patch.grid = decode_grid(encoded.at("grid"));
    encoded.at("numbers").get_to(patch.numbers);
    encoded.at("mu").get_to(patch.mu);
    encoded.at("friction_bound").get_to(patch.friction_bound);
    if (encoded.contains("previous")) patch.previous = encoded["previous"].get<std::vector<int>>();
    if (encoded.contains("arrays"))
        for (const auto& [name, values] : encoded["arrays"].items())
            patch.arrays[name] = read_array(values, frames, shape_of(patch.grid), name);
    if (encoded.contains("blocks"))
        for (const json& block : encoded["blocks"]) patch.blocks.push_back(decode_block(block, frames));
    return patch;
}

/// Returns the identification, status and sentence of a case.
json encode_case_status(const ContactFileOutcome& outcome) {
    json encoded = {{"number", outcome.number},
                    {"line", outcome.line},
                    {"module", outcome.module_number},
                    {"status", statuses.at(static_cast<std::size_t>(outcome.status))},
                    {"sentence", outcome.sentence}};
    if (outcome.reid) encoded["reid"] = *outcome.reid;
    if (outcome.cpid) encoded["cpid"] = *outcome.cpid;
    return encoded;
}

ContactFileOutcome decode_case_status(const json& encoded) {
    ContactFileOutcome outcome;
    encoded.at("number").get_to(outcome.number);
    encoded.at("line").get_to(outcome.line);
    encoded.at("module").get_to(outcome.module_number);
    if (encoded.contains("reid")) outcome.reid = encoded["reid"].get<int>();
    if (encoded.contains("cpid")) outcome.cpid = encoded["cpid"].get<int>();
    const auto found = std::ranges::find(statuses, encoded.at("status").get_ref<const std::string&>());
    outcome.status = static_cast<ContactFileStatus>(std::distance(statuses.begin(), found));
    encoded.at("sentence").get_to(outcome.sentence);
    return outcome;
}

}  // namespace

json encode_contact_file_input(const ContactFileInput& input) {
    json params = {{"text", input.text}, {"name", input.name}, {"max_elements", input.max_elements}};
    for (const auto& [name, text, failure] : input.files)
        params["files"].push_back(failure.empty() ? json{{"name", name}, {"text", text}}
                                                  : json{{"name", name}, {"failure", failure}});
    if (!input.cases.empty()) params["cases"] = input.cases;
    params["wheel_surface"] = name_of(input.wheel_surface);
    return params;
}

ContactFileInput decode_contact_file_input(const json& params) {
    ContactFileInput input;
    params.at("text").get_to(input.text);
    input.name = params.value("name", input.name);
    for (const json& file : params.value("files", json::array()))
        input.files.push_back({file.at("name"), file.value("text", ""), file.value("failure", "")});
    input.cases = params.value("cases", input.cases);
    for (std::size_t i = 1; i < input.cases.size(); ++i)
        if (input.cases[i] <= input.cases[i - 1])
            throw InvalidArgument("cases", "has " + std::to_string(input.cases[i]) + " behind " +
                                               std::to_string(input.cases[i - 1]) + "; indices must ascend");
    if (params.contains("wheel_surface")) read_name(params["wheel_surface"], input.wheel_surface);
    input.max_elements = params.value("max_elements", input.max_elements);
    return input;
}

json encode_contact_problem(const ContactFileProblem& converted, ArrayWriter& arrays) {
    json encoded = encode_case_status(converted.outcome);
    encoded["continues"] = converted.continues;
    if (const auto* problem = std::get_if<ContactProblem>(&converted.problem))
        encoded["contact"] = encode_problem(*problem, arrays);
    if (const auto* problem = std::get_if<WheelRailProblem>(&converted.problem))
        encoded["wheelrail"] = encode_wheel_rail_request(problem->setup, problem->state, {}, arrays);
    return encoded;
}

ContactFileProblem decode_contact_problem(const json& encoded, const Frames& frames) {
    ContactFileProblem converted{decode_case_status(encoded), encoded.at("continues").get<bool>(), {}};
    if (encoded.contains("contact")) converted.problem = decode_problem(encoded["contact"], frames);
    if (encoded.contains("wheelrail"))
        converted.problem = WheelRailProblem{decode_wheel_rail_setup(encoded["wheelrail"], frames),
                                             read_value<WheelRailState>(encoded["wheelrail"].at("state"), "state")};
    return converted;
}

json encode_contact_outcome(const ContactFileOutcome& outcome, const SolutionFields& fields, bool patch_arrays,
                            ArrayWriter& arrays) {
    json encoded = encode_case_status(outcome);
    encoded["warnings"] = outcome.warnings;
    encoded["seconds"] = outcome.seconds;
    encoded["numbers"] = outcome.numbers;
    if (const auto* reply = std::get_if<SolveReply>(&outcome.solution))
        encoded["contact"] = encode_solve_reply(*reply, outcome.patches.at(0).grid, arrays, fields);
    if (const auto* solution = std::get_if<WheelRailSolution>(&outcome.solution))
        encoded["wheelrail"] = encode_wheel_rail_solution(*solution, {fields, false, true}, arrays);
    encoded["patches"] = json::array();
    for (const ContactFilePatch& patch : outcome.patches)
        encoded["patches"].push_back(encode_patch(patch, patch_arrays, arrays));
    return encoded;
}

ContactFileOutcome decode_contact_outcome(const json& encoded, const Frames& frames) {
    ContactFileOutcome outcome = decode_case_status(encoded);
    encoded.at("warnings").get_to(outcome.warnings);
    encoded.at("seconds").get_to(outcome.seconds);
    encoded.at("numbers").get_to(outcome.numbers);
    if (encoded.contains("contact")) outcome.solution = decode_solve_reply(encoded["contact"], frames);
    if (encoded.contains("wheelrail")) outcome.solution = decode_wheel_rail_solution(encoded["wheelrail"], frames);
    for (const json& patch : encoded.at("patches")) outcome.patches.push_back(decode_patch(patch, frames));
    return outcome;
}

}  // namespace contactd::proto
