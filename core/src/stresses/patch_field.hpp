// Computes the fields inside a half-space that tractions on its surface produce, as sums over the corners of elements.
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "patch_displacement.hpp"
#include "patch_stress.hpp"

namespace contactd {

/// Describes a field by its antiderivatives at corners and their parity.
template <auto corner, auto parity_at>
struct PatchField {
    using Components = std::invoke_result_t<decltype(corner), Axis, double, double, double, double, double>;
    double nu = 0, smallest = 0;

    Components at_corner(Axis load, double x, double y, double d) const { return corner(load, x, y, d, nu, smallest); }
    static Parity parity(Axis load, std::size_t component) { return parity_at(load, component); }
};

using StressField = PatchField<corner_stress, stress_parity>;                    ///< (N/mm^2)
using DisplacementField = PatchField<corner_displacement, displacement_parity>;  ///< times the shear modulus (N/mm)

template <class Field>
constexpr std::size_t components_of_field = std::tuple_size_v<typename Field::Components>;

}  // namespace contactd
