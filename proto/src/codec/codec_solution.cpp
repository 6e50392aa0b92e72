// Results of contact.solve.
#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;
using Shape = std::vector<std::size_t>;

json encode_solver_evidence(const SolverEvidence& evidence) {
    return object({{"iterations", evidence.iterations},
                   {"residual", finite(evidence.residual, "The residual of a solve")},
                   {"converged", evidence.converged},
                   {"seconds", finite(evidence.seconds, "The duration of a solve")}});
}

SolverEvidence decode_solver_evidence(const json& source) {
    return {source["iterations"].get<int>(), source["residual"].get<double>(), source["converged"].get<bool>(),
            source["seconds"].get<double>()};
}

constexpr Words<ErrorSource, 2> error_sources{{{"hertz", ErrorSource::hertz}, {"estimate", ErrorSource::estimate}}};

json encode_discretisation(const Discretisation& evidence) {
    json result = object({{"elements_across", evidence.elements_across},
                          {"force_error", finite(evidence.force_error, "An error of the force")},
                          {"pmax_error", finite(evidence.pmax_error, "An error of the largest pressure")},
                          {"source", word_for(error_sources, evidence.source)}});
    if (evidence.rolling_error) result["rolling_error"] = finite(*evidence.rolling_error, "An error of rolling");
    return result;
}

Discretisation decode_discretisation(const json& source) {
    Discretisation evidence{source["elements_across"].get<int>(), source["force_error"].get<double>(),
                            source["pmax_error"].get<double>(), meaning_of(source["source"], error_sources)};
    if (source.contains("rolling_error")) evidence.rolling_error = source["rolling_error"].get<double>();
    return evidence;
}

IcUse decode_use(const json& source) {
    return {source["origin"].get<std::string>(), source["key"].get<std::string>(), decode_evidence(source["evidence"])};
}

/// Uses may be const.
template <class Uses>
auto parts_of(Uses& uses) {
    return std::array{std::pair("upper", &uses.upper), std::pair("lower", &uses.lower), std::pair("pair", &uses.pair)};
}

/// The solvers that need not have run, with their names; Evidence may be const.
template <class Evidence>
auto solvers_of(Evidence& evidence) {
    return std::array{std::pair("tangential", &evidence.tangential), std::pair("outer", &evidence.outer),
                      std::pair("force", &evidence.force)};
}

template <class Solution>
auto dissipation_of(Solution& solution) {
    return std::array{std::pair("frictional_work", &solution.frictional_work),
                      std::pair("frictional_power", &solution.frictional_power)};
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

json encode_totals(const ContactSolution& solution) {
    return object({{"approach", finite(solution.approach, "The approach")},
                   {"forces", object({{"Fn", finite(solution.forces.Fn, "Fn")},
                                      {"Fx", finite(solution.forces.Fx, "Fx")},
                                      {"Fy", finite(solution.forces.Fy, "Fy")},
                                      {"Mz", finite(solution.forces.Mz, "Mz")}})},
                   {"pmax", finite(solution.pmax, "pmax")},
                   {"area", object({{"contact", finite(solution.area.contact, "The contact area")},
                                    {"adhesion", finite(solution.area.adhesion, "The adhesion area")},
                                    {"slip", finite(solution.area.slip, "The slip area")}})},
                   {"elements", object({{"contact", solution.elements.contact},
                                        {"adhesion", solution.elements.adhesion},
                                        {"slip", solution.elements.slip},
                                        {"border", solution.elements.border}})},
                   {"warnings", solution.warnings},
                   {"converged", solution.converged()}});
}

void decode_totals(const json& result, ContactSolution& solution) {
    const json &forces = result["forces"], &area = result["area"], &elements = result["elements"];
    solution.approach = result["approach"].get<double>();
    solution.forces = {forces["Fn"].get<double>(), forces["Fx"].get<double>(), forces["Fy"].get<double>(),
                       forces["Mz"].get<double>()};
    solution.pmax = result["pmax"].get<double>();
    solution.area = {area["contact"].get<double>(), area["adhesion"].get<double>(), area["slip"].get<double>()};
    solution.elements = {elements["contact"].get<int>(), elements["adhesion"].get<int>(), elements["slip"].get<int>(),
                         elements["border"].get<int>()};
    solution.warnings = result["warnings"].get<std::vector<std::string>>();
}

/// What there is with friction only; a step that the request left out is told.
json encode_friction_results(const ContactSolution& solution, const Grid& grid) {
    json result = json::object();
    for (const auto& [name, value] : dissipation_of(solution))
        if (*value) result[name] = finite(**value, "What friction dissipates");
    if (!solution.motion) return result;
    result["motion"] = encode_motion(*solution.motion);
    if (const auto* rolling = std::get_if<Rolling>(&*solution.motion))
        result["motion"]["dq"] = finite(step_length(*rolling, grid), "friction.rolling.dq");
    return result;
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
    json result = encode_totals(solution);
    result.update(encode_friction_results(solution, grid));
    return result;
}

void decode_summary(const json& result, ContactSolution& solution) {
    decode_totals(result, solution);
    for (const auto& [name, value] : dissipation_of(solution))
        if (result.contains(name)) *value = result[name].get<double>();
    if (result.contains("motion")) solution.motion = decode_motion(result["motion"]);
}

json encode_evidence(const ContactEvidence& evidence) {
    json result = object({{"normal", encode_solver_evidence(evidence.normal)}});
    for (const auto& [name, solver] : solvers_of(evidence))
        if (*solver) result[name] = encode_solver_evidence(**solver);
    if (evidence.discretisation) result["discretisation"] = encode_discretisation(*evidence.discretisation);
    return result;
}

ContactEvidence decode_contact_evidence(const json& source) {
    ContactEvidence evidence;
    evidence.normal = decode_solver_evidence(source["normal"]);
    for (const auto& [name, solver] : solvers_of(evidence))
        if (source.contains(name)) *solver = decode_solver_evidence(source[name]);
    if (source.contains("discretisation")) evidence.discretisation = decode_discretisation(source["discretisation"]);
    return evidence;
}

json encode_division(const ContactSolution& solution, const Grid& grid, ArrayWriter& arrays) {
    const std::vector<unsigned char> division = bytes_of(solution.element_division);
    return arrays.write(std::span<const unsigned char>(division), shape_of(grid));
}

std::vector<ElementState> decode_division(const json& result, const std::vector<std::string>& frames,
                                          const std::vector<std::size_t>& shape) {
    return states_of(read_byte_array(result["element_division"], frames, shape, "element_division"));
}

json encode_solve_reply(const SolveReply& reply, const Grid& grid, ArrayWriter& arrays) {
    const ContactSolution& solution = reply.solution;
    json result = encode_summary(solution, grid);
    result["evidence"] = encode_evidence(solution.evidence);
    result["evidence"]["ics"] = encode_uses(reply.ics);
    const auto add = [&](const char* name, const std::vector<double>& values) {
        result[name] = arrays.write(std::span<const double>(values), shape_of(grid));
    };
    result["element_division"] = encode_division(solution, grid, arrays);
    add("pressure", solution.pressure);
    add("traction_x", solution.traction_x);
    add("traction_y", solution.traction_y);
    if (!solution.slip_x.empty()) add("slip_x", solution.slip_x);
    if (!solution.slip_y.empty()) add("slip_y", solution.slip_y);
    return result;
}

SolveReply decode_solve_reply(const json& result, const std::vector<std::string>& frames) {
    SolveReply reply;
    ContactSolution& solution = reply.solution;
    decode_summary(result, solution);
    const Shape shape = claimed_shape(result["pressure"], 2);
    if (shape.size() != 2)
        throw invalid_field("pressure", "has " + std::to_string(shape.size()) + " dimensions; it must have 2",
                            reason::array_invalid);
    const auto array = [&](const char* name) { return read_array(result[name], frames, shape, name); };
    solution.pressure = array("pressure");
    solution.traction_x = array("traction_x");
    solution.traction_y = array("traction_y");
    if (result.contains("slip_x")) solution.slip_x = array("slip_x");
    if (result.contains("slip_y")) solution.slip_y = array("slip_y");
    solution.element_division = decode_division(result, frames, shape);
    solution.evidence = decode_contact_evidence(result["evidence"]);
    reply.ics = decode_uses(result["evidence"]["ics"]);
    return reply;
}

}  // namespace contactd::proto
