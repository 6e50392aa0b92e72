#include "mesh_build.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/fields/axis.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/half_space.hpp"
#include "modelling_error.hpp"
#include "system/sampling.hpp"

namespace contactd::fem {
namespace {

constexpr double assembly_share = 0.15;  // share of a build's time, for the displayed progress
constexpr double sampling_share = 0.02;
constexpr double amg_setup_share = 0.3;  // of a load case's
constexpr double factorisation_share = 0.95;
/// The paper's aim (3.1).
constexpr double largest_unremarked_error = 0.01;
/// From this value on, the error of quadratic elements grows (docs/ic-tables.md).
constexpr double locking_nu = 0.48;

constexpr double seconds_per_element = 5e-5;  // of making a mesh
constexpr double seconds_per_offset = 1e-4;   // seconds to read the table from the solution; a generous value

std::string not_converged(Axis load, const SolveResult& result, const FemSpec& fem) {
    char text[400];
    const bool by_update = result.update.has_value();
    std::snprintf(text, sizeof text,
                  "The load case %s did not converge: after %d of at most %d iterations the %s is %.3g, above the "
                  "tolerance of %.3g.",
                  std::string(name_of(load)).c_str(), result.iterations, fem.max_iterations,
                  by_update ? "relative update" : "true relative residual",
                  by_update ? *result.update : result.residual, fem.tolerance);
    return text;
}

/// Returns the share of the way from 1 down to the tolerance, on a logarithmic scale.
double convergence(double figure, double tolerance) {
    return figure > 0 ? std::clamp(std::log(figure) / std::log(tolerance), 0.0, 1.0) : 1;
}

/// Lists the loads to be solved. If the mesh is its own mirror image, the load along y mirrors that along x.
std::vector<Axis> loads_to_solve(const IcSpec& spec) {
    if (spec.fem.mesh == MeshKind::hex && spec.dx == spec.dy) return {Axis::z, Axis::x};
    return {Axis::z, Axis::x, Axis::y};
}

double setup_share(ElasticityProblem& problem) {
    return chosen_solver(problem) == Solver::direct ? factorisation_share : amg_setup_share;
}

/// `setup` receives each step of the setup, as in SolveMonitor.
mfem::Vector solve(ElasticityProblem& problem, LinearSystem& system, const LoadCase& load_case, Axis load,
                   const ProgressPart& progress, const std::function<void(double, std::optional<double>)>& setup,
                   IcEvidence& evidence) {
    const FemSpec& fem = problem.spec().fem;
    const bool direct = chosen_solver(problem) == Solver::direct;
    mfem::Vector u;
    const auto iteration = [&](int number, double figure, double seconds) {
        const double share = setup_share(problem), done = share + (1 - share) * convergence(figure, fem.tolerance);
        progress.report(direct ? "substitution" : "pcg", done, number, figure, seconds);
    };
    const SolveResult result = system.solve(load_case, u, {setup, iteration});
    require_converged(result, load, fem);
    evidence.load_cases.push_back(
        {load, result.iterations, result.residual, true, result.solve_seconds, result.update});
    evidence.seconds.setup += result.setup_seconds;
    evidence.seconds.solve += result.solve_seconds;
    return u;
}

}  // namespace

void require_converged(const SolveResult& result, Axis load, const FemSpec& fem) {
    if (!result.converged) throw NotConverged(not_converged(load, result, fem));
}

std::vector<Solution> solve_loads(ElasticityProblem& problem, const CaseOf& case_of, const ProgressPart& progress,
                                  IcEvidence& evidence) {
    const double begin = MPI_Wtime();
    double start = begin;
    progress.report("assembly", 0);
    const auto system = make_linear_system(problem, [&](double done, double seconds) {
        progress.report("assembly", assembly_share * done, 0, 0, seconds);
    });
    evidence.seconds.assembly += seconds_since(start);

    const std::vector<Axis> loads = loads_to_solve(problem.spec());
    const double share = (1 - assembly_share) / static_cast<double>(loads.size());
    const char* setup = chosen_solver(problem) == Solver::direct ? "factorisation" : "amg_setup";
    std::optional<double> last_case;
    std::vector<Solution> result;
    for (const Axis load : loads) {
        start = MPI_Wtime();
        const LoadCase load_case = case_of(problem, load);
        evidence.seconds.assembly += seconds_since(start);
        const double from = assembly_share + static_cast<double>(result.size()) * share;
        const ProgressPart part = progress.part(from, share);
        const auto begin_setup = [&](double seconds, std::optional<double> whole) {
            if (!whole) whole = last_case;
            if (whole) *whole *= static_cast<double>(loads.size() - result.size());
            progress.begin(setup, from, from + share * setup_share(problem), {seconds_since(begin), seconds, whole});
        };
        start = MPI_Wtime();
        result.push_back({load, solve(problem, *system, load_case, load, part, begin_setup, evidence)});
        last_case = seconds_since(start);
    }
    return result;
}

IcRecord solve_and_sample(ElasticityProblem& problem, const CaseOf& case_of, const ProgressPart& progress) {
    IcRecord record{problem.spec()};
    IcEvidence& evidence = record.evidence;
    const auto solutions = solve_loads(problem, case_of, progress.part(0, 1 - sampling_share), evidence);

    const double offsets = static_cast<double>(record.spec.nx) * record.spec.ny;
    progress.report("sampling", 1 - sampling_share, 0, 0, seconds_per_offset * offsets);
    std::vector<SolvedCase> cases;
    for (const Solution& one : solutions) cases.push_back({one.load, one.load, &one.displacements});
    if (cases.size() == 2) cases.push_back({Axis::x, Axis::y, &solutions[1].displacements});
    record.tables = sample_table(problem, record.spec, cases);

    evidence.source = name_of(IcSource::fem);
    evidence.version = fem_version();
    evidence.elements = problem.elements();
    evidence.dofs = problem.dofs();
    evidence.processes = problem.processes();
    evidence.solver = name_of(chosen_solver(problem));
    return record;
}

std::vector<std::string> table_warnings(const IcSpec& spec, const IcEvidence& evidence) {
    std::vector<std::string> result = warnings(spec);
    if (evidence.modelling_error)
        for (std::string& warning : modelling_warnings(spec, *evidence.modelling_error))
            result.push_back(std::move(warning));
    if (!evidence.errors.xx) return result;
    // Clamped faces cause errors at adjacent offsets on any mesh.
    const bool everywhere = spec.fem.far_boundary == FarBoundary::half_space;
    double error = 0;
    for (const auto& one : {evidence.errors.xx, evidence.errors.yy, evidence.errors.zz})
        error = std::max(error, everywhere ? one->largest : std::abs(one->origin));
    if (error <= largest_unremarked_error) return result;
    char text[300];
    std::snprintf(
        text, sizeof text,
        "The coefficients differ from the closed form by up to %.2g %%%s. Use a finer mesh or a higher order%s.",
        100 * error, everywhere ? "" : " under the load",
        spec.material.nu > locking_nu ? ", because elements of low order lock for nu near 1/2" : "");
    result.emplace_back(text);
    return result;
}

void finish_evidence(IcEvidence& evidence, double start, MPI_Comm comm) {
    evidence.seconds.total = seconds_since(start);
    const auto slowest = [&](double& seconds) { MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, comm); };
    slowest(evidence.seconds.assembly);
    slowest(evidence.seconds.setup);
    slowest(evidence.seconds.solve);
    slowest(evidence.seconds.total);
    for (LoadCaseEvidence& load_case : evidence.load_cases) slowest(load_case.seconds);
}

IcRecord build_on_mesh(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress) {
    const double start = MPI_Wtime();
    const auto elements = static_cast<double>(mesh_size(spec).elements);
    progress.report("assembly", 0, 0, 0, seconds_per_element * elements);
    ElasticityProblem problem(comm, spec);
    return build_on_problem(problem, progress, start);
}

IcRecord build_on_problem(ElasticityProblem& problem, const ProgressPart& progress, double start) {
    const IcSpec& spec = problem.spec();
    const auto case_of = [](ElasticityProblem& of, Axis load) { return of.load_case(load); };
    const double modelling_share = spec.body == BodyShape::block ? 0.1 : 0;
    IcRecord record = solve_and_sample(problem, case_of, progress.part(0, 1 - modelling_share));
    if (spec.body == BodyShape::half_space) compare_with_half_space(spec, record.table(), record.evidence);
    if (spec.body == BodyShape::block)
        record.evidence.modelling_error = modelling_error(spec, progress.part(1 - modelling_share, modelling_share));
    record.evidence.warnings = table_warnings(spec, record.evidence);
    finish_evidence(record.evidence, start, problem.space().GetComm());
    progress.report("sampling", 1);
    return record;
}

}  // namespace contactd::fem
