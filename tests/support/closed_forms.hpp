// Closed-form solutions to compare with: Hertz (Johnson, Contact Mechanics, section 4.2), Cattaneo (section 7.2),
// Mindlin and Deresiewicz (7.4), Carter (8.3), and Kalker's linear theory of rolling.
#pragma once

#include "contactd/gap.hpp"
#include "contactd/material.hpp"

namespace contactd::reference {

/// Sphere on plane (or two spheres of combined radius R), approach prescribed.
struct Hertz {
    double radius;  ///< of the contact circle, sqrt(R delta) (mm)
    double Fn;      ///< (N)
    double pmax;    ///< (N/mm^2)
};
Hertz hertz(const MaterialPair& bodies, double R, double approach);

/// Hertz contact shifted by Fx < mu Fn without lateral effects.
struct Cattaneo {
    double adhesion_radius;  ///< (mm)
    double rigid_shift;      ///< (mm), positive, that goes with Fx
};
Cattaneo cattaneo(const MaterialPair& bodies, const Hertz& hertz, double mu, double Fx);

/// The rigid shift (mm, positive) at the force Fx after loading to `highest` and unloading to Fx >= -highest (Mindlin
/// and Deresiewicz 1953; Johnson, section 7.4): the branch back is the first one, turned round and doubled, which
/// closes the loop at -highest. Loading again gives the same with signs changed.
double unloading_shift(const MaterialPair& bodies, const Hertz& hertz, double mu, double highest, double Fx);

/// Moment of friction (N mm) about z of a circular Hertzian contact that spins so fast that all of it slips:
/// 3 pi/16 mu Fn radius.
double full_spin_moment(const Hertz& hertz, double mu);

/// Forces on the upper body of an elliptic contact rolling along +x, creepages so small that nothing slips (Kalker
/// 1990, section 3.1): positive creepage and spin give negative forces, spin pushes towards -y.
struct RollingForces {
    double Fx, Fy;  ///< (N)
    double Mz;      ///< (N mm)
};
RollingForces linear_rolling(const MaterialPair& bodies, const SemiAxes& axes, double xi, double eta, double phi);

/// Two cylinders of combined radius R, pressed together by `force` per length (Johnson, section 4.2(c)).
struct LineContact {
    double half_width;  ///< (mm)
    double pmax;        ///< (N/mm^2)
    double force;       ///< (N/mm)
};
LineContact line_contact(const MaterialPair& bodies, double R, double force);

/// Carter's solution (1926; Johnson, section 8.3): steady rolling of a line contact along +x, plane strain, bodies
/// quasi-identical. An area that touches the leading edge x = half_width adheres, the rest slips.
struct Carter {
    double creepage;         ///< xi
    double force;            ///< on the upper body per length (N/mm), opposite to the creepage
    double adhesion_half;    ///< half the length of the adhesion area (mm), zero in full slip
    double adhesion_centre;  ///< x of its middle, half_width - adhesion_half (mm)
};
Carter carter_of_creepage(const MaterialPair& bodies, const LineContact& contact, double mu, double xi);
/// |force| < mu contact.force.
Carter carter_of_force(const MaterialPair& bodies, const LineContact& contact, double mu, double force);
/// Traction on the upper body at x (N/mm^2).
double carter_traction(const LineContact& contact, const Carter& carter, double mu, double x);

/// Work (N mm) that friction dissipates in one cycle of the force between +highest and -highest, the normal force
/// constant (Mindlin and Deresiewicz 1953; Johnson, section 7.4): the area of the loop of unloading_shift.
double dissipated_work(const MaterialPair& bodies, const Hertz& hertz, double mu, double highest);

}  // namespace contactd::reference
