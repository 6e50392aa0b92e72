// Results of contact.solve.
#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr Words<ErrorSource, 2> error_sources{{{"hertz", ErrorSource::hertz}, {"estimate", ErrorSource::estimate}}};

json encode_discretisation(const Discretisation& evidence) {
    json result = object({{"elements_across", evidence.elements_across},
                          {"force_error", finite(evidence.force_error, "An error of the force")},
                          {"pmax_error", finite(evidence.pmax_error, "An error of the largest pressure")},
                          {"source", word_for(error_sources, evidence.source)}});
    if (evidence.rolling_error) result["rolling_error"] = finite(*evidence.rolling_error, "An error of rolling");
    if (evidence.compliance_ratio)
        result["compliance_ratio"] = finite(*evidence.compliance_ratio, "The ratio of compliances");
    return result;
}

Discretisation decode_discretisation(const json& source) {
    Discretisation evidence{source["elements_across"].get<int>(), source["force_error"].get<double>(),
                            source["pmax_error"].get<double>(), meaning_of(source["source"], error_sources)};
    if (source.contains("rolling_error")) evidence.rolling_error = source["rolling_error"].get<double>();
    if (source.contains("compliance_ratio")) evidence.compliance_ratio = source["compliance_ratio"].get<double>();
    return evidence;
}

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

/// The solvers that need not have run, with their names; Evidence may be const.
template <class Evidence>
auto solvers_of(Evidence& evidence) {
    return std::array{std::pair("tangential", &evidence.tangential), std::pair("outer", &evidence.outer),
                      std::pair("force", &evidence.force), std::pair("derivatives", &evidence.derivatives)};
}

template <class Solution>
auto dissipation_of(Solution& solution) {
    return std::array{std::pair("frictional_work", &solution.frictional_work),
                      std::pair("frictional_power", &solution.frictional_power)};
}

json encode_totals(const ContactSolution& solution) {
    json result = object({{"approach", finite(solution.approach, "The approach")},
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
    if (solution.resultant) result["resultant"] = encode_resultant(*solution.resultant);
    return result;
}

void decode_totals(const json& result, ContactSolution& solution) {
    const json &forces = result["forces"], &area = result["area"], &elements = result["elements"];
    solution.approach = result["approach"].get<double>();
    solution.forces = {forces["Fn"].get<double>(), forces["Fx"].get<double>(), forces["Fy"].get<double>(),
                       forces["Mz"].get<double>()};
    if (result.contains("resultant")) solution.resultant = decode_resultant(result["resultant"]);
    solution.pmax = result["pmax"].get<double>();
    solution.area = {area["contact"].get<double>(), area["adhesion"].get<double>(), area["slip"].get<double>()};
    solution.elements = {elements["contact"].get<int>(), elements["adhesion"].get<int>(), elements["slip"].get<int>(),
                         elements["border"].get<int>()};
    solution.warnings = result["warnings"].get<std::vector<std::string>>();
}

/// What there is with friction only; a step that the request left out is told.
void add_friction_results(const ContactSolution& solution, const Grid& grid, json& result) {
    for (const auto& [name, value] : dissipation_of(solution))
        if (*value) result[name] = finite(**value, "What friction dissipates");
    if (!solution.motion) return;
    json& motion = result["motion"];
    try {
        motion = encode_motion(*solution.motion);
    } catch (const InvalidArgument& error) {
        throw Error(error.what());  // found, not asked for
    }
    if (const auto* rolling = std::get_if<Rolling>(&*solution.motion))
        motion["dq"] = finite(step_length(*rolling, grid), "friction.rolling.dq");
}

}  // namespace

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
    add_friction_results(solution, grid, result);
    if (solution.derivatives) result["derivatives"] = encode_derivatives(*solution.derivatives);
    return result;
}

void decode_summary(const json& result, ContactSolution& solution) {
    decode_totals(result, solution);
    for (const auto& [name, value] : dissipation_of(solution))
        if (result.contains(name)) *value = result[name].get<double>();
    if (result.contains("motion")) solution.motion = decode_motion(result["motion"]);
    if (result.contains("derivatives")) solution.derivatives = decode_derivatives(result["derivatives"]);
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

json encode_solve_reply(const SolveReply& reply, const Grid& grid, ArrayWriter& arrays, const SolutionFields& fields) {
    json result = encode_summary(reply.solution, grid);
    result["evidence"] = encode_evidence(reply.solution.evidence);
    result["evidence"]["ics"] = encode_uses(reply.ics);
    if (reply.operators) result["evidence"]["operators"] = encode_operators(*reply.operators);
    encode_arrays(reply.solution, fields, grid, arrays, result);
    return result;
}

SolveReply decode_solve_reply(const json& result, const Frames& frames) {
    SolveReply reply;
    decode_summary(result, reply.solution);
    decode_arrays(result, frames, {}, reply.solution);
    reply.solution.evidence = decode_contact_evidence(result["evidence"]);
    reply.ics = decode_uses(result["evidence"]["ics"]);
    if (result["evidence"].contains("operators")) reply.operators = decode_operators(result["evidence"]["operators"]);
    return reply;
}

}  // namespace contactd::proto
