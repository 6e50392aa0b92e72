#include "accurate_build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "block_build.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "self_similarity.hpp"

namespace contactd::fem {
namespace {

/// Mesh1 has two elements per edge of the load, and layers that are scaled copies of each other. It needs few elements
/// of high order: the error depends only on order and growth.
struct Level {
    int order;
    double growth;
};

/// Levels go from coarse to fine, each at most twice as expensive as the previous one. A build starts at first_level()
/// and continues while its error exceeds the requested accuracy.
constexpr std::array<Level, 13> levels{{{2, 1.5},
                                        {2, 1.3},
                                        {3, 1.8},
                                        {3, 1.6},
                                        {3, 1.5},
                                        {3, 1.4},
                                        {4, 1.8},
                                        {4, 1.5},
                                        {4, 1.4},
                                        {5, 1.6},
                                        {5, 1.5},
                                        {6, 1.8},
                                        {6, 1.5}}};

/// Returns the largest Poisson's ratio at which measurements found the level sufficient for offsets up to 40 x 40
/// (docs/findings.md); low orders lock as nu approaches 1/2.
struct Start {
    double largest_nu;
    std::size_t level;
};
constexpr std::array<Start, 4> starts_for_1e_2{{{0.38, 0}, {0.42, 1}, {0.46, 2}, {0.49, 3}}};
constexpr std::array<Start, 4> starts_for_1e_3{{{0.35, 4}, {0.37, 5}, {0.46, 6}, {0.49, 7}}};
constexpr std::array<Start, 2> starts_for_1e_4{{{0.3, 9}, {0.49, 10}}};
// Corners of slender loads need finer meshes.
constexpr std::size_t slender_start_for_1e_2 = 2, slender_start_for_1e_4 = 11;

std::size_t first_level(const IcSpec& spec, double hardest_nu) {
    const auto level = [&](const auto& starts) {
        return std::ranges::find_if(starts, [&](const Start& start) { return hardest_nu <= start.largest_nu; })->level;
    };
    const double aspect = std::max(spec.dy, 1 / spec.dy);
    if (spec.accuracy >= 1e-2) return std::max(level(starts_for_1e_2), aspect > 4 ? slender_start_for_1e_2 : 0);
    if (spec.accuracy >= 1e-3) return level(starts_for_1e_3);
    if (aspect > 1.5 && spec.load_shape == LoadShape::constant) return slender_start_for_1e_4;
    return level(starts_for_1e_4);
}

/// The half-space ends at the first layer whose end is at least this far beyond the farthest offset. Displacements
/// there are prescribed in closed form, so only the mesh's own error remains. A larger extent adds layers and does not
/// change the others, so a cropped table hardly differs from a table of that extent.
constexpr double cut_off = 1.1, nearest_cut_off = 10;

FemSpec mesh_of(const IcSpec& spec, const Level& level) {
    FemSpec fem;
    fem.order = level.order;
    fem.f = level.growth;
    // The cube is the quarter of the load, two elements wide.
    fem.l_over_h = spec.load_shape == LoadShape::constant ? 0.5 : 1;
    fem.h_over_hs = 2 / fem.l_over_h;
    // Layers grow from the shorter edge of the cube, t_j = edge (f - 1) f^(j-1). On a cube, they are scaled copies of
    // the first.
    const double h = std::sqrt(spec.dx * spec.dy), edge = fem.l_over_h * std::min(spec.dx, spec.dy);
    fem.t1_over_hs = (fem.f - 1) * edge * fem.h_over_hs / h;
    const double largest = std::max(spec.dx, spec.dy), cube = fem.l_over_h * h;
    const double farthest = std::max((spec.nx - 1) * spec.dx, (spec.ny - 1) * spec.dy);
    const double reach = std::max(nearest_cut_off * largest, cut_off * farthest) - cube;
    const double layers = std::ceil(std::log1p(reach / edge) / std::log(fem.f));
    fem.L_over_h = (cube + edge * (std::pow(fem.f, layers) - 1)) / largest;
    return fem;
}

IcSpec with_mesh(const IcSpec& spec, const Level& level) {
    IcSpec result = spec;
    result.accuracy = 0;
    const bool bilinear = spec.load_shape == LoadShape::bilinear;
    for (int* extent : {&result.nx, &result.ny})
        if (bilinear) *extent = std::max(*extent, self_similar_extent);
    result.fem = mesh_of(result, level);
    return result;
}

IcRecord build_level(MPI_Comm comm, const IcSpec& spec, const Level& level, const ProgressPart& progress) {
    const double start = MPI_Wtime();
    const IcSpec mesh_spec = with_mesh(spec, level);
    ElasticityProblem problem(comm, mesh_spec);
    const auto case_of = [](ElasticityProblem& of, Axis load) { return of.load_case(load); };
    IcRecord record = solve_and_sample(problem, case_of, progress);
    if (spec.load_shape == LoadShape::bilinear)
        record.tables = cropped(near_load_from_far(record.table()), spec.nx, spec.ny);
    compare_with_half_space(spec, record.table(), record.evidence);
    record.evidence.mesh = mesh_spec.fem;
    record.spec = spec;
    record.spec.fem = mesh_spec.fem;
    finish_evidence(record.evidence, start, comm);
    return record;
}

/// The record includes time and unknowns of the meshes tried before.
void add_costs(IcEvidence& evidence, const IcEvidence& before) {
    evidence.seconds.assembly += before.seconds.assembly;
    evidence.seconds.setup += before.seconds.setup;
    evidence.seconds.solve += before.seconds.solve;
    evidence.seconds.total += before.seconds.total;
}

}  // namespace

double largest_error(const IcEvidence& evidence) {
    double result = std::max(evidence.errors.scaled_xy.value_or(0), evidence.errors.scaled_xz.value_or(0));
    for (const auto& error : {evidence.errors.xx, evidence.errors.yy, evidence.errors.zz})
        if (error) result = std::max(result, error->largest);
    return result;
}

void throw_not_reached(double accuracy, double error) {
    char text[300];
    std::snprintf(text, sizeof text,
                  "The accuracy %.3g was not reached: the finest mesh has an error of %.3g. Request a coarser "
                  "accuracy, or give a mesh.",
                  accuracy, error);
    throw NotConverged(text);
}

IcSpec first_mesh(const IcSpec& spec, double hardest_nu) {
    return with_mesh(spec, levels[first_level(spec, hardest_nu)]);
}

IcRecord build_accurate(MPI_Comm comm, const IcSpec& spec, double hardest_nu, const ProgressPart& progress) {
    if (spec.body == BodyShape::block) return build_block(comm, spec, progress);
    IcEvidence before;
    double error = 0;
    constexpr double share = 0.95;  // part of the remaining progress: more levels are rarely needed
    ProgressPart rest = progress;
    for (std::size_t level = first_level(spec, hardest_nu); level < levels.size(); ++level) {
        IcRecord record = build_level(comm, spec, levels[level], rest.part(0, share));
        add_costs(record.evidence, before);
        error = largest_error(record.evidence);
        if (error <= spec.accuracy) {
            progress.report("sampling", 1);
            return record;
        }
        before = record.evidence;
        rest = rest.part(share, 1 - share);
    }
    throw_not_reached(spec.accuracy, error);
}

}  // namespace contactd::fem
