// The equations of a solved contact to first order, its element division frozen.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <vector>

#include "contact/newton/compliance.hpp"
#include "contact/rolling/friction_bodies.hpp"
#include "contact/support/contact_elements.hpp"
#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"
#include "operators/restriction.hpp"

namespace contactd {

// Unknowns are changes of the pressures, dp, and of what is free of the tractions, dq: both components in adhesion,
// across the slip where there is slip. There the traction is g n with g = mu p, and changes by dq + n dg. The equations
//
//     A_zz dp + A_zt (dq + n dg) = d(delta)                          in contact
//     P (K (dq + n dg) + K_tz dp + dw) + D dq = 0,   D = |s|/g       in adhesion and slip
//
// with P, which projects on what is free, and K, A or C, as Newton's method on the friction law has them. Vectors hold
// dp of each element in contact, or what is free of dq: of each element along x where it adheres, across its traction
// where it slips, and then along y of those that adhere. All of them hold dp first. On the right: what equations leave.
class FrozenContact {
   public:
    using Vector = Eigen::VectorXd;
    using Values = std::vector<double>;

    // Takes a solution as solvers leave it: slip is in mm. Problem and operators outlive it.
    FrozenContact(const ContactProblem& problem, const ContactInfluence& influence, const ContactSolution& solution);

    // Whether pressures follow tractions; otherwise the tangential part of the equations stands alone.
    bool coupled() const { return coupled_; }
    // Whether that part is its own transpose.
    bool symmetric() const { return increment_ == nullptr; }
    // Over the elements in contact.
    double mean_friction() const;
    // Returns the part of the elements with a bound that slips.
    double slip_part() const { return 1 - static_cast<double>(adhering_.size()) / static_cast<double>(rubbed_.size()); }
    // About the size of the contact (mm).
    double length() const { return std::sqrt(grid_.element_area() * static_cast<double>(pressed_.size())); }
    Eigen::Index pressures() const { return static_cast<Eigen::Index>(pressed_.size()); }
    Eigen::Index tractions() const { return weights_.size(); }

    void normal(const Vector& dp, Vector& result);
    void precondition_normal(const Vector& r, Vector& z);
    void tangential(const Vector& dq, Vector& result);
    void precondition_tangential(const Vector& r, Vector& z, int step);
    // Both, as they depend on each other.
    void all(const Vector& both, Vector& result);
    void precondition_all(const Vector& r, Vector& z, int step);

    // How residuals of the tangential equations are measured, and those of both.
    const Vector& weights() const { return weights_; }
    Vector weights_of_all() const;
    // Columns: what makes the forces Fn, Fx, Fy and Mz of dp and dq, the bounds following the pressures.
    Eigen::MatrixXd forces_of_all();
    // Its columns make the forces Fx, Fy and Mz of dq alone.
    Eigen::MatrixXd forces_of_tractions();

    // The right-hand side, and its weighted length before all that is not free of it was projected out, without which
    // rounding alone may be left.
    struct Right {
        Vector values;
        double size;
    };
    // For one unit of rigid slip along x (0), along y (1) or about the origin (2).
    Right of_slip(int direction);
    // For one unit of that in a step, which particles that enter during it make a part of.
    Right of_motion(int direction);
    // For bounds that change by dg while pressures stay, of the tangential equations and of the others.
    Right of_bound(const Vector& dg);
    Vector pressures_of_bound(const Vector& dg);
    // dg of each element in contact for one unit of friction, and for a change of the pressures.
    Vector bound_of_friction() const;
    Vector bound_of_pressure(const Vector& dp) const;

    // Changes of Fx, Fy and Mz.
    using Forces = Eigen::Vector3d;
    Forces forces_of_bound(const Vector& dg);
    double element_area() const { return grid_.element_area(); }

   private:
    Values crop(std::span<const double> whole) const;
    void take_law(const ContactSolution& solution);
    void take_rigid_slip(int direction);
    void take_weights();
    void take_pressures(const Vector& dp);
    void take_bounds(const Vector& dg);
    void take_free(const Eigen::Ref<const Vector>& dq);
    void add_free();
    Vector free_of(const Field& field) const;
    void find_slip();
    void give_normal(double* result) const;
    Vector tangential_residual();
    Right right_of_slip() const;

    const Restriction restriction_;
    const std::shared_ptr<const StepOperator> part_increment_;
    const bool is_whole_;
    const InfluenceOperator& influence_;
    const StepOperator* increment_;
    const Grid grid_;
    const bool coupled_;
    const Values pressure_, mu_;
    const Values entering_;           // EnteringParticles::part; empty: none enters
    Field radial_;                    // n
    const Contact pressed_, rubbed_;  // elements with a pressure; those of them with a bound
    std::unique_ptr<Compliance> compliance_;
    Linearisation law_;
    Field along_;                        // what is free: e_x in adhesion, across the traction in slip
    std::vector<std::size_t> adhering_;  // where e_y is free, too; of rubbed_
    Vector weights_;                     // of the tangential equations
    // On the box: dp, what it makes of the gap, dq + n dg, and its slip. On elements with a bound: dq, and its slip.
    Values p_, u_;
    Field q_, s_, coupling_;
    Field in_, out_;
};

}  // namespace contactd
