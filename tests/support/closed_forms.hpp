// Provides closed-form solutions for comparison: Hertz (Johnson, Contact Mechanics, section 4.2), Cattaneo (section
// 7.2), Mindlin and Deresiewicz (7.4), Carter (8.3), and Kalker's linear theory of rolling.
#pragma once

#include "contactd/gap.hpp"
#include "contactd/material.hpp"

namespace contactd::reference {

/// Describes a sphere on a plane (or two spheres of combined radius R) with a prescribed approach.
struct Hertz {
    double radius;  ///< of the contact circle, sqrt(R delta) (mm)
    double Fn;      ///< (N)
    double pmax;    ///< (N/mm^2)
};
Hertz hertz(const MaterialPair& bodies, double R, double approach);

/// Describes a Hertzian contact shifted by Fx < mu Fn without lateral effects.
struct Cattaneo {
    double adhesion_radius;  ///< (mm)
    double rigid_shift;      ///< (mm), positive, that produces Fx
};
Cattaneo cattaneo(const MaterialPair& bodies, const Hertz& hertz, double mu, double Fx);

/// Returns the rigid shift (mm, positive) at the force Fx after loading to `highest` and unloading to Fx >= -highest
/// (Mindlin and Deresiewicz 1953; Johnson, section 7.4). The unloading branch is the loading one, reversed and doubled,
/// and closes the loop at -highest. Reloading gives the same values with opposite signs.
double unloading_shift(const MaterialPair& bodies, const Hertz& hertz, double mu, double highest, double Fx);

/// Returns the moment of friction (N mm) about z of a circular Hertzian contact that spins so fast that all of it
/// slips: 3 pi/16 mu Fn radius.
double full_spin_moment(const Hertz& hertz, double mu);

/// Holds forces on the upper body of an elliptic contact rolling along +x, for creepages so small that nothing slips
/// (Kalker 1990, section 3.1). Positive creepage and spin give negative forces, and spin gives a force towards -y.
struct RollingForces {
    double Fx, Fy;  ///< (N)
    double Mz;      ///< (N mm)
};
RollingForces linear_rolling(const MaterialPair& bodies, const SemiAxes& axes, double xi, double eta, double phi);

/// Describes two cylinders of combined radius R, pressed together by `force` per length (Johnson, section 4.2(c)).
struct LineContact {
    double half_width;  ///< (mm)
    double pmax;        ///< (N/mm^2)
    double force;       ///< (N/mm)
};
LineContact line_contact(const MaterialPair& bodies, double R, double force);

/// Carter's solution (1926; Johnson, section 8.3): steady rolling of a line contact along +x, plane strain, bodies
/// quasi-identical. An area that touches the leading edge x = half_width adheres, and the rest slips.
struct Carter {
    double creepage;         ///< xi
    double force;            ///< on the upper body per length (N/mm), opposite to the creepage
    double adhesion_half;    ///< half the length of the adhesion area (mm), zero in full slip
    double adhesion_centre;  ///< x of its middle, half_width - adhesion_half (mm)
};
Carter carter_of_creepage(const MaterialPair& bodies, const LineContact& contact, double mu, double xi);
/// Requires |force| < mu contact.force.
Carter carter_of_force(const MaterialPair& bodies, const LineContact& contact, double mu, double force);
/// Returns the traction on the upper body at x (N/mm^2).
double carter_traction(const LineContact& contact, const Carter& carter, double mu, double x);

/// Returns the work (N mm) that friction dissipates in one cycle of the force between +highest and -highest at constant
/// normal force (Mindlin and Deresiewicz 1953; Johnson, section 7.4): the area of the loop of unloading_shift.
double dissipated_work(const MaterialPair& bodies, const Hertz& hertz, double mu, double highest);

}  // namespace contactd::reference
