#include "contactd/fem/ic_builder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "amg_pcg.hpp"
#include "collective_observer.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "elasticity_problem.hpp"
#include "sampling.hpp"

namespace contactd::fem {
namespace {

constexpr double assembly_share = 0.15;  // of a build's time, for the progress shown
constexpr double sampling_share = 0.02;
constexpr double setup_share = 0.3;  // of a load case's

char letter(Axis axis) {
    return "xyz"[static_cast<int>(axis)];
}

std::string not_converged(Axis load, const PcgResult& result, const FemSpec& fem) {
    char text[300];
    std::snprintf(text, sizeof text,
                  "The load case %c did not converge: after %d iterations of at most %d the true relative residual is "
                  "%.3g, and %.3g was asked for.",
                  letter(load), result.iterations, fem.max_iterations, result.residual, fem.tolerance);
    return text;
}

/// The share of the way from 1 down to the tolerance, on a logarithmic scale.
double convergence(double residual, double tolerance) {
    return residual > 0 ? std::clamp(std::log(residual) / std::log(tolerance), 0.0, 1.0) : 1;
}

/// Solves one load case; adds what it took to `evidence`. `first` and `share` place it in the build's progress.
mfem::Vector solve_case(ElasticityProblem& problem, const FemSpec& fem, Axis load, double first, double share,
                        CollectiveObserver& observer, IcEvidence& evidence) {
    observer.report({"amg_setup", first});
    double start = MPI_Wtime();
    const LoadCase system = problem.load_case(load);
    evidence.assembly_seconds += MPI_Wtime() - start;

    const auto monitor = [&](int iteration, double residual) {
        const double done = setup_share + (1 - setup_share) * convergence(residual, fem.tolerance);
        observer.report({"pcg", first + share * done, iteration, residual});
    };
    mfem::Vector u;
    const PcgResult result =
        solve_amg_pcg(*system.A, system.b, u, {fem.tolerance, fem.max_iterations, fem.strength_threshold}, monitor);
    if (!result.converged) throw NotConverged(not_converged(load, result, fem));
    evidence.load_cases.push_back({load, result.iterations, result.residual, true, result.solve_seconds});
    evidence.setup_seconds += result.setup_seconds;
    evidence.solve_seconds += result.solve_seconds;
    return u;
}

/// Times of the slowest process, so that every process returns the same record.
void agree_on_times(IcEvidence& evidence, MPI_Comm comm) {
    const auto slowest = [&](double& seconds) { MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, comm); };
    slowest(evidence.assembly_seconds);
    slowest(evidence.setup_seconds);
    slowest(evidence.solve_seconds);
    slowest(evidence.total_seconds);
    for (LoadCaseEvidence& load_case : evidence.load_cases) slowest(load_case.seconds);
}

}  // namespace

IcRecord build_ic_table(const IcSpec& requested, Observer& first_observer) {
    const MPI_Comm comm = MPI_COMM_WORLD;
    const double start = MPI_Wtime();
    if (requested.source != IcSource::fem)
        throw InvalidArgument("ics.source", "is analytic; only a spec of source fem is built by finite elements");
    validate(requested);
    IcRecord record;
    record.spec = dimensionless(requested);
    const IcSpec& spec = record.spec;
    IcEvidence& evidence = record.evidence;
    CollectiveObserver observer(comm, first_observer);

    observer.report({"assembly", 0});
    ElasticityProblem problem(comm, spec);
    problem.assemble([&](double done) { observer.report({"assembly", assembly_share * done}); });
    evidence.assembly_seconds = MPI_Wtime() - start;

    std::vector<Axis> loads{Axis::z, Axis::x};
    const bool mirror = spec.dx == spec.dy;
    if (!mirror) loads.push_back(Axis::y);
    const double share = (1 - assembly_share - sampling_share) / static_cast<double>(loads.size());
    std::vector<mfem::Vector> u;
    for (std::size_t i = 0; i < loads.size(); ++i)
        u.push_back(solve_case(problem, spec.fem, loads[i], assembly_share + static_cast<double>(i) * share, share,
                               observer, evidence));

    observer.report({"sampling", 1 - sampling_share});
    std::vector<SolvedCase> cases;
    for (std::size_t i = 0; i < loads.size(); ++i) cases.push_back({loads[i], loads[i], &u[i]});
    if (mirror) cases.push_back({Axis::x, Axis::y, &u[1]});
    record.table = sample_table(problem, spec, cases);

    evidence.source = "fem";
    evidence.version = fem_version();
    evidence.elements = problem.shells().elements();
    evidence.dofs = problem.dofs();
    MPI_Comm_size(comm, &evidence.processes);
    compare_with_half_space(spec, record.table, evidence);
    evidence.total_seconds = MPI_Wtime() - start;
    agree_on_times(evidence, comm);
    observer.report({"sampling", 1});
    return record;
}

}  // namespace contactd::fem
