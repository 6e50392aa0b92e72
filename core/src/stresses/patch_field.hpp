// The fields inside a half-space that tractions on its surface make, as sums over the corners of elements.
#pragma once

#include <array>
#include <cstddef>

#include "patch_displacement.hpp"
#include "patch_stress.hpp"

namespace contactd {

/// Stresses (N/mm^2).
struct StressField {
    using Components = StressComponents;
    double nu = 0, smallest = 0;

    Components at_corner(Axis load, double x, double y, double d) const {
        return corner_stress(load, x, y, d, nu, smallest);
    }
    static Parity parity(Axis load, std::size_t component) { return stress_parity(load, component); }
};

/// Displacements times the shear modulus (N/mm).
struct DisplacementField {
    using Components = Displacement;
    double nu = 0, smallest = 0;

    Components at_corner(Axis load, double x, double y, double d) const {
        return corner_displacement(load, x, y, d, nu, smallest);
    }
    static Parity parity(Axis load, std::size_t component) { return displacement_parity(load, component); }
};

template <class Field>
constexpr std::size_t components_of_field = std::tuple_size_v<typename Field::Components>;

}  // namespace contactd
