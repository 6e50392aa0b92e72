// What identifies an influence-coefficient table: everything that decides its numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "contactd/material.hpp"

namespace contactd {

enum class LoadShape { constant };      ///< unit traction over one element
enum class IcSource { analytic, fem };  ///< closed form of the half-space, or finite elements
enum class MeshKind { hex };            ///< Mesh1 of the paper (section 3.1)
enum class FarBoundary { clamped };     ///< u = 0 on the three far faces (Table 1)
/// How displacements are read at the element centres: the finite-element function itself, or linear interpolation, of
/// which the paper (section 2.2) does not say between what: between the vertices of the surface mesh, or between all
/// finite-element nodes, those on edges and faces included.
enum class Sampling { fem, linear, linear_nodes };

/// The words for these on the wire and in files: "constant", "analytic", "hex", "clamped", "linear", ...
std::string_view name_of(LoadShape value);
std::string_view name_of(IcSource value);
std::string_view name_of(MeshKind value);
std::string_view name_of(FarBoundary value);
std::string_view name_of(Sampling value);

/// The reverse: sets `value` and returns true, or returns false when no value has that name.
bool from_name(std::string_view name, LoadShape& value);
bool from_name(std::string_view name, IcSource& value);
bool from_name(std::string_view name, MeshKind& value);
bool from_name(std::string_view name, FarBoundary& value);
bool from_name(std::string_view name, Sampling& value);

/// Mesh and solver of a finite-element table. Lengths are ratios to the element size: along x and y the loaded cube
/// is (l/h) dx by (l/h) dy, in depth (l/h) sqrt(dx dy); L is (L/h) max(dx, dy).
struct FemSpec {
    MeshKind mesh = MeshKind::hex;
    int order = 2;          ///< polynomial order of the displacement, 1 or 2
    double l_over_h = 1;    ///< size of the uniform cube over the element size
    double h_over_hs = 4;   ///< element size of the contact grid over that of the cube's mesh, an even integer
    double f = 1.2;         ///< growth of the layers outside the cube, >= 1
    double L_over_h = 640;  ///< size of the block over the element size
    FarBoundary far_boundary = FarBoundary::clamped;
    Sampling sampling = Sampling::fem;
    double tolerance = 1e-8;          ///< on the true relative residual ||b - A u|| / ||b||
    int max_iterations = 1000;        ///< of conjugate gradients, per load case
    double strength_threshold = 0.5;  ///< of BoomerAMG

    bool operator==(const FemSpec&) const = default;
};

/// The presets of the paper's Table 2: "paper-test1", "paper-test2", "paper-test3". Empty when the name is unknown.
std::optional<FemSpec> fem_preset(std::string_view name);

struct IcSpec {
    Material material;
    double dx = 0;  ///< element size along x (mm)
    double dy = 0;  ///< element size along y (mm)
    int nx = 0;     ///< extent: offsets 0..nx-1 along x
    int ny = 0;     ///< extent: offsets 0..ny-1 along y
    LoadShape load_shape = LoadShape::constant;
    IcSource source = IcSource::analytic;
    FemSpec fem;  ///< of no meaning when source is analytic

    bool operator==(const IcSpec&) const = default;
};

/// Throws InvalidArgument naming the field (as on the wire, e.g. "fem.h_over_hs") when no table can be made from it.
void validate(const IcSpec& spec);

/// The size of Mesh1 for a spec.
struct MeshSize {
    int elements_per_edge;  ///< m, of the cube and of every layer
    int layers;             ///< k, of growing thickness
    long long elements;     ///< m^3 + 3 m^2 k
};
MeshSize mesh_size(const IcSpec& spec);

/// The same table for G = 1 and dx = 1, ratios rounded to twelve digits so that equal ratios compare equal whatever
/// lengths they were computed from. Displacements scale exactly: A = (dx/G) * A of this spec.
IcSpec dimensionless(const IcSpec& spec);

}  // namespace contactd
