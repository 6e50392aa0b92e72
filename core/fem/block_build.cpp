#include "block_build.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "accurate_build.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "tensor_block.hpp"

namespace contactd::fem {
namespace {

struct Level {
    int order;
    int intervals;  ///< along each axis
};
constexpr std::array<Level, 5> levels{{{3, 4}, {4, 5}, {5, 6}, {5, 7}, {6, 7}}};

/// The error of order p over the difference of orders p-1 and p. One order more was never seen to lower the error less
/// than threefold on these meshes (by comparison of gradings: three- to sixfold).
constexpr double error_over_difference = 0.5;

/// Each interval over the one before, towards the edges where clamped faces and free surface meet.
constexpr double grading = 0.5;

/// From 0 to L, finer towards L.
std::vector<double> graded_planes(double L, int intervals) {
    std::vector<double> planes(static_cast<std::size_t>(intervals) + 1);
    for (int i = 0; i <= intervals; ++i)
        planes[static_cast<std::size_t>(i)] = L * (1 - std::pow(grading, i)) / (1 - std::pow(grading, intervals));
    planes.back() = L;
    return planes;
}

/// From 0 to L, finer towards 0.
std::vector<double> reversed_planes(double L, int intervals) {
    std::vector<double> planes = graded_planes(L, intervals);
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
    for (std::optional<ComponentError>* error : {&evidence.error_xx, &evidence.error_yy, &evidence.error_zz})
        *error = ComponentError{factor * (*error)->origin, factor * (*error)->largest};
    for (std::optional<double>* error : {&evidence.scaled_error_xy, &evidence.scaled_error_xz}) **error *= factor;
}

/// One correction, and the table of the block with it.
IcRecord corrected(MPI_Comm comm, const IcSpec& spec, int order, int intervals, const ProgressPart& progress) {
    IcSpec mesh_spec = spec;
    mesh_spec.accuracy = 0;
    mesh_spec.fem.order = order;
    mesh_spec.fem.far_boundary = FarBoundary::clamped;
    const double L = spec.fem.L_over_h * std::max(spec.dx, spec.dy);
    const auto planes = graded_planes(L, intervals);
    ElasticityProblem problem(comm, mesh_spec,
                              make_tensor_block({planes, planes, reversed_planes(L, intervals)}, load_extent(spec)));
    const auto case_of = [](ElasticityProblem& of, Axis load) { return of.correction_case(load); };
    IcRecord record = solve_and_sample(problem, case_of, progress);
    const IcTable half_space = closed_form(spec);
    for (std::size_t i = 0; i < record.table.values.size(); ++i) record.table.values[i] += half_space.values[i];
    return record;
}

}  // namespace

IcRecord build_block(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress) {
    const double start = MPI_Wtime();
    ProgressPart rest = progress;
    constexpr double share = 0.5, lower_share = 0.3;
    double error = 0;
    for (const Level& level : levels) {
        const ProgressPart now = rest.part(0, share);
        const IcRecord lower = corrected(comm, spec, level.order - 1, level.intervals, now.part(0, lower_share));
        IcRecord record = corrected(comm, spec, level.order, level.intervals, now.part(lower_share, 1 - lower_share));
        compare_tables(spec, lower.table, record.table, record.evidence);
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
