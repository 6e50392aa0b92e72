// Defines Hertzian contact for the simplified models, and their common results. The models are cattaneo_mindlin.hpp
// (shift), vermeulen_johnson.hpp (rolling without spin) and fastsim.hpp (rolling).
#pragma once

#include <optional>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Returns the material that represents both bodies in tangential contact: 1/G = (1/G1 + 1/G2)/2, nu/G = (nu1/G1 +
/// nu2/G2)/2 (Kalker 1990, section 1.7). One body may be rigid. All simplified models neglect the coupling of normal
/// and tangential contact of bodies that are not quasi-identical.
Material combined_material(const MaterialPair& bodies);

/// Describes an elliptic contact area centred at the origin, its axes along x and y, with Hertz's pressure p0 sqrt(1 -
/// x^2/a^2 - y^2/b^2) (Johnson, section 4.2). If b is infinite, it is the strip of a line contact.
struct EllipticContact {
    SemiAxes axes;      ///< (mm); zeros without contact
    double Fn = 0;      ///< (N), zero without contact
    Material combined;  ///< of combined_material
    double length = 0;  ///< length of a strip to which forces and areas refer (mm)
    double datum = 0;   ///< datum of LineContactSpec, for a strip (mm)

    bool empty() const { return !(Fn > 0 && axes.a > 0 && axes.b > 0); }
    bool is_strip() const { return length > 0; }
    /// Returns the power n of the size with which a force like Hertz's pressure grows. Over a similar area, k times as
    /// large, the force is k^n times as large, and the area k^(n-1) times.
    int force_power() const { return is_strip() ? 2 : 3; }
    double area() const;  ///< pi a b, or 2 a length (mm^2)
    double pmax() const;  ///< p0 = 3 Fn/(2 area), or 4 Fn/(pi area) (N/mm^2)
};

/// Returns Hertz's pressure at the element centres, shape [ny, nx] (N/mm^2), zero outside the ellipse. A semi-axis may
/// be infinite, for the strip of a line contact.
std::vector<double> hertz_pressure(const Grid& grid, const SemiAxes& axes, double pmax);
std::vector<double> hertz_pressure(const Grid& grid, const EllipticContact& contact);

/// Holds tangential contact by a simplified model. Forces, areas and power belong to the whole ellipse and come from
/// integrals over it. Arrays, of shape [ny, nx], are samples at the element centres, which are exterior outside the
/// ellipse.
struct EllipticFriction {
    double Fx = 0, Fy = 0;                       ///< on the upper body (N)
    double Mz = 0;                               ///< about the origin (N mm)
    double adhesion_area = 0, slip_area = 0;     ///< (mm^2)
    std::vector<double> traction_x, traction_y;  ///< on the upper body (N/mm^2)
    std::vector<ElementState> element_division;
    /// Hold the relative slip of the upper body over the lower (slip velocity over rolling velocity). They are empty if
    /// the theory does not determine it.
    std::vector<double> slip_x, slip_y;
    std::vector<double> friction_coefficient;  ///< for kinetic friction, the static one outside the contact; otherwise
                                               ///< empty
    std::optional<double> frictional_power;    ///< of rolling (N mm/s)
    Motion motion;                             ///< the given motion, with components computed for prescribed forces
    std::optional<SolverEvidence> force;       ///< evidence of the search for the motion: |F - prescribed|/(mu Fn)
};

}  // namespace contactd
