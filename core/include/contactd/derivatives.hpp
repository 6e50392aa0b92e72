// Defines the first derivatives of the answers of a contact problem with respect to its inputs.
#pragma once

#include <optional>

namespace contactd {

/// Holds derivatives with respect to the shift of the upper body along x and along y (1/mm).
struct DerivativesByShift {
    double x = 0, y = 0;

    bool operator==(const DerivativesByShift&) const = default;
};

/// Holds the derivatives of one answer with respect to each input, in units of the answer over those of the input.
/// Inputs that the problem or its model does not have are absent.
struct DerivativesOfAnswer {
    std::optional<double> xi{}, eta{}, phi{};         ///< of rolling
    std::optional<DerivativesByShift> rigid_shift{};  ///< of a shift
    std::optional<double> rotation{};                 ///< of a shift
    std::optional<double> approach{}, Fn{};           ///< the prescribed one of the two
    std::optional<double> mu{};                       ///< the same change of the coefficient in every element

    bool operator==(const DerivativesOfAnswer&) const = default;
};

/// The derivatives hold the following constant: the undeformed distance, even if it follows from semi-axes and the
/// load; the tractions at the end of the previous step; additional rigid slip; and the division into contact, adhesion
/// and slip. Motion is an input even if forces are prescribed: the derivatives are then those for a prescribed motion
/// equal to the computed one. They are one-sided where the division of the elements is about to change.
struct Derivatives {
    std::optional<DerivativesOfAnswer> Fx{}, Fy{}, Mz{};  ///< (N, N mm); with friction only
    std::optional<DerivativesOfAnswer> Fn{}, approach{};  ///< (N, mm); the computed one of the two

    bool operator==(const Derivatives&) const = default;
};

}  // namespace contactd
