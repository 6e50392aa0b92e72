#include "adaptive_build.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include "contactd/error.hpp"
#include "error_estimate.hpp"
#include "mesh/hex_block.hpp"

namespace contactd::fem {
namespace {

/// Each step divides the elements with this share of the estimated error (Doerfler, SIAM J. Numer. Anal. 33, 1106-1124,
/// 1996). With 0.3 there are twice as many steps, and the meshes are no better.
constexpr double share_of_error = 0.5;

/// A mesh that uses this share of max_dofs is the last one, because another step would cost more than it gains.
constexpr double full = 0.8;

/// This is the tolerance of solves whose displacements only mark elements.
constexpr double marking_tolerance = 1e-6;

/// This generous time covers the choice of a finer mesh, which tries several.
constexpr double seconds_per_dof = 1e-4;

/// All meshes but the last one take this share of the displayed progress.
constexpr double refining_share = 0.5;

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

long long dofs_of(const RefinedBlock& block, int order) {
    mfem::Mesh mesh(block.mesh());
    const mfem::H1_FECollection collection(order, 3);
    return mfem::FiniteElementSpace(&mesh, &collection, 3).GetTrueVSize();
}

void require_room(const RefinedBlock& start, const FemSpec& fem) {
    if (const long long dofs = dofs_of(start, fem.order); dofs > fem.max_dofs)
        throw InvalidArgument("ics.max_dofs", "is " + std::to_string(fem.max_dofs) + ", but the initial mesh has " +
                                                  std::to_string(dofs) + " unknowns of order " +
                                                  std::to_string(fem.order) + ": increase it, or use a lower order");
}

/// Returns the elements to divide, the worst first.
std::vector<int> marked(const std::vector<double>& errors) {
    std::vector<int> order(errors.size());
    std::iota(order.begin(), order.end(), 0);
    const auto error = [&](int i) { return errors[static_cast<std::size_t>(i)]; };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return error(a) > error(b); });
    const double target = share_of_error * sum(errors);
    double covered = 0;
    std::size_t count = 0;
    while (count < order.size() && covered < target) covered += error(order[count++]);
    order.resize(count);
    return order;
}

/// Divides `elements`, or as many of the first ones as max_dofs allows, found by bisection. Returns whether there is
/// room for more.
bool refine(RefinedBlock& block, const std::vector<int>& elements, const FemSpec& fem) {
    const RefinedBlock before(block);
    const std::size_t all = elements.size();
    std::size_t taken = 0;
    double filled = 1;
    for (std::size_t step = all; step > all / 16 && taken < all; step /= 2) {
        RefinedBlock trial(before);
        trial.refine({elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(taken + step)});
        const long long dofs = dofs_of(trial, fem.order);
        if (dofs > fem.max_dofs) continue;
        block = std::move(trial);
        taken += step;
        filled = static_cast<double>(dofs) / static_cast<double>(fem.max_dofs);
    }
    return taken == all && filled < full;
}

/// Solves all loads, only for marking, and estimates the contribution of each element to the table's relative errors.
std::vector<double> estimate(MPI_Comm comm, IcSpec spec, const RefinedBlock& block, const ProgressPart& progress,
                             IcEvidence& evidence) {
    spec.fem.stopping_criterion = StoppingCriterion::residual;
    spec.fem.tolerance = std::max(spec.fem.tolerance, marking_tolerance);
    ElasticityProblem problem(comm, spec, block.block());
    const auto case_of = [](ElasticityProblem& of, Axis load) { return of.load_case(load); };
    std::vector<double> errors = energy_errors(problem, solve_loads(problem, case_of, progress, evidence));
    const std::vector<double> weights = table_weights(problem);
    std::transform(errors.begin(), errors.end(), weights.begin(), errors.begin(), std::multiplies{});
    return errors;
}

}  // namespace

BlockMesh make_start_mesh(const IcSpec& spec) {
    constexpr double growth = 2;  // layers as thick as their elements are wide
    IcSpec start = spec;
    start.fem.mesh = MeshKind::hex;
    start.fem.l_over_h = spec.load_shape == LoadShape::constant ? 0.5 : 1;
    start.fem.h_over_hs = 1 / start.fem.l_over_h;
    start.fem.f = growth;
    start.fem.t1_over_hs = (growth - 1) * std::min(spec.dx, spec.dy) / std::sqrt(spec.dx * spec.dy);
    return make_hex_block(start);
}

IcRecord build_adaptive(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress) {
    const double start = MPI_Wtime();
    RefinedBlock block(make_start_mesh(spec));
    require_room(block, spec.fem);

    IcEvidence before;
    double done = 0;
    bool room = true;
    for (int step = 1; room; ++step) {
        const auto dofs = static_cast<double>(dofs_of(block, spec.fem.order));
        const double share = refining_share * dofs / static_cast<double>(spec.fem.max_dofs) - done;
        const std::vector<double> errors = estimate(comm, spec, block, progress.part(done, share), before);
        done += share;
        progress.report("adaptive", done, step, sum(errors), seconds_per_dof * dofs);
        room = refine(block, marked(errors), spec.fem);
    }

    ElasticityProblem problem(comm, spec, block.block());
    IcRecord record = build_on_problem(problem, progress.part(done, 1 - done), start);
    record.evidence.seconds.assembly += before.seconds.assembly;
    record.evidence.seconds.setup += before.seconds.setup;
    record.evidence.seconds.solve += before.seconds.solve;
    return record;
}

}  // namespace contactd::fem
