// Computes stresses below the rows of a contact, on lines along x that are the histories of particles.
#pragma once

#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "contactd/subsurface_stress.hpp"

namespace contactd {

/// Holds half-open ranges of rows and elements of a contact.
struct ContactBox {
    int first_x = 0, end_x = 0, first_y = 0, end_y = 0;

    bool empty() const { return first_y >= end_y; }
    std::size_t rows() const { return static_cast<std::size_t>(end_y - first_y); }
};

ContactBox contact_box(const Grid& grid, const std::vector<double>& pressure);

/// Holds stresses in the frame of the body at the middles of elements, before, in and behind the contact: shape
/// [depths, rows, x].
struct PassageStress {
    std::vector<double> depths{};
    std::size_t rows = 0, nx = 0;
    double dx = 0;
    SubsurfaceStress stress;

    std::size_t begin_of(std::size_t depth, std::size_t row) const { return (depth * rows + row) * nx; }
};

/// Computes the stresses. `angles` (rad) are those of all rows of the grid, of the tangent from y towards the lower
/// body's outside; empty for a plane contact. Depths are those of the request, or chosen. Reports and throws as
/// subsurface_stress().
PassageStress passage_stress(const ContactProblem& problem, const ContactSolution& solution, const ContactBox& box,
                             std::span<const double> angles, Observer& observer);

}  // namespace contactd
