// `ics` of a request, and the mesh that evidence speaks of.
#include <algorithm>
#include <array>

#include "codec_parts.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr double default_accuracy = 1e-3;

/// Whether the request names a mesh or a solver. The size of a block belongs to the body.
bool names_a_mesh(const json& ics, BodyShape body) {
    constexpr std::array others{"source", "body", "load_shape", "line_contact", "accuracy", "any_nu"};
    return std::any_of(ics.items().begin(), ics.items().end(), [&](const auto& member) {
        if (member.key() == "L_over_h") return body == BodyShape::half_space;
        return std::find(others.begin(), others.end(), member.key()) == others.end();
    });
}

FemSpec named_mesh(const json& ics, BodyShape body) {
    FemSpec fem;
    if (body == BodyShape::block) fem.far_boundary = FarBoundary::clamped;
    if (ics.contains("preset")) {
        const auto preset = fem_preset(ics["preset"].get<std::string>());
        if (!preset) throw invalid_field("ics.preset", "is " + ics["preset"].dump() + "; there is no such preset");
        fem = *preset;
    }
    decode_fem(ics, fem);
    return fem;
}

}  // namespace

json encode_fem(const FemSpec& fem) {
    json result{{"mesh", name_of(fem.mesh)},
                {"order", fem.order},
                {"l_over_h", finite(fem.l_over_h, "l_over_h")},
                {"h_over_hs", finite(fem.h_over_hs, "h_over_hs")},
                {"f", finite(fem.f, "f")},
                {"t1_over_hs", finite(fem.t1_over_hs, "t1_over_hs")},
                {"L_over_h", finite(fem.L_over_h, "L_over_h")},
                {"diagonal", name_of(fem.diagonal)},
                {"max_dofs", fem.max_dofs},
                {"far_boundary", name_of(fem.far_boundary)},
                {"sampling", name_of(fem.sampling)},
                {"solver", name_of(fem.solver)},
                {"stop_test", name_of(fem.stop_test)},
                {"tolerance", finite(fem.tolerance, "tolerance")},
                {"max_iterations", fem.max_iterations}};
    if (fem.strength_threshold) result["strength_threshold"] = finite(*fem.strength_threshold, "strength_threshold");
    return result;
}

void decode_fem(const json& source, FemSpec& fem) {
    const auto read = [&](const char* name, auto& value) {
        if (source.contains(name)) read_name(source[name], value);
    };
    read("mesh", fem.mesh);
    read("diagonal", fem.diagonal);
    read("far_boundary", fem.far_boundary);
    read("sampling", fem.sampling);
    read("solver", fem.solver);
    read("stop_test", fem.stop_test);
    fem.order = source.value("order", fem.order);
    fem.l_over_h = source.value("l_over_h", fem.l_over_h);
    fem.h_over_hs = source.value("h_over_hs", fem.h_over_hs);
    fem.f = source.value("f", fem.f);
    fem.t1_over_hs = source.value("t1_over_hs", fem.t1_over_hs);
    fem.L_over_h = source.value("L_over_h", fem.L_over_h);
    fem.max_dofs = source.value("max_dofs", fem.max_dofs);
    fem.tolerance = source.value("tolerance", fem.tolerance);
    fem.max_iterations = source.value("max_iterations", fem.max_iterations);
    if (source.contains("strength_threshold")) fem.strength_threshold = source["strength_threshold"].get<double>();
}

json encode_ics(const Ics& ics) {
    json result{{"source", name_of(ics.source)}, {"body", name_of(ics.body)}, {"load_shape", name_of(ics.load_shape)}};
    if (ics.line_contact) result["line_contact"] = {{"datum", finite(ics.line_contact->datum, "datum")}};
    if (ics.source == IcSource::analytic) return result;
    if (ics.accuracy != 0) {
        result["accuracy"] = finite(ics.accuracy, "accuracy");
        if (ics.body == BodyShape::block) result["L_over_h"] = finite(ics.fem.L_over_h, "L_over_h");
    } else {
        result.update(encode_fem(ics.fem));
    }
    result["any_nu"] = ics.any_nu;
    return result;
}

Ics decode_ics(const json& source) {
    Ics ics;
    read_name(source["source"], ics.source);
    if (source.contains("body")) read_name(source["body"], ics.body);
    if (source.contains("load_shape")) read_name(source["load_shape"], ics.load_shape);
    if (source.contains("line_contact"))
        ics.line_contact = LineContactSpec{source["line_contact"]["datum"].get<double>()};
    if (ics.source == IcSource::analytic) return ics;
    ics.any_nu = source.value("any_nu", false);
    if (!source.contains("accuracy") && names_a_mesh(source, ics.body)) {
        ics.fem = named_mesh(source, ics.body);
        return ics;
    }
    ics.accuracy = source.value("accuracy", default_accuracy);
    ics.fem.L_over_h = source.value("L_over_h", ics.fem.L_over_h);
    return ics;
}

}  // namespace contactd::proto
