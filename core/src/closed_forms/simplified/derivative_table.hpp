// Holds derivatives as a table, and converts them to names.
#pragma once

#include <array>

#include "contactd/contact.hpp"

namespace contactd {

/// Holds derivatives of forces with respect to the approach, to the motion along x, along y and about z, and to
/// friction, all with the approach prescribed.
struct DerivativeTable {
    enum Row { Fn, Fx, Fy, Mz, rows };
    enum Column { approach, along_x, along_y, about_z, mu, columns };

    std::array<std::array<double, columns>, rows> values{};
    /// Derivatives that the model does not have are omitted.
    bool has_rotation = true, has_mu = true;
};

/// Returns the derivatives with respect to the inputs of the problem. If it prescribes the normal force, force and
/// approach are exchanged.
Derivatives named(const DerivativeTable& table, const ContactProblem& problem);

}  // namespace contactd
