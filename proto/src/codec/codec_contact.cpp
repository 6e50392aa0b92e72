// Requests of contact.solve.
#include <array>
#include <cmath>
#include <limits>

#include "codec_parts.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr double flat = std::numeric_limits<double>::infinity();
/// Largest radius that the schema takes.
constexpr double largest_radius = 1e12;

bool fits_the_wire(const Paraboloid& paraboloid) {
    const auto fits = [](double radius) { return radius == flat || std::abs(radius) <= largest_radius; };
    return fits(paraboloid.Rx) && fits(paraboloid.Ry) && (paraboloid.Rx != flat || paraboloid.Ry != flat);
}

}  // namespace

json encode_gap(const Gap& gap, const Grid& grid, ArrayWriter& arrays) {
    const auto sampled_gap = [&](const std::vector<double>& values) {
        return json{{"array", arrays.write(std::span<const double>(values), shape_of(grid))}};
    };
    if (const auto* axes = std::get_if<SemiAxes>(&gap))
        return object({{"semi_axes", object({{"a", finite_field(axes->a, "gap.semi_axes.a")},
                                             {"b", finite_field(axes->b, "gap.semi_axes.b")}})}});
    if (const auto* values = std::get_if<std::vector<double>>(&gap)) return sampled_gap(*values);
    const Paraboloid& paraboloid = std::get<Paraboloid>(gap);
    if (!fits_the_wire(paraboloid)) return sampled_gap(sampled(paraboloid, grid));
    json radii = json::object();
    if (paraboloid.Rx != flat) radii["Rx"] = paraboloid.Rx;
    if (paraboloid.Ry != flat) radii["Ry"] = paraboloid.Ry;
    return object({{"paraboloid", std::move(radii)}});
}

Gap decode_gap(const json& gap, const Frames& frames, const Grid& grid) {
    if (gap.contains("array")) return read_array(gap["array"], frames, shape_of(grid), "gap.array");
    if (gap.contains("semi_axes"))
        return SemiAxes{gap["semi_axes"]["a"].get<double>(), gap["semi_axes"]["b"].get<double>()};
    const json& radii = gap["paraboloid"];
    return Paraboloid{radii.value("Rx", flat), radii.value("Ry", flat)};
}

namespace {

/// The settings of each solver with their names; Settings may be const.
template <class Settings>
auto solvers_of(Settings& settings) {
    return std::array{std::pair("normal", &settings.normal), std::pair("tangential", &settings.tangential),
                      std::pair("outer", &settings.outer)};
}

}  // namespace

void encode_settings(const ContactSettings& settings, json& params) {
    static const ContactSettings defaults;
    const auto of_defaults = solvers_of(defaults);
    const auto given = solvers_of(settings);
    for (std::size_t n = 0; n < given.size(); ++n) {
        const auto& [name, solver] = given[n];
        if (*solver != *of_defaults[n].second)
            params["settings"][name] = object(
                {{"tolerance", finite(solver->tolerance, "A tolerance")}, {"max_iterations", solver->max_iterations}});
    }
}

ContactSettings decode_settings(const json& params) {
    ContactSettings settings;
    if (!params.contains("settings")) return settings;
    for (const auto& [name, solver] : solvers_of(settings)) {
        if (!params["settings"].contains(name)) continue;
        const json& given = params["settings"][name];
        solver->tolerance = given.value("tolerance", solver->tolerance);
        solver->max_iterations = given.value("max_iterations", solver->max_iterations);
    }
    return settings;
}

namespace {

/// The arrays of `initial` or `previous` with their names; State may be const.
template <class State>
auto arrays_of(State& state) {
    return std::array{std::pair("pressure", &state.pressure), std::pair("traction_x", &state.traction_x),
                      std::pair("traction_y", &state.traction_y)};
}

void encode_state(const char* field, const SurfaceState& state, const Grid& grid, json& params, ArrayWriter& arrays) {
    for (const auto& [name, values] : arrays_of(state))
        if (!values->empty()) params[field][name] = arrays.write(std::span<const double>(*values), shape_of(grid));
}

SurfaceState decode_state(const std::string& field, const json& params, const Frames& frames, const Grid& grid) {
    SurfaceState state;
    if (!params.contains(field)) return state;
    for (const auto& [name, values] : arrays_of(state))
        if (params[field].contains(name))
            *values = read_array(params[field][name], frames, shape_of(grid), field + "." + name);
    return state;
}

}  // namespace

json encode_opening(const ContactProblem& problem, ArrayWriter& arrays) {
    json params = object({{"grid", encode_grid(problem.grid)}});
    if (problem.gap) params["gap"] = encode_gap(*problem.gap, problem.grid, arrays);
    if (problem.model != Model::full) params["model"] = name_of(problem.model);
    encode_settings(problem.settings, params);
    if (problem.columns) params["columns"] = encode_columns(*problem.columns, arrays);
    encode_bodies(problem, params, arrays);
    if (problem.Fn && problem.approach) require_load(problem);
    if (problem.Fn) params["Fn"] = finite_field(*problem.Fn, "Fn");
    if (problem.approach) params["approach"] = finite_field(*problem.approach, "approach");
    if (problem.friction)
        params["friction"] =
            encode_friction({problem.friction, problem.motion, problem.rigid_slip}, problem.grid, arrays);
    encode_state("previous", problem.previous, problem.grid, params, arrays);
    encode_state("initial", problem.initial, problem.grid, params, arrays);
    if (problem.derivatives) params["derivatives"] = true;
    return params;
}

ContactProblem decode_opening(const json& params, const Frames& frames) {
    ContactProblem problem;
    problem.grid = decode_grid(params["grid"]);
    if (params.contains("model")) read_name(params["model"], problem.model);
    decode_bodies(params, frames, problem);
    if (params.contains("gap")) problem.gap = decode_gap(params["gap"], frames, problem.grid);
    if (params.contains("Fn")) problem.Fn = params["Fn"].get<double>();
    if (params.contains("approach")) problem.approach = params["approach"].get<double>();
    if (params.contains("friction")) decode_friction(params["friction"], frames, problem);
    problem.previous = decode_state("previous", params, frames, problem.grid);
    problem.settings = decode_settings(params);
    if (params.contains("columns")) problem.columns = decode_columns(params["columns"], frames, problem.grid);
    problem.initial = decode_state("initial", params, frames, problem.grid);
    problem.derivatives = params.value("derivatives", false);
    return problem;
}

json encode_problem(const ContactProblem& problem, ArrayWriter& arrays) {
    require_load(problem);
    if (!problem.gap) throw InvalidArgument("gap", "is missing; it is what parts the undeformed bodies");
    return encode_opening(problem, arrays);
}

ContactProblem decode_problem(const json& params, const Frames& frames) {
    return decode_opening(params, frames);
}

}  // namespace contactd::proto
