#include "block_build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "accurate_build.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "mesh/tensor_block.hpp"

namespace contactd::fem {
namespace {

constexpr std::array<BlockLevel, 5> levels{{{4, 5}, {4, 6}, {5, 6}, {5, 7}, {6, 7}}};

/// The error of order p over the difference of orders p-1 and p on the same mesh, at most: against finer meshes it was
/// 0.05 to 0.27, for nu from 0 to 0.49 and dx/dy from 1/4 to 4. That holds because the edges are resolved (below): on
/// meshes that leave them coarse the orders converge to something else, and their difference says less than the error.
constexpr double error_over_difference = 1.0 / 3;

/// Displacements go as r^lambda at the distance r from an edge where a clamped face and the free surface meet at a
/// right angle: the root in (0.59, 1] of (3 - 4 nu) sin^2(lambda pi/2) = 4 (1-nu)^2 - lambda^2 (Williams, J. Appl.
/// Mech. 19, 1952).
double edge_exponent(double nu) {
    double below = 0.5, above = 1;
    for (int halving = 0; halving < 50; ++halving) {
        const double lambda = (below + above) / 2, sine = std::sin(lambda * std::numbers::pi / 2);
        const bool is_below = (3 - 4 * nu) * sine * sine < 4 * (1 - nu) * (1 - nu) - lambda * lambda;
        (is_below ? below : above) = lambda;
    }
    return above;
}

/// The distances of the planes from the edge go as a power of their number, by 1/lambda as usual for graded meshes.
/// Seen from inside, 1.8 balances the intervals; the last of them is cut once more, which takes the singularity's
/// share.
constexpr double grading_times_exponent = 1.8;
constexpr double last_cut = 1.0 / 8;

/// From 0 to L, finer towards L, where the edges are.
std::vector<double> graded_planes(double L, int intervals, double nu) {
    const double grading = grading_times_exponent / edge_exponent(nu);
    const int equal_steps = intervals - 1;
    std::vector<double> planes;
    double distance = 1;
    for (int i = 0; i < equal_steps; ++i) {
        distance = std::pow(1 - static_cast<double>(i) / equal_steps, grading);
        planes.push_back(L * (1 - distance));
    }
    planes.push_back(L * (1 - last_cut * distance));
    planes.push_back(L);
    return planes;
}

/// From 0 to L, finer towards 0.
std::vector<double> reversed_planes(double L, int intervals, double nu) {
    std::vector<double> planes = graded_planes(L, intervals, nu);
    for (double& plane : planes) plane = L - plane;
    std::reverse(planes.begin(), planes.end());
    planes.front() = 0;
    return planes;
}

IcTable closed_form(IcSpec spec) {
    spec.body = BodyShape::half_space;
    spec.source = IcSource::analytic;
    spec.accuracy = 0;
    spec.any_nu = false;
    return half_space_table(spec);
}

void scale_errors(IcEvidence& evidence, double factor) {
    for (std::optional<ComponentError>* error : {&evidence.errors.xx, &evidence.errors.yy, &evidence.errors.zz})
        *error = ComponentError{factor * (*error)->origin, factor * (*error)->largest};
    for (std::optional<double>* error : {&evidence.errors.scaled_xy, &evidence.errors.scaled_xz}) **error *= factor;
}

/// One correction, and the table of the block with it.
IcRecord corrected(MPI_Comm comm, const IcSpec& spec, int order, int intervals, const ProgressPart& progress) {
    IcSpec mesh_spec = spec;
    mesh_spec.accuracy = 0;
    mesh_spec.fem.order = order;
    mesh_spec.fem.far_boundary = FarBoundary::clamped;
    const double L = spec.fem.L_over_h * std::max(spec.dx, spec.dy);
    const double nu = spec.material.nu;
    const auto planes = graded_planes(L, intervals, nu), depths = reversed_planes(L, intervals, nu);
    ElasticityProblem problem(comm, mesh_spec, make_tensor_block({planes, planes, depths}, load_extent(spec)));
    const auto case_of = [](ElasticityProblem& of, Axis load) { return of.correction_case(load); };
    IcRecord record = solve_and_sample(problem, case_of, progress);
    const IcTable half_space = closed_form(spec);
    std::vector<double>& values = record.table().values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += half_space.values[i];
    return record;
}

}  // namespace

BlockLevel first_block_level() {
    return levels.front();
}

IcRecord build_block(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress) {
    const double start = MPI_Wtime();
    ProgressPart rest = progress;
    constexpr double share = 0.5, lower_share = 0.3;
    double error = 0;
    for (const BlockLevel& level : levels) {
        const ProgressPart now = rest.part(0, share);
        const IcRecord lower = corrected(comm, spec, level.order - 1, level.intervals, now.part(0, lower_share));
        IcRecord record = corrected(comm, spec, level.order, level.intervals, now.part(lower_share, 1 - lower_share));
        compare_tables(spec, lower.table(), record.table(), record.evidence);
        scale_errors(record.evidence, error_over_difference);
        record.evidence.errors_estimated = true;
        error = largest_error(record.evidence);
        if (error <= spec.accuracy) {
            record.spec.accuracy = spec.accuracy;
            finish_evidence(record.evidence, start, comm);
            progress.report("sampling", 1);
            return record;
        }
        rest = rest.part(share, 1 - share);
    }
    throw_not_reached(spec.accuracy, error);
}

}  // namespace contactd::fem
