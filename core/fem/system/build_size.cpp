#include "build_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "build/accurate_build.hpp"
#include "build/block_build.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_family.hpp"
#include "geometry/section/section_geometry.hpp"
#include "section/section_outline.hpp"
#include "section/spectrum/spectrum_level.hpp"

namespace contactd::fem {
namespace {

/// Up to this size, the factorisation was faster than BoomerAMG; at the limit it takes 5 GB. Elements of higher order
/// have denser rows, which slow BoomerAMG down much more than a factorisation.
long long direct_dofs(int order) {
    return order <= 2 ? 150'000 : 250'000;
}

// These are measured bytes of a builder: before it has a mesh, and in addition to the predicted memory.
constexpr double program = 65e6;
constexpr double per_process = 60e6;
constexpr double per_nonzero = 36;         // for conjugate gradients with BoomerAMG, with the matrix twice
constexpr double per_factor_entry = 14.5;  // remaining unknowns, divided by those of a cross-section
constexpr double per_tensor_dof = 200;     // for some vectors of conjugate gradients only
constexpr double sizes_of_a_table = 4;     // read off, compared, written

double cube(double n) {
    return n * n * n;
}

/// Holds numbers of nodes of a mesh. All are real, because requests may exceed the range of integers.
struct Nodes {
    double all = 0;
    double inside = 0;   ///< inside elements, which a direct solver eliminates first
    double section = 0;  ///< on a surface that divides the mesh into two parts, except inside elements
};

/// The number of nodes of order p equals the number of vertices of a mesh with p times as many elements along each
/// edge.
Nodes hex_nodes(const MeshSize& size, int order) {
    const double p = order, m = size.elements_per_edge, k = size.layers;
    const double shell = cube(m * p + 1) - cube(m * p);
    return {cube(m * p + 1) + k * p * shell, cube(p - 1) * static_cast<double>(size.elements), shell};
}

Nodes prism_nodes(const MeshSize& size, int order) {
    const double p = order, m = size.elements_per_edge, k = size.layers, slices = m + k;
    const double cross_section = (m * p + 1) * (m * p + 1) + k * p * (2 * m * p + 1);
    const double inside = (p - 1) * (p - 1) * (p - 2) / 2;
    return {cross_section * (slices * p + 1), inside * static_cast<double>(size.elements), cross_section / 3};
}

Nodes adaptive_nodes(const FemSpec& fem) {
    return {static_cast<double>(fem.max_dofs) / 3, 0, 0};
}

BuildSize size_of(const FemSpec& fem, const Nodes& nodes, int processes) {
    BuildSize size;
    size.dofs = static_cast<long long>(3 * nodes.all);
    size.solver = solver_for(fem, size.dofs, processes);
    size.bytes = program + (processes - 1) * per_process;
    if (size.solver == Solver::direct)
        size.bytes += per_factor_entry * 3 * (nodes.all - nodes.inside) * 3 * nodes.section;
    else
        size.bytes += per_nonzero * nonzeros_per_dof(fem) * 3 * nodes.all;
    return size;
}

Nodes mesh_nodes(const IcSpec& spec) {
    switch (spec.fem.mesh) {
        case MeshKind::hex:
            return hex_nodes(mesh_size(spec), spec.fem.order);
        case MeshKind::prism:
            return prism_nodes(mesh_size(spec), spec.fem.order);
        case MeshKind::adaptive:
            break;
    }
    return adaptive_nodes(spec.fem);
}

/// Every process stores a whole section.
BuildSize section_size(const IcSpec& spec, int processes) {
    const geometry::SectionGeometry section(*spec.section, spec.ny, spec.dy, "ics.section");
    const SpectrumSize one = predicted_spectrum(outline_of(section), spec.material.nu, spec.accuracy);
    constexpr double with_mesher = 110e6;
    const double bytes = processes * (with_mesher + one.model_bytes + one.spectrum_bytes);
    return {static_cast<long long>(one.unknowns), Solver::direct, bytes};
}

double table_bytes(const IcSpec& spec) {
    constexpr int components = 9;
    const double one = components * sizeof(double) * static_cast<double>(spec.nx) * spec.ny;
    // Counts the tables that were built, and those of the record.
    const double tables = spec.any_nu ? 2.0 * static_cast<double>(family_points(5).size()) : 0;
    return (tables + sizes_of_a_table) * one;
}

std::string gigabytes(double bytes) {
    char text[40];
    std::snprintf(text, sizeof text, "%.3g GB", bytes / 1e9);
    return text;
}

/// Returns the mesh with `change` applied to its spec, if it fits.
bool fits(IcSpec spec, double most, const auto& change) {
    change(spec.fem);
    return predicted_size(spec, 1).bytes <= most;
}

/// Suggests another request.
std::string advice(const IcSpec& spec, const BuildSize& size, double most) {
    char text[200];
    if (spec.section) return "Use a coarser accuracy, or fewer strips";
    if (table_bytes(spec) > size.bytes / 2) return "Use a grid of fewer elements";
    if (spec.accuracy > 0) return "Use a coarser accuracy";
    if (spec.fem.mesh == MeshKind::adaptive) {
        std::snprintf(text, sizeof text, "Use a max_dofs of %.0f or less",
                      static_cast<double>(spec.fem.max_dofs) * std::max(most - program, 0.0) / (size.bytes - program));
        return text;
    }
    for (int order = spec.fem.order - 1; order >= 2; --order)
        if (fits(spec, most, [&](FemSpec& fem) { fem.order = order; })) {
            std::snprintf(text, sizeof text, "Use order %d, ", order);
            return text + std::string("layers that grow faster (f), or a smaller mesh (L_over_h, l_over_h)");
        }
    return "Use layers that grow faster (f), or a smaller mesh (L_over_h, l_over_h, h_over_hs)";
}

const char* field_of(const IcSpec& spec, const BuildSize& size) {
    if (spec.section) return "ics.accuracy";
    if (table_bytes(spec) > size.bytes / 2) return "grid";
    if (spec.accuracy > 0) return "ics.accuracy";
    return spec.fem.mesh == MeshKind::adaptive ? "ics.max_dofs" : "ics";
}

}  // namespace

double nonzeros_per_dof(const FemSpec& fem) {
    // Counts 1, 3 and p - 1 (p - 1)^2 ... nodes of each kind with their neighbours: ((p + 1)(p - 1) + 2p + 1)/p along
    // each axis, and about three quarters of that in the triangles of prisms.
    return 3 * cube(fem.order + 2) * (fem.mesh == MeshKind::prism ? 0.75 : 1);
}

Solver solver_for(const FemSpec& fem, long long dofs, int processes) {
    // Hanging nodes tie degrees of freedom together, which only the distributed matrix supports.
    const bool possible = processes == 1 && fem.mesh != MeshKind::adaptive;
    if (fem.solver != Solver::automatic) return fem.solver;
    // The update is a stopping criterion of iterative solvers only.
    if (fem.stopping_criterion == StoppingCriterion::update) return Solver::amg_pcg;
    return possible && dofs <= direct_dofs(fem.order) ? Solver::direct : Solver::amg_pcg;
}

BuildSize predicted_size(const IcSpec& spec, int processes) {
    if (spec.section) return section_size(spec, processes);
    BuildSize size;
    if (spec.accuracy == 0) {
        size = size_of(spec.fem, mesh_nodes(spec), processes);
    } else if (spec.body == BodyShape::block) {
        const auto [order, intervals] = first_block_level();
        const double nodes = order * intervals + 1;
        size.dofs = static_cast<long long>(3 * cube(nodes));
        size.bytes = program + per_tensor_dof * 3 * cube(nodes);
    } else {
        const IcSpec mesh = first_mesh(spec, spec.any_nu ? largest_family_nu : spec.material.nu);
        size = size_of(mesh.fem, mesh_nodes(mesh), processes);
    }
    size.bytes += table_bytes(spec);
    return size;
}

void require_room(const IcSpec& spec, const BuildSize& size, std::uint64_t max_memory_bytes) {
    constexpr double certainty = 1.5;
    const auto most = static_cast<double>(max_memory_bytes);
    if (max_memory_bytes == 0 || size.bytes <= certainty * most) return;
    throw OutOfMemory(field_of(spec, size), "The build would take about " + gigabytes(size.bytes) + " of memory for " +
                                                std::to_string(size.dofs) + " unknowns, but may use " +
                                                std::to_string(max_memory_bytes) +
                                                " bytes (builds.max_memory_bytes). " + advice(spec, size, most) + ".");
}

}  // namespace contactd::fem
