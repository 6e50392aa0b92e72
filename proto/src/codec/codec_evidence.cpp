#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/object.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

json encode_errors(const IcErrors& errors) {
    json result = json::object();
    const auto component = [&](const char* name, const std::optional<ComponentError>& error) {
        if (error)
            result[name] = object({{"origin", finite(error->origin, "An error at the origin")},
                                   {"largest", finite(error->largest, "A largest error")}});
    };
    const auto scaled = [&](const char* name, const std::optional<double>& error) {
        if (error) result[name] = finite(*error, "A scaled error");
    };
    component("xx", errors.xx);
    component("yy", errors.yy);
    component("zz", errors.zz);
    scaled("scaled_xy", errors.scaled_xy);
    scaled("scaled_xz", errors.scaled_xz);
    return result;
}

IcErrors decode_errors(const json& source) {
    IcErrors errors;
    const auto component = [&](const char* name, std::optional<ComponentError>& error) {
        if (source.contains(name))
            error = ComponentError{source[name]["origin"].get<double>(), source[name]["largest"].get<double>()};
    };
    const auto scaled = [&](const char* name, std::optional<double>& error) {
        if (source.contains(name)) error = source[name].get<double>();
    };
    component("xx", errors.xx);
    component("yy", errors.yy);
    component("zz", errors.zz);
    scaled("scaled_xy", errors.scaled_xy);
    scaled("scaled_xz", errors.scaled_xz);
    return errors;
}

json encode_load_case(const LoadCaseEvidence& load_case) {
    json result = object({{"load", name_of(load_case.load)},
                          {"iterations", load_case.iterations},
                          {"residual", finite(load_case.residual, "The residual of a load case")},
                          {"converged", load_case.converged},
                          {"seconds", finite(load_case.seconds, "The duration of a load case")}});
    if (load_case.update) result["update"] = finite(*load_case.update, "The last update of a load case");
    return result;
}

LoadCaseEvidence decode_load_case(const json& source) {
    LoadCaseEvidence load_case;
    read_name(source["load"], load_case.load);
    load_case.iterations = source["iterations"].get<int>();
    load_case.residual = source["residual"].get<double>();
    load_case.converged = source["converged"].get<bool>();
    load_case.seconds = source["seconds"].get<double>();
    if (source.contains("update")) load_case.update = source["update"].get<double>();
    return load_case;
}

json encode_family(const std::vector<double>& family_nu) {
    json result = json::array();
    for (const double nu : family_nu) result.push_back(finite(nu, "Poisson's ratio of a family"));
    return result;
}

/// What is there to say of a table that was computed, not taken from a closed form or a request.
void encode_build(const IcEvidence& evidence, json& result) {
    json load_cases = json::array();
    for (const LoadCaseEvidence& load_case : evidence.load_cases) load_cases.push_back(encode_load_case(load_case));
    result["elements"] = evidence.elements;
    result["dofs"] = evidence.dofs;
    result["processes"] = evidence.processes;
    result["seconds"] = object({{"assembly", finite(evidence.seconds.assembly, "The duration of the assembly")},
                                {"setup", finite(evidence.seconds.setup, "The duration of the setup")},
                                {"solve", finite(evidence.seconds.solve, "The duration of the solves")},
                                {"total", finite(evidence.seconds.total, "The duration of the build")}});
    result["load_cases"] = std::move(load_cases);
}

void decode_build(const json& source, IcEvidence& evidence) {
    if (source.contains("elements")) evidence.elements = source["elements"].get<long long>();
    if (source.contains("dofs")) evidence.dofs = source["dofs"].get<long long>();
    if (source.contains("processes")) evidence.processes = source["processes"].get<int>();
    if (source.contains("seconds")) {
        const auto& seconds = source["seconds"];
        evidence.seconds = {seconds["assembly"].get<double>(), seconds["setup"].get<double>(),
                            seconds["solve"].get<double>(), seconds["total"].get<double>()};
    }
    if (source.contains("load_cases"))
        for (const auto& load_case : source["load_cases"]) evidence.load_cases.push_back(decode_load_case(load_case));
    if (source.contains("errors")) evidence.errors = decode_errors(source["errors"]);
    evidence.errors_estimated = source.value("errors_estimated", false);
}

json encode_section_evidence(const SectionEvidence& section) {
    return object({{"order", section.order},
                   {"wavenumbers", section.wavenumbers},
                   {"error", finite(section.error, "The error of a prism's table")},
                   {"mesh_error", finite(section.mesh_error, "The error of a mesh")},
                   {"wavenumber_error", finite(section.wavenumber_error, "The error between wavenumbers")},
                   {"end_error", finite(section.end_error, "The error beyond the last wavenumber")},
                   {"reciprocity_defect", finite(section.reciprocity_defect, "The defect of reciprocity")}});
}

SectionEvidence decode_section_evidence(const json& source) {
    return {source["order"].get<int>(),
            source["wavenumbers"].get<int>(),
            source["error"].get<double>(),
            source["mesh_error"].get<double>(),
            source["wavenumber_error"].get<double>(),
            source["end_error"].get<double>(),
            source["reciprocity_defect"].get<double>()};
}

}  // namespace

json encode_evidence(const IcEvidence& evidence) {
    json result = object({{"source", evidence.source}, {"version", evidence.version}});
    if (evidence.elements > 0) encode_build(evidence, result);
    if ((evidence.elements > 0 && !evidence.section) || evidence.errors.zz) {  // of a closed form there are none
        result["errors"] = encode_errors(evidence.errors);
        result["errors_estimated"] = evidence.errors_estimated;
    }
    if (evidence.imported) result["imported"] = true;
    if (!evidence.warnings.empty()) result["warnings"] = evidence.warnings;
    if (!evidence.solver.empty()) result["solver"] = evidence.solver;
    if (evidence.mesh) result["mesh"] = encode_fem(*evidence.mesh);
    if (!evidence.family_nu.empty()) result["family_nu"] = encode_family(evidence.family_nu);
    if (evidence.interpolation_error)
        result["interpolation_error"] = finite(*evidence.interpolation_error, "The error of interpolation");
    if (evidence.modelling_error)
        result["modelling_error"] = finite(*evidence.modelling_error, "The modelling error of a block");
    if (evidence.section) result["section"] = encode_section_evidence(*evidence.section);
    return result;
}

IcEvidence decode_evidence(const json& source) {
    IcEvidence evidence;
    evidence.source = source["source"].get<std::string>();
    evidence.version = source["version"].get<std::string>();
    decode_build(source, evidence);
    evidence.imported = source.value("imported", false);
    evidence.warnings = source.value("warnings", std::vector<std::string>());
    evidence.solver = source.value("solver", std::string());
    evidence.family_nu = source.value("family_nu", std::vector<double>());
    if (source.contains("mesh")) decode_fem(source["mesh"], evidence.mesh.emplace());
    if (source.contains("interpolation_error"))
        evidence.interpolation_error = source["interpolation_error"].get<double>();
    if (source.contains("modelling_error")) evidence.modelling_error = source["modelling_error"].get<double>();
    if (source.contains("section")) evidence.section = decode_section_evidence(source["section"]);
    return evidence;
}

}  // namespace contactd::proto
