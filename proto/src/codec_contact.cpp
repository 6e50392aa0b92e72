#include <cmath>
#include <limits>

#include "codec_parts.hpp"
#include "contactd/error.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;
using Shape = std::vector<std::size_t>;

Shape shape_of(const Grid& grid) {
    return {static_cast<std::size_t>(grid.ny), static_cast<std::size_t>(grid.nx)};
}

json encode_grid(const Grid& grid) {
    return {{"nx", grid.nx},
            {"ny", grid.ny},
            {"dx", finite(grid.dx, "grid.dx")},
            {"dy", finite(grid.dy, "grid.dy")},
            {"x0", finite(grid.x0, "grid.x0")},
            {"y0", finite(grid.y0, "grid.y0")}};
}

Grid decode_grid(const json& source) {
    Grid grid = Grid::centred(source["nx"].get<int>(), source["ny"].get<int>(), source["dx"].get<double>(),
                              source["dy"].get<double>());
    grid.x0 = source.value("x0", grid.x0);
    grid.y0 = source.value("y0", grid.y0);
    // Before anything of its size is allocated.
    try {
        validate(grid, "grid");
    } catch (const InvalidArgument& error) {
        throw invalid_field(error.field(), std::string(error.what()).substr(error.field().size() + 1));
    }
    return grid;
}

json encode_settings(const SolverSettings& settings) {
    return {{"tolerance", finite(settings.tolerance, "A tolerance")}, {"max_iterations", settings.max_iterations}};
}

SolverSettings decode_settings(const json& settings, const char* solver) {
    SolverSettings result;
    if (!settings.contains(solver)) return result;
    result.tolerance = settings[solver].value("tolerance", result.tolerance);
    result.max_iterations = settings[solver].value("max_iterations", result.max_iterations);
    return result;
}

json encode_initial(const ContactProblem& problem, ArrayWriter& arrays) {
    json initial = json::object();
    const auto add = [&](const char* name, const std::vector<double>& values) {
        if (!values.empty()) initial[name] = arrays.write(std::span<const double>(values), shape_of(problem.grid));
    };
    add("pressure", problem.initial_pressure);
    add("traction_x", problem.initial_traction_x);
    add("traction_y", problem.initial_traction_y);
    return initial;
}

void decode_initial(const json& initial, const std::vector<std::string>& frames, ContactProblem& problem) {
    const auto read = [&](const char* name, std::vector<double>& values) {
        if (initial.contains(name))
            values = read_array(initial[name], frames, shape_of(problem.grid), std::string("initial.") + name);
    };
    read("pressure", problem.initial_pressure);
    read("traction_x", problem.initial_traction_x);
    read("traction_y", problem.initial_traction_y);
}

std::vector<double> decode_gap(const json& gap, const std::vector<std::string>& frames, const Grid& grid) {
    if (gap.contains("array")) return read_array(gap["array"], frames, shape_of(grid), "gap.array");
    constexpr double flat = std::numeric_limits<double>::infinity();
    const json& radii = gap["paraboloid"];
    return paraboloid(grid, radii.value("Rx", flat), radii.value("Ry", flat));
}

json encode_solver_evidence(const SolverEvidence& evidence) {
    return {{"iterations", evidence.iterations},
            {"residual", finite(evidence.residual, "The residual of a solve")},
            {"converged", evidence.converged},
            {"seconds", finite(evidence.seconds, "The duration of a solve")}};
}

SolverEvidence decode_solver_evidence(const json& source) {
    return {source["iterations"].get<int>(), source["residual"].get<double>(), source["converged"].get<bool>(),
            source["seconds"].get<double>()};
}

IcUse decode_use(const json& source) {
    return {source["origin"].get<std::string>(), source["key"].get<std::string>(), decode_evidence(source["evidence"])};
}

/// The shape [ny, nx] that an array of a result claims to have.
Shape claimed_shape(const json& array) {
    if (array.is_array()) {
        const std::size_t columns = !array.empty() && array[0].is_array() ? array[0].size() : 0;
        return {array.size(), columns};
    }
    return array["$array"]["shape"].get<Shape>();
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

json encode_bodies(const BodyPair& bodies) {
    return {{"upper", encode_material(bodies.upper)}, {"lower", encode_material(bodies.lower)}};
}

void decode_ics_of_bodies(const json& params, ContactProblem& problem) {
    const json& bodies = params["bodies"];
    problem.bodies.upper = decode_material(bodies["upper"]);
    problem.bodies.lower = bodies.contains("lower") ? decode_material(bodies["lower"]) : problem.bodies.upper;
    problem.ics = decode_ics(params["ics"]);
}

}  // namespace

json encode_use(const IcUse& use) {
    return {{"origin", use.origin}, {"key", use.key}, {"evidence", encode_evidence(use.evidence)}};
}

json encode_problem(const ContactProblem& problem, ArrayWriter& arrays) {
    json params{
        {"grid", encode_grid(problem.grid)},
        {"gap",
         {{"array", arrays.write(std::span<const double>(problem.undeformed_distance), shape_of(problem.grid))}}},
        {"approach", finite(problem.approach, "approach")},
        {"settings",
         {{"normal", encode_settings(problem.normal_settings)},
          {"tangential", encode_settings(problem.tangential_settings)}}}};
    if (problem.given_ics) {
        params["ics"] = encode_given_ics(*problem.given_ics, arrays);
    } else {
        params["bodies"] = encode_bodies(problem.bodies);
        params["ics"] = encode_ics(problem.ics);
    }
    if (problem.friction)
        params["friction"] = {{"mu", finite(problem.friction->mu, "friction.mu")},
                              {"rigid_shift",
                               {finite(problem.friction->rigid_shift_x, "friction.rigid_shift"),
                                finite(problem.friction->rigid_shift_y, "friction.rigid_shift")}}};
    if (json initial = encode_initial(problem, arrays); !initial.empty()) params["initial"] = std::move(initial);
    return params;
}

ContactProblem decode_problem(const json& params, const std::vector<std::string>& frames) {
    ContactProblem problem;
    problem.grid = decode_grid(params["grid"]);
    if (params["ics"]["source"] == "table")
        problem.given_ics = decode_given_ics(params["ics"], frames, problem.grid);
    else
        decode_ics_of_bodies(params, problem);
    problem.undeformed_distance = decode_gap(params["gap"], frames, problem.grid);
    problem.approach = params["approach"].get<double>();
    if (params.contains("friction")) {
        const json& friction = params["friction"];
        problem.friction = Friction{friction["mu"].get<double>(), friction["rigid_shift"][0].get<double>(),
                                    friction["rigid_shift"][1].get<double>()};
    }
    const json settings = params.value("settings", json::object());
    problem.normal_settings = decode_settings(settings, "normal");
    problem.tangential_settings = decode_settings(settings, "tangential");
    if (params.contains("initial")) decode_initial(params["initial"], frames, problem);
    return problem;
}

json encode_solve_reply(const SolveReply& reply, const Grid& grid, ArrayWriter& arrays) {
    const ContactSolution& solution = reply.solution;
    const auto array = [&](const std::vector<double>& values) {
        return arrays.write(std::span<const double>(values), shape_of(grid));
    };
    json result;
    result["forces"] = {
        {"Fn", finite(solution.Fn, "Fn")}, {"Fx", finite(solution.Fx, "Fx")}, {"Fy", finite(solution.Fy, "Fy")}};
    result["pmax"] = finite(solution.pmax, "pmax");
    result["area"] = {{"contact", finite(solution.contact_area, "The contact area")},
                      {"adhesion", finite(solution.adhesion_area, "The adhesion area")},
                      {"slip", finite(solution.slip_area, "The slip area")}};
    result["elements"] = {{"contact", solution.contact_elements},
                          {"adhesion", solution.adhesion_elements},
                          {"slip", solution.slip_elements}};
    const std::vector<unsigned char> division = bytes_of(solution.element_division);
    result["element_division"] = arrays.write(std::span<const unsigned char>(division), shape_of(grid));
    result["pressure"] = array(solution.pressure);
    result["traction_x"] = array(solution.traction_x);
    result["traction_y"] = array(solution.traction_y);
    result["converged"] = solution.converged();
    result["evidence"]["normal"] = encode_solver_evidence(solution.normal);
    if (solution.tangential) result["evidence"]["tangential"] = encode_solver_evidence(*solution.tangential);
    if (reply.pair)
        result["evidence"]["ics"] = {{"pair", encode_use(*reply.pair)}};
    else
        result["evidence"]["ics"] = {{"upper", encode_use(reply.upper)}, {"lower", encode_use(reply.lower)}};
    return result;
}

SolveReply decode_solve_reply(const json& result, const std::vector<std::string>& frames) {
    SolveReply reply;
    ContactSolution& solution = reply.solution;
    solution.Fn = result["forces"]["Fn"].get<double>();
    solution.Fx = result["forces"]["Fx"].get<double>();
    solution.Fy = result["forces"]["Fy"].get<double>();
    solution.pmax = result["pmax"].get<double>();
    solution.contact_area = result["area"]["contact"].get<double>();
    solution.adhesion_area = result["area"]["adhesion"].get<double>();
    solution.slip_area = result["area"]["slip"].get<double>();
    solution.contact_elements = result["elements"]["contact"].get<int>();
    solution.adhesion_elements = result["elements"]["adhesion"].get<int>();
    solution.slip_elements = result["elements"]["slip"].get<int>();
    const Shape shape = claimed_shape(result["pressure"]);
    if (shape.size() != 2)
        throw invalid_field("pressure", "has " + std::to_string(shape.size()) + " dimensions; it must have 2",
                            reason::array_invalid);
    solution.pressure = read_array(result["pressure"], frames, shape, "pressure");
    solution.traction_x = read_array(result["traction_x"], frames, shape, "traction_x");
    solution.traction_y = read_array(result["traction_y"], frames, shape, "traction_y");
    solution.element_division =
        states_of(read_byte_array(result["element_division"], frames, shape, "element_division"));
    const json& evidence = result["evidence"];
    solution.normal = decode_solver_evidence(evidence["normal"]);
    if (evidence.contains("tangential")) solution.tangential = decode_solver_evidence(evidence["tangential"]);
    const json& ics = evidence["ics"];
    if (ics.contains("pair")) {
        reply.pair = decode_use(ics["pair"]);
    } else {
        reply.upper = decode_use(ics["upper"]);
        reply.lower = decode_use(ics["lower"]);
    }
    return reply;
}

}  // namespace contactd::proto
