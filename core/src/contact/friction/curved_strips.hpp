// Computes motion and forces on strips of elements that are curved along y.
#pragma once

#include <vector>

#include "contact/rolling/rolling.hpp"
#include "contactd/contact.hpp"

namespace contactd {

/// Returns the cosines of the angles between the elements' normals and the direction of approach, shape [ny, nx].
std::vector<double> facing(const ContactColumns& strips, const Grid& grid);

/// Returns the rigid slip of a body along the axes of each strip. The body translates by (xi, eta) along x and along
/// the direction across x and the approach, and rotates by phi about the direction of approach at the strips' origin.
/// `slip_of` returns the slip of a plane's row of elements: each strip is such a row at its distance across from the
/// origin, seen at an angle.
template <class SlipOf>
RigidSlip rigid_slip(const ContactColumns& strips, const Grid& grid, const SlipOf& slip_of);

/// Computes forces and resultant of a solution, which contains its arrays.
void sum_forces(const ContactColumns& strips, const Grid& grid, ContactSolution& solution);

/// Returns a row of the grid as a row of a plane: its y is the distance of the strip from the origin across x and the
/// direction.
Grid row_across(const ContactColumns& strips, const Grid& grid, int iy);

template <class SlipOf>
RigidSlip rigid_slip(const ContactColumns& strips, const Grid& grid, const SlipOf& slip_of) {
    const std::vector<double> cosine = facing(strips, grid);
    RigidSlip result;
    for (int iy = 0; iy < grid.ny; ++iy) {
        const RigidSlip row = slip_of(row_across(strips, grid, iy));
        result.x.insert(result.x.end(), row.x.begin(), row.x.end());
        result.y.insert(result.y.end(), row.y.begin(), row.y.end());
    }
    for (std::size_t i = 0; i < result.y.size(); ++i) result.y[i] *= cosine[i];
    return result;
}

}  // namespace contactd
