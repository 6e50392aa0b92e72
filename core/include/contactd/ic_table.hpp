// Defines a table of influence coefficients and the evidence for its numbers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "contactd/axis.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/unset_array.hpp"

namespace contactd {

/// A[i,j](k,l) is the displacement component i (mm) at the element whose offset from the loaded element is (k,l), for a
/// unit traction (1 N/mm^2) along j on the loaded element. The body is z <= 0 with the outward normal +z, and a load is
/// positive along its axis.
struct IcTable {
    int nx = 0;         ///< offsets 0..nx-1 along x
    int ny = 0;         ///< offsets 0..ny-1 along y
    UnsetArray values;  ///< shape [3, 3, ny, nx]: displacement axis, load axis, l, k; mm^3/N

    IcTable() = default;
    IcTable(int nx_, int ny_) : nx(nx_), ny(ny_), values(9 * component_size(), 0.0) {}

    std::size_t component_size() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    std::size_t index(Axis i, Axis j, int k, int l) const {
        return (static_cast<std::size_t>(i) * 3 + static_cast<std::size_t>(j)) * component_size() +
               static_cast<std::size_t>(l) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(k);
    }
    double& operator()(Axis i, Axis j, int k, int l) { return values[index(i, j, k, l)]; }  ///< k, l >= 0
    double operator()(Axis i, Axis j, int k, int l) const { return values[index(i, j, k, l)]; }
    /// Returns the coefficient at offsets of either sign, |k| < nx and |l| < ny, by parity.
    double at(Axis i, Axis j, int k, int l) const;

    bool operator==(const IcTable&) const = default;
};

/// Describes one solve of a finite-element build.
struct LoadCaseEvidence {
    Axis load = Axis::z;
    int iterations = 0;
    double residual = 0;  ///< true relative residual ||b - A u|| / ||b||
    bool converged = false;
    double seconds = 0;            ///< of the solve
    std::optional<double> update;  ///< relative update ||u_new - u|| / ||u_new|| of the last iteration, if it is the
                                   ///< stopping criterion
};

/// Holds relative errors against the closed form: the paper's measure (3.1) at the origin, signed (FEM/closed form -
/// 1), and the largest absolute one over the table.
struct ComponentError {
    double origin = 0;
    double largest = 0;
};

/// Holds errors over a table, if known.
struct IcErrors {
    std::optional<ComponentError> xx, yy, zz;
    /// These are the largest |FEM - closed form| * 2 pi G rho / (dx dy) over the offsets except the origin. They are
    /// for the components that vanish on the axes, where relative errors are useless: xy and yx, and xz, zx, yz and zy.
    std::optional<double> scaled_xy, scaled_xz;
};

/// Holds the times of a build (s).
struct BuildSeconds {
    double assembly = 0;
    double setup = 0;  ///< of the preconditioners
    double solve = 0;
    double total = 0;
};

/// Describes how the transform of a longitudinally uniform body's coefficients was computed, and its errors over zz of
/// the half-space under an element as long as the width of a strip.
struct SectionEvidence {
    int order = 0;        ///< of the elements
    int wavenumbers = 0;  ///< number of wavenumbers at which it was computed
    double error = 0;     ///< error of any coefficient: the sum of the three below
    double mesh_error = 0;
    double wavenumber_error = 0;    ///< of interpolation between them
    double end_error = 0;           ///< error of the part beyond the last wavenumber
    double reciprocity_defect = 0;  ///< before the table was made symmetric, which removes the defect

    bool operator==(const SectionEvidence&) const = default;
};

/// Describes the origin and the accuracy of the numbers of a table.
struct IcEvidence {
    std::string source;   ///< "analytic" or "fem"
    std::string version;  ///< contactd and libraries that computed the table
    long long elements = 0;
    long long dofs = 0;
    int processes = 1;
    BuildSeconds seconds;
    std::vector<LoadCaseEvidence> load_cases;
    std::string solver;                 ///< "amg_pcg", "direct" or "tensor_pcg"; empty for a closed form
    std::optional<FemSpec> mesh;        ///< chosen for IcSpec::accuracy; not for a block
    std::vector<std::string> warnings;  ///< sentences for users of the table
    /// Errors are relative to the closed form if there is one (half-space). For a block with a requested accuracy, they
    /// are estimated from the difference to a coarser mesh; `errors_estimated` is then set.
    IcErrors errors;
    bool errors_estimated = false;
    /// Coefficients of a block depend on the loaded element. This is the largest difference between the table and that
    /// of a load in the corner of as many elements as the table has offsets, about the middle of the block, in the
    /// measures of IcSpec::accuracy.
    std::optional<double> modelling_error;
    /// These are the computed Poisson's ratios of a family, and the largest additional error of interpolation between
    /// them, in the measures above.
    std::vector<double> family_nu;
    std::optional<double> interpolation_error;
    std::optional<SectionEvidence> section;  ///< for a longitudinally uniform body by finite elements
    bool imported = false;                   ///< the table was imported, and contactd did not verify this
};

/// Returns all values times `factor`. With factor = dx/G, the dimensionless table becomes A for G and dx.
IcTable scaled(const IcTable& table, double factor);

/// Returns the part with offsets 0..nx-1 x 0..ny-1, times `factor`. Throws InvalidArgument if the table is smaller.
IcTable cropped(const IcTable& table, int nx, int ny, double factor = 1);

/// Returns the coefficients of the difference of displacements of the two bodies for equal and opposite tractions. It
/// sums xx, yy, zz, xy, yx and subtracts xz, zx, yz, zy of the upper body from those of the lower, because a pressure
/// is positive and a load along z pulls. Throws InvalidArgument if the extents differ.
IcTable pair_of(IcTable upper, const IcTable& lower);

}  // namespace contactd
