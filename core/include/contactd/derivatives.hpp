// How the answers of a contact problem follow its inputs, to first order.
#pragma once

#include <optional>

namespace contactd {

/// By the shift of the upper body along x and along y (1/mm).
struct DerivativesByShift {
    double x = 0, y = 0;

    bool operator==(const DerivativesByShift&) const = default;
};

/// Derivatives of one answer, by each input: units are those of the answer over those of the input. Inputs that the
/// problem does not have, or its model does not know, are absent.
struct DerivativesOfAnswer {
    std::optional<double> xi{}, eta{}, phi{};         ///< of rolling
    std::optional<DerivativesByShift> rigid_shift{};  ///< of a shift, and
    std::optional<double> rotation{};                 ///< of its rotation
    std::optional<double> approach{}, Fn{};           ///< by the one that is prescribed
    std::optional<double> mu{};                       ///< the same change of the coefficient in every element

    bool operator==(const DerivativesOfAnswer&) const = default;
};

/// Held are the undeformed distance, also where semi-axes and the load made it, the tractions at the end of the step
/// before, rigid slip beside that of the motion, and which elements are in contact, adhere and slip. Motion is an input
/// also where forces found it: the derivatives are those with the motion known, at the motion found. Where the division
/// of the elements is about to change they are one-sided.
struct Derivatives {
    std::optional<DerivativesOfAnswer> Fx{}, Fy{}, Mz{};  ///< (N, N mm); with friction only
    std::optional<DerivativesOfAnswer> Fn{}, approach{};  ///< (N, mm), of the one that is found

    bool operator==(const Derivatives&) const = default;
};

}  // namespace contactd
