#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

json encode_errors(const IcEvidence& evidence) {
    json errors = json::object();
    const auto component = [&](const char* name, const std::optional<ComponentError>& error) {
        if (error)
            errors[name] = {{"origin", finite(error->origin, "An error at the origin")},
                            {"largest", finite(error->largest, "A largest error")}};
    };
    const auto scaled = [&](const char* name, const std::optional<double>& error) {
        if (error) errors[name] = finite(*error, "A scaled error");
    };
    component("xx", evidence.error_xx);
    component("yy", evidence.error_yy);
    component("zz", evidence.error_zz);
    scaled("scaled_xy", evidence.scaled_error_xy);
    scaled("scaled_xz", evidence.scaled_error_xz);
    return errors;
}

void decode_errors(const json& errors, IcEvidence& evidence) {
    const auto component = [&](const char* name, std::optional<ComponentError>& error) {
        if (errors.contains(name))
            error = ComponentError{errors[name]["origin"].get<double>(), errors[name]["largest"].get<double>()};
    };
    const auto scaled = [&](const char* name, std::optional<double>& error) {
        if (errors.contains(name)) error = errors[name].get<double>();
    };
    component("xx", evidence.error_xx);
    component("yy", evidence.error_yy);
    component("zz", evidence.error_zz);
    scaled("scaled_xy", evidence.scaled_error_xy);
    scaled("scaled_xz", evidence.scaled_error_xz);
}

json encode_load_case(const LoadCaseEvidence& load_case) {
    return {{"load", name_of(load_case.load)},
            {"iterations", load_case.iterations},
            {"residual", finite(load_case.residual, "The residual of a load case")},
            {"converged", load_case.converged},
            {"seconds", finite(load_case.seconds, "The duration of a load case")}};
}

LoadCaseEvidence decode_load_case(const json& source) {
    Axis load{};
    read_name(source["load"], load);
    return {load, source["iterations"].get<int>(), source["residual"].get<double>(), source["converged"].get<bool>(),
            source["seconds"].get<double>()};
}

}  // namespace

json encode_evidence(const IcEvidence& evidence) {
    json load_cases = json::array();
    for (const LoadCaseEvidence& load_case : evidence.load_cases) load_cases.push_back(encode_load_case(load_case));
    return {{"source", evidence.source},
            {"version", evidence.version},
            {"elements", evidence.elements},
            {"dofs", evidence.dofs},
            {"processes", evidence.processes},
            {"seconds",
             {{"assembly", finite(evidence.assembly_seconds, "The duration of the assembly")},
              {"setup", finite(evidence.setup_seconds, "The duration of the setup")},
              {"solve", finite(evidence.solve_seconds, "The duration of the solves")},
              {"total", finite(evidence.total_seconds, "The duration of the build")}}},
            {"load_cases", std::move(load_cases)},
            {"errors", encode_errors(evidence)}};
}

IcEvidence decode_evidence(const json& source) {
    IcEvidence evidence;
    evidence.source = source["source"].get<std::string>();
    evidence.version = source["version"].get<std::string>();
    evidence.elements = source["elements"].get<long long>();
    evidence.dofs = source["dofs"].get<long long>();
    evidence.processes = source["processes"].get<int>();
    const auto& seconds = source["seconds"];
    evidence.assembly_seconds = seconds["assembly"].get<double>();
    evidence.setup_seconds = seconds["setup"].get<double>();
    evidence.solve_seconds = seconds["solve"].get<double>();
    evidence.total_seconds = seconds["total"].get<double>();
    for (const auto& load_case : source["load_cases"]) evidence.load_cases.push_back(decode_load_case(load_case));
    decode_errors(source["errors"], evidence);
    return evidence;
}

}  // namespace contactd::proto
