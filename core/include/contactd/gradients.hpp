// Defines gradients of the answers of a solved contact with respect to its inputs, computed backwards.
#pragma once

#include <optional>
#include <vector>

#include "contactd/derivatives.hpp"
#include "contactd/friction.hpp"

namespace contactd {

/// Holds the derivatives of one output J with respect to the answers of a contact problem, each 0 or empty if J does
/// not depend on that answer. An answer {Fx: 1} makes J the force Fx. Arrays have shape [ny, nx].
struct Cotangents {
    double Fn = 0, Fx = 0, Fy = 0, Mz = 0;  ///< of the forces (1/N, 1/(N mm), times the unit of J)
    double approach = 0;                    ///< of the computed approach; requires Fn (1/mm)
    double xi = 0, eta = 0;                 ///< of creepages that prescribed forces determine
    DerivativesByShift rigid_shift{};       ///< of shifts that prescribed forces determine (1/mm)
    double frictional_work = 0;             ///< of a shift (1/(N mm))
    double frictional_power = 0;            ///< of rolling (s/(N mm))
    /// Of the work (shift) or power (rolling) that friction dissipates in each row of elements, shape [ny]; with the
    /// derivatives of a wear law, the wear of a profile.
    std::vector<double> loss_of_rows;
    double pmax = 0;  ///< of the largest pressure (mm^2/N), at the first element that has it
    /// Of the norm (sum p^order dx dy)^(1/order) of the pressures, a smooth substitute for pmax.
    double pressure_norm = 0;
    double norm_order = 8;  ///< >= 1
    std::vector<double> pressure, traction_x, traction_y;
    std::vector<double> slip_x, slip_y;  ///< of the slip of the answer: a distance in a shift, relative in rolling

    bool operator==(const Cotangents&) const = default;
};

/// Names the inputs with many values, or at additional cost. Load and motion are always included.
enum class GradientInput { gap, mu, rigid_slip, previous, materials };

/// Holds derivatives with respect to the shear modulus (mm^2/N times the unit of J) and Poisson's ratio of a body.
struct GradientByMaterial {
    double G = 0, nu = 0;

    bool operator==(const GradientByMaterial&) const = default;
};

/// Holds derivatives with respect to the state at the end of the previous step, each of shape [ny, nx].
struct GradientByPrevious {
    std::vector<double> pressure, traction_x, traction_y;

    bool operator==(const GradientByPrevious&) const = default;
};

/// Holds the gradient of one output, in units of J over those of the input. Inputs that the problem does not have, or
/// that were not requested, are absent. The division into contact, adhesion and slip is held constant. Prescribed
/// forces are held, and the motion that they determine follows; without prescribed forces the motion is held.
struct Gradient {
    std::optional<double> approach{}, Fn{};           ///< the prescribed one of the two
    std::optional<double> xi{}, eta{}, phi{};         ///< of rolling, if prescribed
    std::optional<DerivativesByShift> rigid_shift{};  ///< of a shift; 0 for a component that a force determines
    std::optional<double> rotation{};                 ///< of a shift
    std::optional<double> Fx{}, Fy{};                 ///< if prescribed
    std::vector<double> gap;                          ///< of the undeformed distance h of each element, [ny, nx]
    std::vector<double> mu;                           ///< of the coefficient of friction of each element, [ny, nx]
    RigidSlip rigid_slip{};                           ///< of ContactLoad::rigid_slip, [ny, nx]
    std::optional<GradientByMaterial> upper{}, lower{};
    std::optional<GradientByPrevious> previous{};  ///< pressures are 0 for bodies alike

    bool operator==(const Gradient&) const = default;
};

}  // namespace contactd
