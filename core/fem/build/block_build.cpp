#include "block_build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "accurate_build.hpp"
#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/half_space.hpp"
#include "modelling_error.hpp"

namespace contactd::fem {
namespace {

constexpr std::array<BlockLevel, 7> levels{{{3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 9}, {9, 10}}};

/// In measurements, errors fell at least to a third from one level to the next (docs/findings.md). The error is then at
/// most half of the difference.
constexpr double error_over_difference = 1.0 / 2;

IcTable closed_form(IcSpec spec) {
    spec.body = BodyShape::half_space;
    spec.source = IcSource::analytic;
    spec.accuracy = 0;
    spec.any_nu = false;
    return half_space_table(spec);
}

/// Bounds generously the error due to the solver's tolerance.
constexpr double solver_error = 3e-6;

/// Turns differences from the previous mesh into errors.
void take_as_errors(IcEvidence& evidence) {
    for (std::optional<ComponentError>* error : {&evidence.errors.xx, &evidence.errors.yy, &evidence.errors.zz})
        *error = ComponentError{error_over_difference * (*error)->origin,
                                error_over_difference * (*error)->largest + solver_error};
    for (std::optional<double>* error : {&evidence.errors.scaled_xy, &evidence.errors.scaled_xz})
        *error = error_over_difference * **error + solver_error;
}

std::vector<double> offsets(int count, double step) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back(i * step);
    return result;
}

void add_correction(const BlockCorrection::Solution& solution, Axis load, IcTable& table, const IcSpec& spec) {
    for (const Axis i : {Axis::x, Axis::y, Axis::z}) {
        const Eigen::MatrixXd w = solution.at(i, offsets(spec.nx, spec.dx), offsets(spec.ny, spec.dy));
        for (int l = 0; l < spec.ny; ++l)
            for (int k = 0; k < spec.nx; ++k) table(i, load, k, l) += w(l, k);
    }
}

/// The load along y mirrors that along x on the plane x = y.
void add_mirrored(const BlockCorrection::Solution& along_x, IcTable& table, const IcSpec& spec) {
    const auto mirrored = [](Axis axis) { return axis == Axis::x ? Axis::y : axis == Axis::y ? Axis::x : Axis::z; };
    for (const Axis i : {Axis::x, Axis::y, Axis::z}) {
        const Eigen::MatrixXd w = along_x.at(i, offsets(spec.ny, spec.dy), offsets(spec.nx, spec.dx));
        for (int l = 0; l < spec.ny; ++l)
            for (int k = 0; k < spec.nx; ++k) table(mirrored(i), Axis::y, k, l) += w(k, l);
    }
}

/// Returns the table on one mesh, without errors.
IcRecord table_on(const IcSpec& spec, const BlockLevel& level, const ProgressPart& progress) {
    const BlockCorrection correction(spec, level);
    IcRecord record{spec, closed_form(spec), {}};
    IcEvidence& evidence = record.evidence;
    evidence.source = name_of(IcSource::fem);
    evidence.version = fem_version();
    evidence.solver = tensor_solver;
    evidence.elements = correction.elements();
    evidence.dofs = correction.dofs();
    const bool mirror = spec.dx == spec.dy;
    const std::vector<Axis> loads = mirror ? std::vector{Axis::z, Axis::x} : std::vector{Axis::z, Axis::x, Axis::y};
    const double share = 1.0 / static_cast<double>(loads.size());
    for (const Axis load : loads) {
        const ProgressPart part = progress.part(share * static_cast<double>(evidence.load_cases.size()), share);
        const auto solution =
            correction.solve(load, {}, [&](double fraction, int iteration, double residual, double seconds) {
                part.report("pcg", fraction, iteration, residual, seconds);
            });
        require_converged(solution.result(), load, spec.fem);
        add_correction(solution, load, record.table(), spec);
        if (mirror && load == Axis::x) add_mirrored(solution, record.table(), spec);
        const SolveResult& result = solution.result();
        evidence.load_cases.push_back({load, result.iterations, result.residual, true, result.solve_seconds, {}});
        evidence.seconds.solve += result.solve_seconds;
    }
    return record;
}

}  // namespace

BlockLevel first_block_level() {
    return levels[1];
}

IcRecord build_block(MPI_Comm comm, const IcSpec& spec, const ProgressPart& progress) {
    const double start = MPI_Wtime();
    constexpr double share = 0.35, modelling_share = 0.1;  // part of the remaining progress
    const double modelling = modelling_error(spec, progress.part(0, modelling_share));
    ProgressPart rest = progress.part(modelling_share, 1 - modelling_share);
    std::optional<IcRecord> before;
    double error = 0, solve_seconds = 0;
    for (const BlockLevel& level : levels) {
        IcRecord record = table_on(spec, level, rest.part(0, share));
        rest = rest.part(share, 1 - share);
        solve_seconds += record.evidence.seconds.solve;
        if (before) {
            compare_tables(spec, before->table(), record.table(), record.evidence);
            take_as_errors(record.evidence);
            error = largest_error(record.evidence);
            if (error <= spec.accuracy) {
                record.evidence.errors_estimated = true;
                record.evidence.modelling_error = modelling;
                record.evidence.warnings = modelling_warnings(spec, modelling);
                record.evidence.seconds.solve = solve_seconds;
                finish_evidence(record.evidence, start, comm);
                progress.report("sampling", 1);
                return record;
            }
        }
        before = std::move(record);
    }
    throw_not_reached(spec.accuracy, error);
}

}  // namespace contactd::fem
