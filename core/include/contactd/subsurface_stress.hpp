// Defines requests and answers of stresses inside a body as plain values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/ic_spec.hpp"

namespace contactd {

/// Each body has its own frame, in which it occupies z <= 0 and its outward normal is +z: x and y are those of the
/// grid, -z is the depth below the surface. The frame of the lower body is that of the contact problem, and that of the
/// upper one is its mirror image: in the frame of the problem, xz and yz of the upper body have the opposite sign.
enum class ContactBody { upper, lower };

/// Holds tractions that act on the surface of a body, in its frame, each of shape [ny, nx] (N/mm^2); empty means zero.
struct SurfaceTractions {
    std::vector<double> x, y, z;
};

using StressPoints = std::vector<std::array<double, 3>>;

/// Describes the points (x[ix], y[iy], z[iz]) in any order, with index (iz*ny + iy)*nx + ix. Results have shape [nz,
/// ny, nx].
struct StressBlock {
    std::vector<double> x, y, z;  ///< (mm), z <= 0

    std::size_t size() const { return x.size() * y.size() * z.size(); }
};

using SubsurfacePoints = std::variant<StressPoints, StressBlock>;

/// Holds displacements at the requested points (mm), in the frame of the body. They vanish far away.
struct SubsurfaceDisplacement {
    std::vector<double> x, y, z;
};

/// Holds stresses at the requested points, in order (N/mm^2); tension is positive.
struct SubsurfaceStress {
    std::vector<double> xx, yy, zz, xy, xz, yz;
    std::vector<double> von_mises;
    /// find_invariants fills these: the mean of the normal stresses, the principal stresses, the first of which is the
    /// largest and the third the smallest, and the Tresca stress, which is the difference of these two.
    std::vector<double> hydrostatic, principal_1, principal_2, principal_3, tresca;
    std::size_t largest = 0;  ///< the point with the largest von Mises stress; the first of equal ones
};

/// Requests stresses inside one body of a contact problem. Points are in the frame of that body.
struct SubsurfaceRequest {
    Grid grid;
    double nu = 0;  ///< Poisson's ratio of the body, 0 to 0.5; not used if ics has layers
    ContactBody body = ContactBody::lower;
    Ics ics;  ///< bodies of the solved problem: a half-space (also with a line contact) or layers; with angles also a
              ///< longitudinally uniform body
    /// Holds the tractions on the upper body of a contact solution, for requests of either body. The shape is [ny, nx]
    /// (N/mm^2); tractions may be empty, which means zero.
    std::vector<double> pressure, traction_x, traction_y;
    /// Holds the inclination of each row (rad), as for subsurface_stress(); it is empty for a plane.
    std::vector<double> angles{};
    SubsurfacePoints points;
    bool invariants = false;  ///< whether the reply includes those of find_invariants
    /// If given, the body's shear modulus (N/mm^2) requests displacements, for half-spaces only.
    std::optional<double> G{};

    std::vector<std::size_t> shape() const;                ///< shape of the results: [n], or [nz, ny, nx] for a block
    std::array<double, 3> point(std::size_t index) const;  ///< the point of a result
};

/// Describes the point with the largest von Mises stress.
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
