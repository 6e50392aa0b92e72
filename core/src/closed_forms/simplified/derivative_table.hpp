// Derivatives as a table, and by their names.
#pragma once

#include <array>

#include "contactd/contact.hpp"

namespace contactd {

/// A table of derivatives of forces: by the approach, by the motion along x, along y and about z, and by friction, all
/// with the approach prescribed.
struct DerivativeTable {
    enum Row { Fn, Fx, Fy, Mz, rows };
    enum Column { approach, along_x, along_y, about_z, mu, columns };

    std::array<std::array<double, columns>, rows> values{};
    /// Derivatives that the model does not know are left out.
    bool has_rotation = true, has_mu = true;
};

/// By the inputs of the problem; where it prescribes the normal force, with that and the approach exchanged.
Derivatives named(const DerivativeTable& table, const ContactProblem& problem);

}  // namespace contactd
