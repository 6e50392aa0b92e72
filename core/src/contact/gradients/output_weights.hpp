// Converts the cotangents of an output to derivatives with respect to the fields of a solution.
#pragma once

#include <string>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "contactd/contact.hpp"
#include "contactd/gradients.hpp"

namespace contactd {

// Holds the derivatives of an output with respect to pressures, tractions and slip in mm of each element of the grid,
// and with respect to the approach and the motion along x and y themselves.
struct OutputWeights {
    std::vector<double> pressure;
    Field traction, slip;
    double approach = 0, along_x = 0, along_y = 0;

    explicit OutputWeights(std::size_t size) : pressure(size), traction(size), slip(size) {}
};

// `solution` has its slip in mm; `unit` is the distance of a step, or 1 of a shift.
OutputWeights weights_of(const Cotangents& output, const Grid& grid, const ContactSolution& solution, double unit);

// Returns a warning if the largest pressure is nearly that of other elements, so that its gradient is arbitrary.
std::string tie_warning(const Cotangents& output, const ContactSolution& solution);

}  // namespace contactd
