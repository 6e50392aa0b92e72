// Defines the identity of an influence-coefficient table: everything that determines its numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "contactd/layers.hpp"
#include "contactd/material.hpp"
#include "contactd/section.hpp"

namespace contactd {

/// contactd/fields/ic_spec.hpp contains the keywords of these enums on the wire and in files.

/// Selects the elastic body: the half-space z <= 0, the block [-L,L]^2 x [-L,0] with u = 0 on all faces except the top,
/// layers, or a longitudinally uniform body with any cross-section, uniform along x.
enum class BodyShape { half_space, block, layered, longitudinally_uniform };
/// Selects the traction of the loaded element: 1 over it, or the bilinear hat function (paper, Remark 1). The hat is 1
/// at its centre and falls linearly to 0 at the neighbours' centres, (1 - |x|/dx)(1 - |y|/dy). The force is dx dy
/// either way.
enum class LoadShape { constant, bilinear };
/// Selects the source: analytic is the closed form of the half-space, and for layers an integral exact to rounding; fem
/// is finite elements.
enum class IcSource { analytic, fem };
/// Selects Mesh1 of the paper (hexahedra, section 3.1), Mesh2 (prisms, extruded along x), or hexahedra refined
/// according to an a-posteriori estimate of the error.
enum class MeshKind { hex, prism, adaptive };
/// Selects the condition on the three far faces: u = 0 (Table 1), or the displacements of the half-space under the load
/// (Boussinesq, Cerruti).
enum class FarBoundary { clamped, half_space };
/// Selects how displacements are evaluated at the element centres: from the finite-element function itself, or by
/// linear interpolation. The paper (section 2.2) does not state the points of interpolation: `linear` uses the vertices
/// of the surface mesh, `linear_nodes` all finite-element nodes, including those on edges and faces.
enum class Sampling { fem, linear, linear_nodes };
/// Selects BoomerAMG-preconditioned conjugate gradients, sparse Cholesky (one process only), or the faster of the two.
enum class Solver { automatic, amg_pcg, direct };
/// Selects the quantity that conjugate gradients compare with the tolerance: the true relative residual ||b - A u|| /
/// ||b||, or the relative update ||u_new - u|| / ||u_new|| (the paper, section 3).
enum class StoppingCriterion { residual, update };
/// Selects the diagonal of Mesh2 that divides a quadrilateral of the cross-section into triangles. `outward` runs from
/// the corner nearest to the origin to the farthest one; `across` joins the other two.
enum class Diagonal { outward, across };

/// Describes the mesh and the solver of a finite-element table. Lengths are ratios to the element size. Along x and y
/// the loaded cube is (l/h) dx by (l/h) dy, in depth it is (l/h) sqrt(dx dy), and L is (L/h) max(dx, dy). An adaptive
/// mesh starts from its own mesh, without cube and layers. fem_fields.hpp defines names and rules.
struct FemSpec {
    MeshKind mesh = MeshKind::hex;
    int order = 2;          ///< polynomial order of the displacement, 1 to 6
    double l_over_h = 1;    ///< size of the uniform cube over the element size
    double h_over_hs = 4;   ///< element size of the contact grid over that of the cube's mesh, an even integer
    double f = 1.2;         ///< growth of the layers outside the cube, >= 1
    double t1_over_hs = 0;  ///< thickness of the first layer over the cube's element size; 0 means f, as in the paper
    double L_over_h = 640;  ///< size of the block over the element size
    Diagonal diagonal = Diagonal::outward;  ///< of mesh prism only
    long long max_dofs = 60'000;            ///< limit of refinement, for mesh adaptive only
    FarBoundary far_boundary = FarBoundary::half_space;
    Sampling sampling = Sampling::fem;
    Solver solver = Solver::automatic;
    StoppingCriterion stopping_criterion = StoppingCriterion::residual;
    double tolerance = 1e-8;                   ///< of the stopping criterion
    int max_iterations = 1000;                 ///< limit of conjugate gradients, per load case
    std::optional<double> strength_threshold;  ///< threshold of BoomerAMG; absent: chosen for the mesh

    bool operator==(const FemSpec&) const = default;
};

/// Returns a preset of the paper's Table 2, with u = 0 on the far faces and conjugate gradients: "paper-test1",
/// "paper-test2", "paper-test3" on Mesh1, and "paper-mesh2-test1", ... on Mesh2. It is empty if the name is unknown.
std::optional<FemSpec> fem_preset(std::string_view name);

/// Describes a contact that is infinite and constant along y: plane strain for tractions and displacements in x and z,
/// anti-plane strain for those along y. Displacements in the plane are determined except for a constant.
struct LineContactSpec {
    /// At this distance from a load, along the surface, its xx, yy and zz vanish (mm). It affects the approach and the
    /// rigid shift, but neither solutions for prescribed forces nor steady rolling.
    double datum = 0;

    bool operator==(const LineContactSpec&) const = default;
};

/// Describes the origin of coefficients, independent of material and grid: `ics` of a request.
struct Ics {
    IcSource source = IcSource::analytic;
    BodyShape body = BodyShape::half_space;
    LoadShape load_shape = LoadShape::constant;
    /// If > 0, this is the largest allowed error. It is relative for xx, yy, zz (for a block, to at least a fraction of
    /// the half-space's, half_space.hpp), and times 2 pi G rho / (dx dy) for the others. Mesh and solver are then
    /// chosen when the table is built; of `fem` only L_over_h of a block is used.
    double accuracy = 0;
    /// A line contact requires source analytic and a grid with ny = 1; forces are those on the length dy.
    std::optional<LineContactSpec> line_contact;
    std::optional<Layers> layered;  ///< only for body layered
    /// A section is only for body longitudinally_uniform. Its strips are the rows of a grid, dy wide along the outline.
    /// With source analytic, the half-space is rotated from strip to strip (Blanco-Lorenzo et al., 2016).
    std::optional<Section> section;
    bool any_nu = false;  ///< the family of tables over Poisson's ratio instead of one table
    FemSpec fem;          ///< not used if source is analytic

    bool operator==(const Ics&) const = default;
};

/// Selects how a number of a part enters a dimensionless spec: unchanged, or divided by dx.
enum class Dimension { ratio, length };
template <class Part>
struct PartField {
    const char* name;
    double Part::* member;
    Dimension dimension;
};
/// Describes a part of `ics` for one kind of body or contact: an object that the other kinds omit.
template <class Part>
struct IcsPart {
    const char* name;
    std::optional<Part> Ics::* member;
};

/// These are the only lists of the parts and of their fields. The wire, files and keys visit them.
template <class Part>
inline constexpr std::tuple<> part_fields{};
template <>
inline constexpr std::tuple part_fields<LineContactSpec>{
    PartField<LineContactSpec>{"datum", &LineContactSpec::datum, Dimension::length}};
inline constexpr std::tuple ics_parts{IcsPart<LineContactSpec>{"line_contact", &Ics::line_contact}};

/// Calls `visit` with each part in turn, or with each field of a part.
template <class Visit>
void for_each_ics_part(const Visit& visit) {
    std::apply([&](const auto&... part) { (visit(part), ...); }, ics_parts);
}
template <class Part, class Visit>
void for_each_part_field(const Visit& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, part_fields<Part>);
}

/// Identifies one table: the source of its coefficients, and its body.
struct IcSpec : Ics {
    Material material;  ///< nu is not used with any_nu; for body layered, that of its surface
    double dx = 0;      ///< element size along x (mm)
    double dy = 0;      ///< element size along y (mm)
    int nx = 0;         ///< extent: offsets 0..nx-1 along x
    int ny = 0;         ///< extent: offsets 0..ny-1 along y

    bool operator==(const IcSpec&) const = default;
};

/// Returns the number of rows of a table in ic.get and IcReply, which are offsets along y. The rows of a longitudinally
/// uniform body are pairs of strips: row I ny + J is for the observed strip I and the loaded strip J.
inline int table_rows(const IcSpec& spec) {
    return spec.section ? spec.ny * spec.ny : spec.ny;
}

/// These are the bounds of the requested accuracy, and of Poisson's ratio in a family.
inline constexpr double finest_accuracy = 1e-4, coarsest_accuracy = 1e-1;
inline constexpr double largest_family_nu = 0.49;
/// Poisson's ratio of a longitudinally uniform body by finite elements is at most this.
inline constexpr double largest_uniform_nu = 0.499;
/// Below and above this ratio, a family is interpolated separately and has separate meshes, because nearly
/// incompressible materials need finer meshes.
inline constexpr double family_break = 0.3;

/// Throws InvalidArgument, which names the field (as on the wire, e.g. "fem.h_over_hs"), if no table can be made from
/// the spec.
void validate(const IcSpec& spec);
/// Checks a spec like the function above; errors name the material as in a problem: "bodies.upper" instead of
/// "material".
void validate(const IcSpec& spec, const std::string& material);

/// Returns a sentence for each deviation from the paper's advice for its model with u = 0 on the far faces (Table 3:
/// L/h >= 80, 1 <= l/h <= 1.25, h/hs >= 4, f from 1 to 1.5 on Mesh1 and from 1.5 to 2 on Mesh2, quadratic elements).
/// Also returns one for a block with a Poisson's ratio for which elements of this order lock.
std::vector<std::string> warnings(const IcSpec& spec);

/// Returns a sentence if the modelling error of a block's table (IcEvidence::modelling_error) for `spec` exceeds the
/// requested accuracy or, for a given mesh, 1 %.
std::vector<std::string> modelling_warnings(const IcSpec& spec, double error);

/// Holds the size of Mesh1 or Mesh2 for a spec. That of an adaptive mesh is only known after it is built.
struct MeshSize {
    int elements_per_edge;  ///< m, of the cube and of every layer
    int layers;             ///< k, of growing thickness
    long long elements;     ///< m^3 + 3 m^2 k of Mesh1, 2 (m^2 + 2 m k)(m + k) of Mesh2
};
MeshSize mesh_size(const IcSpec& spec);

/// Returns the spec of the table for G = 1 and dx = 1, with ratios rounded to twelve digits so that equal ratios of
/// different lengths compare equal. Displacements scale exactly: A = (dx/G) * A of this spec.
IcSpec dimensionless(const IcSpec& spec);

}  // namespace contactd
