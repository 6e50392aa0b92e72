// Linearises the equations of a solved contact, with a frozen element division.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <vector>

#include "contact/newton/compliance.hpp"
#include "contact/rolling/friction_bodies.hpp"
#include "contact/rolling/transposed_step.hpp"
#include "contact/support/contact_elements.hpp"
#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"
#include "operators/restriction.hpp"

namespace contactd {

// The unknowns are changes of the pressures, dp, and of the free components of the tractions, dq: both components in
// adhesion, the component across the slip in slip. In slip, the traction is g n with g = mu p, and changes by dq + n
// dg. The equations
//
//     A_zz dp + A_zt (dq + n dg) = d(delta)                          in contact
//     P (K (dq + n dg) + K_tz dp + dw) + D dq = 0,   D = |s|/g       in adhesion and slip
//
// use the projection P on the free components, and K, A or C, as in Newton's method on the friction law. Vectors
// contain dp of each element in contact, or the free components of dq: first the one along x for each element that
// adheres, or across its traction for each that slips, and then the one along y for those that adhere. Vectors of all
// unknowns contain dp first. The right-hand side is the residual of the equations.
//
// The transposed equations have the same form, with K^T of rolling backwards, and the same preconditioner. Their
// unknowns are l of each pressure and f, with y = B f for the free directions B:
//
//     A_zz l + K_tz^T y + mu n (A_zt^T l + K^T y) = right of the pressures
//     P (A_zt^T l + K^T y) + D f = right of the tractions
class FrozenContact {
   public:
    using Vector = Eigen::VectorXd;
    using Values = std::vector<double>;
    enum class Equations { original, transposed };

    // Uses a solution of the solvers, with slip in mm. Problem and operators must outlive this object.
    FrozenContact(const ContactProblem& problem, const ContactInfluence& influence, const ContactSolution& solution,
                  Equations equations = Equations::original);

    // Returns whether pressures depend on tractions. Otherwise the tangential part of the equations is separate.
    bool coupled() const { return coupled_; }
    // Returns whether the tangential part is symmetric.
    bool symmetric() const { return increment_ == nullptr; }
    // Returns the mean coefficient over the elements in contact.
    double mean_friction() const;
    // Returns the fraction of the elements with a bound that slips.
    double slip_part() const { return 1 - static_cast<double>(adhering_.size()) / static_cast<double>(rubbed_.size()); }
    // Returns the approximate size of the contact (mm).
    double length() const { return std::sqrt(grid_.element_area() * static_cast<double>(pressed_.size())); }
    Eigen::Index pressures() const { return static_cast<Eigen::Index>(pressed_.size()); }
    Eigen::Index tractions() const { return weights_.size(); }

    void normal(const Vector& dp, Vector& result);
    void precondition_normal(const Vector& r, Vector& z);
    void tangential(const Vector& dq, Vector& result);
    void precondition_tangential(const Vector& r, Vector& z, int step);
    // Applies both parts with their coupling.
    void all(const Vector& both, Vector& result);
    void precondition_all(const Vector& r, Vector& z, int step);

    // Return the weights that measure residuals of the tangential equations, and of all equations.
    const Vector& weights() const { return weights_; }
    Vector weights_of_all() const;
    // Returns columns that compute the forces Fn, Fx, Fy and Mz from dp and dq, with bounds that follow the pressures.
    Eigen::MatrixXd forces_of_all();
    // Returns columns that compute the forces Fx, Fy and Mz from dq alone.
    Eigen::MatrixXd forces_of_tractions();

    // Holds the right-hand side, and its weighted length before the projection on the free components, after which only
    // rounding errors may be left.
    struct Right {
        Vector values;
        double size;
    };
    // Returns the right-hand side for a unit of rigid slip along x (0), along y (1) or about the origin (2).
    Right of_slip(int direction);
    // Returns the right-hand side for a unit of rigid slip in a step. Particles that enter during the step slip only
    // for part of it.
    Right of_motion(int direction);
    // Return the right-hand sides of the tangential and the other equations for bounds that change by dg at constant
    // pressures.
    Right of_bound(const Vector& dg);
    Vector pressures_of_bound(const Vector& dg);
    // Return dg of each element in contact for a unit of friction, and for a change of the pressures.
    Vector bound_of_friction() const;
    Vector bound_of_pressure(const Vector& dp) const;

    // Holds changes of Fx, Fy and Mz.
    using Forces = Eigen::Vector3d;
    Forces forces_of_bound(const Vector& dg);
    double element_area() const { return grid_.element_area(); }

    // Returns dp on the elements of the problem's grid, 0 outside the contact.
    Values on_grid(const Vector& dp, std::size_t size);

    // The following are for the transposed equations. Their arrays have one value per element of a box around the
    // contact, into which crop() and paste() convert.
    Values crop(std::span<const double> whole) const;
    Values paste(const Values& box, std::size_t size) const;
    const Grid& grid() const { return grid_; }
    const Contact& pressed() const { return pressed_; }
    const Values& mu() const { return mu_; }            // of each element of the box
    const Field& direction() const { return radial_; }  // n
    // Returns the right-hand side B^T q, with its weighted length before the product.
    Right of_tractions(const Field& q);
    // Returns y = B f.
    Field tractions_of(const Eigen::Ref<const Vector>& f);
    // Return K^T y and, of coupled bodies, K_tz^T y.
    Field transposed_slip(const Field& y);
    Values transposed_coupling(const Field& y);
    // Returns A_zt^T l of coupled bodies.
    Field slip_of_normal(const Values& l) const;
    // Returns the largest relative difference of <K q, y> and <q, K^T y>, and of the same products of the coupling.
    double reciprocity_error(const Field& q, const Field& y, const Values& p);

   private:
    void all_transposed(const Vector& both, Vector& result);
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
    const bool coupled_, is_transposed_;
    // For the transposed equations of steady rolling; null otherwise.
    const std::unique_ptr<TransposedStep> transposed_;
    const Values pressure_, mu_;
    const Values entering_;           // EnteringParticles::part; empty if none enters
    Field radial_;                    // n
    const Contact pressed_, rubbed_;  // elements with a pressure, and those of them with a bound
    std::unique_ptr<Compliance> compliance_;
    Linearisation law_;
    Field along_;                        // free direction: e_x in adhesion, across the traction in slip
    std::vector<std::size_t> adhering_;  // elements of rubbed_ where e_y is free, too
    Vector weights_;                     // of the tangential equations
    // On the box, these are dp and its effect on the gap, and dq + n dg and its slip; on elements with a bound, they
    // are dq and its slip.
    Values p_, u_;
    Field q_, s_, coupling_;
    Field in_, out_;
};

}  // namespace contactd
