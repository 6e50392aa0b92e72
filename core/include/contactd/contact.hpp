// Contact problems and their solutions as plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "contactd/given_ics.hpp"
#include "contactd/grid.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/material.hpp"

namespace contactd {

enum class ElementState : std::uint8_t { exterior = 0, adhesion = 1, slip = 2 };

/// Stop test and bound of one iterative solver.
struct SolverSettings {
    double tolerance = 1e-6;  ///< of the paper's stop tests (sections 4.1 and 4.2)
    int max_iterations = 1000;

    bool operator==(const SolverSettings&) const = default;
};

/// How a solver ended.
struct SolverEvidence {
    int iterations = 0;
    double residual = 0;  ///< the figure compared with the tolerance
    bool converged = false;
    double seconds = 0;
};

/// The tangential part: a shift problem with Coulomb friction, the rigid shift prescribed.
struct Friction {
    double mu = 0;             ///< coefficient of friction, >= 0
    double rigid_shift_x = 0;  ///< w_x (mm); slip = A p + w
    double rigid_shift_y = 0;  ///< w_y (mm)

    bool operator==(const Friction&) const = default;
};

/// Normal contact with the approach prescribed, and tangential contact where `friction` is given.
struct ContactProblem {
    Grid grid;
    BodyPair bodies;
    Ics ics;                                  ///< of both bodies
    std::optional<GivenIcs> given_ics;        ///< instead of computed ones; bodies and ics mean nothing then
    std::vector<double> undeformed_distance;  ///< h without the approach, shape [ny, nx] (mm)
    double approach = 0;                      ///< delta (mm); the gap before deformation is h - delta
    std::optional<Friction> friction;         ///< absent: frictionless
    SolverSettings normal_settings;           ///< ||d||_rms / ||h||_rms
    SolverSettings tangential_settings;       ///< ||p_t - p_t,old|| / ||p_t||
    std::vector<double> initial_pressure;     ///< empty, or an estimate, shape [ny, nx]
    std::vector<double> initial_traction_x, initial_traction_y;  ///< empty, or estimates
};

/// Arrays have shape [ny, nx]. Tractions act on the upper body.
struct ContactSolution {
    double Fn = 0;            ///< normal force (N), > 0 in compression
    double Fx = 0, Fy = 0;    ///< tangential force on the upper body (N)
    double pmax = 0;          ///< largest pressure (N/mm^2)
    double contact_area = 0;  ///< (mm^2)
    double adhesion_area = 0, slip_area = 0;
    int contact_elements = 0, adhesion_elements = 0, slip_elements = 0;
    std::vector<ElementState> element_division;
    std::vector<double> pressure;                ///< (N/mm^2), >= 0
    std::vector<double> traction_x, traction_y;  ///< (N/mm^2); zero without friction
    SolverEvidence normal;
    std::optional<SolverEvidence> tangential;

    /// True when every solver that ran reached its tolerance.
    bool converged() const { return normal.converged && (!tangential || tangential->converged); }
};

/// h(x, y) = x^2/(2 Rx) + y^2/(2 Ry) at the element centres (mm); an infinite radius is a flat direction.
std::vector<double> paraboloid(const Grid& grid, double Rx, double Ry);

/// Throws InvalidArgument naming the field as on the wire when the problem cannot be solved as stated.
void validate(const ContactProblem& problem);

}  // namespace contactd
