// Stresses inside a body as plain values: where they are wanted, and what they are.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/ic_spec.hpp"

namespace contactd {

/// Each body has a frame of its own, in which it is z <= 0 and its outward normal is +z: x and y are those of the grid,
/// -z is the distance from the surface into the body. The frame of the lower body is that of the contact problem, that
/// of the upper one its mirror image: turned into the frame of the problem, xz and yz of the upper body change sign.
enum class ContactBody { upper, lower };

/// Tractions that act on the surface of a body, in its frame, each of shape [ny, nx] (N/mm^2); empty means zero.
struct SurfaceTractions {
    std::vector<double> x, y, z;
};

using StressPoints = std::vector<std::array<double, 3>>;

/// The points (x[ix], y[iy], z[iz]) in any order, with index (iz*ny + iy)*nx + ix: results have shape [nz, ny, nx].
struct StressBlock {
    std::vector<double> x, y, z;  ///< (mm), z <= 0

    std::size_t size() const { return x.size() * y.size() * z.size(); }
};

using SubsurfacePoints = std::variant<StressPoints, StressBlock>;

/// At the points asked for (mm), in the frame of the body. They vanish far away.
struct SubsurfaceDisplacement {
    std::vector<double> x, y, z;
};

/// At the points asked for, in their order (N/mm^2); tension is positive.
struct SubsurfaceStress {
    std::vector<double> xx, yy, zz, xy, xz, yz;
    std::vector<double> von_mises;
    /// Where find_invariants was called: the mean of the normal stresses, the principal stresses, the first of which is
    /// the largest and the third the smallest, and Tresca's equivalent stress, by which these two differ.
    std::vector<double> hydrostatic, principal_1, principal_2, principal_3, tresca;
    std::size_t largest = 0;  ///< the point with the largest von Mises stress; the first one of equals
};

/// Stresses inside one body of a contact problem are wanted. Points are in the frame of that body.
struct SubsurfaceRequest {
    Grid grid;
    double nu = 0;  ///< Poisson's ratio of the body, 0 to 0.5; of no meaning where ics has layers
    ContactBody body = ContactBody::lower;
    Ics ics;  ///< that the tractions were solved with: of a half-space (also of a line contact) or layers; with
              ///< angles also of a longitudinally uniform body; none else
    /// Tractions of a contact solution, for either body: those on the upper one. Shape [ny, nx] (N/mm^2); tractions may
    /// be empty, which means zero.
    std::vector<double> pressure, traction_x, traction_y;
    /// Inclination of each row (rad), as subsurface_stress() has it; none of a plane.
    std::vector<double> angles{};
    SubsurfacePoints points;
    bool invariants = false;  ///< whether the reply has those of find_invariants
    /// The body's shear modulus (N/mm^2), where displacements are wanted, too; of half-spaces.
    std::optional<double> G{};

    std::vector<std::size_t> shape() const;                ///< of the results: [n], or [nz, ny, nx] of a block
    std::array<double, 3> point(std::size_t index) const;  ///< the point of a result
};

/// Where the von Mises stress is largest.
struct LargestStress {
    double von_mises = 0;        ///< (N/mm^2)
    double x = 0, y = 0, z = 0;  ///< (mm)

    double depth() const { return 0 - z; }  ///< (mm)
};

struct SubsurfaceReply {
    SubsurfaceStress stress;
    std::optional<SubsurfaceDisplacement> displacement;
    std::vector<std::size_t> shape;  ///< of all its arrays
    LargestStress largest;
};

}  // namespace contactd
