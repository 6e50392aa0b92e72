// Encodes and decodes the arrays of a solution that a request selects.
#include "codec_parts.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/fields/grid_arrays.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "field_text.hpp"
#include "wire/json_access.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

/// Returns the numbers of an array that does not consist of bytes.
template <class Solution>
auto& numbers_of(SolutionField array, Solution& solution) {
    return solution.*solution_arrays[static_cast<std::size_t>(array)];
}

std::vector<unsigned char> bytes_of(const std::vector<ElementState>& states) {
    std::vector<unsigned char> bytes;
    bytes.reserve(states.size());
    for (const ElementState state : states) bytes.push_back(static_cast<unsigned char>(state));
    return bytes;
}

std::vector<ElementState> states_of(const std::vector<unsigned char>& bytes) {
    std::vector<ElementState> states;
    states.reserve(bytes.size());
    for (const unsigned char byte : bytes) {
        if (byte > static_cast<unsigned char>(ElementState::flow))
            throw invalid_field("element_division", "contains " + std::to_string(byte) + "; it must be 0, 1 or 2",
                                reason::array_invalid);
        states.push_back(static_cast<ElementState>(byte));
    }
    return states;
}

}  // namespace

json encode_fields(const SolutionFields& fields) {
    return write_fields(fields, MemberPath("fields"));
}

SolutionFields decode_fields(const json& params, const SolutionFields& otherwise) {
    const auto named = params.find("fields");
    if (named == params.end()) return otherwise;
    SolutionFields fields;
    read_fields(*named, fields, MemberPath("fields"));
    return fields;
}

json encode_problem(const ContactProblem& problem, ArrayWriter& arrays, const SolutionFields& fields) {
    json params = encode_problem(problem, arrays);
    if (fields != all_solution_fields) params["fields"] = encode_fields(fields);
    return params;
}

void encode_arrays(const ContactSolution& solution, const SolutionFields& fields, const Grid& grid, ArrayWriter& arrays,
                   json& result) {
    for (const SolutionField field : fields) {
        const std::string name(name_of(field));
        if (result.contains(name)) continue;  // requested twice
        if (field == SolutionField::element_division) {
            const std::vector<unsigned char> division = bytes_of(solution.element_division);
            result[name] = arrays.write(std::span<const unsigned char>(division), shape_of(grid));
        } else if (const auto& values = numbers_of(field, solution); !values.empty()) {  // slip: friction only
            result[name] = arrays.write(std::span<const double>(values), shape_of(grid));
        }
    }
}

void append_arrays(std::string& text, const ContactSolution& solution, const SolutionFields& fields, const Grid& grid,
                   ArrayWriter& arrays) {
    if (fields.empty()) return;
    json written = json::object();
    encode_arrays(solution, fields, grid, arrays, written);
    for (const auto& [name, array] : written.items()) {
        append_name(text, name);
        text += dump(array);
    }
}

namespace {

template <class Source>
void read_arrays(const Source& result, const Frames& frames, std::vector<std::size_t>& shape,
                 ContactSolution& solution) {
    for (const SolutionField field : all_solution_fields) {
        const std::string name(name_of(field));
        const auto given = member_of(result, name);
        if (!given) continue;
        const json& array = as_json(*given);
        if (shape.empty()) shape = claimed_shape(array, 2);
        if (shape.size() != 2)
            throw invalid_field(name, "has " + std::to_string(shape.size()) + " dimensions; it must have 2",
                                reason::array_invalid);
        if (field == SolutionField::element_division)
            solution.element_division = states_of(read_byte_array(array, frames, shape, name));
        else
            numbers_of(field, solution) = read_array(array, frames, shape, name);
    }
}

}  // namespace

void decode_arrays(const json& result, const Frames& frames, std::vector<std::size_t> shape,
                   ContactSolution& solution) {
    read_arrays(result, frames, shape, solution);
}

void decode_arrays(const AnswerValue& result, const Frames& frames, std::vector<std::size_t> shape,
                   ContactSolution& solution) {
    read_arrays(result, frames, shape, solution);
}

}  // namespace contactd::proto
