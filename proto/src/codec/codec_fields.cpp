// The arrays of a solution, of which a request may want some.
#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr Words<SolutionField, 6> field_names{{{"element_division", SolutionField::element_division},
                                               {"pressure", SolutionField::pressure},
                                               {"traction_x", SolutionField::traction_x},
                                               {"traction_y", SolutionField::traction_y},
                                               {"slip_x", SolutionField::slip_x},
                                               {"slip_y", SolutionField::slip_y}}};

/// An array of doubles of a solution; Solution may be const.
template <class Solution>
auto* array_of(SolutionField field, Solution& solution) {
    switch (field) {
        case SolutionField::pressure:
            return &solution.pressure;
        case SolutionField::traction_x:
            return &solution.traction_x;
        case SolutionField::traction_y:
            return &solution.traction_y;
        case SolutionField::slip_x:
            return &solution.slip_x;
        case SolutionField::slip_y:
            return &solution.slip_y;
        default:
            throw Error("Bytes are no doubles.");
    }
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
        if (byte > static_cast<unsigned char>(ElementState::slip))
            throw invalid_field("element_division", "holds " + std::to_string(byte) + "; it must be 0, 1 or 2",
                                reason::array_invalid);
        states.push_back(static_cast<ElementState>(byte));
    }
    return states;
}

}  // namespace

json encode_fields(const SolutionFields& fields) {
    json names = json::array();
    for (const SolutionField field : fields) names.push_back(word_for(field_names, field));
    return names;
}

SolutionFields decode_fields(const json& params, const SolutionFields& otherwise) {
    const auto named = params.find("fields");
    if (named == params.end()) return otherwise;
    SolutionFields fields;
    for (const json& name : *named) fields.push_back(meaning_of(name, field_names));
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
        const std::string name(word_for(field_names, field));
        if (result.contains(name)) continue;  // asked for twice
        if (field == SolutionField::element_division) {
            const std::vector<unsigned char> division = bytes_of(solution.element_division);
            result[name] = arrays.write(std::span<const unsigned char>(division), shape_of(grid));
        } else if (const auto* values = array_of(field, solution); !values->empty()) {  // slip needs friction
            result[name] = arrays.write(std::span<const double>(*values), shape_of(grid));
        }
    }
}

void decode_arrays(const json& result, const Frames& frames, std::vector<std::size_t> shape,
                   ContactSolution& solution) {
    for (const auto& [word, field] : field_names) {
        const std::string name(word);
        if (!result.contains(name)) continue;
        if (shape.empty()) shape = claimed_shape(result[name], 2);
        if (shape.size() != 2)
            throw invalid_field(name, "has " + std::to_string(shape.size()) + " dimensions; it must have 2",
                                reason::array_invalid);
        if (field == SolutionField::element_division)
            solution.element_division = states_of(read_byte_array(result[name], frames, shape, name));
        else
            *array_of(field, solution) = read_array(result[name], frames, shape, name);
    }
}

}  // namespace contactd::proto
