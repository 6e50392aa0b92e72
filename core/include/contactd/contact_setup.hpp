// The set-up of a contact, which all steps of a simulation have in common.
#pragma once

#include <optional>

#include "contactd/body.hpp"
#include "contactd/contact_columns.hpp"
#include "contactd/friction.hpp"
#include "contactd/grid.hpp"

namespace contactd {

/// Stopping criterion and bound of one iterative solver.
struct SolverSettings {
    double tolerance = 1e-6;  ///< of the paper's stopping criteria (sections 4.1 and 4.2)
    int max_iterations = 1000;

    bool operator==(const SolverSettings&) const = default;
};

/// How tractions are found under friction: by Newton's method on the friction law, or of shifts and transient rolling
/// by TangCG, bound-constrained conjugate gradients (Zhao, Vollebregt, Oosterlee 2014; paper section 4.2).
enum class TangentialSolver { newton, tangcg };

/// Those of the solvers of a contact problem.
struct ContactSettings {
    SolverSettings normal{1e-8, 1000};  ///< ||d||_rms / ||h||_rms; all else builds on the pressures
    SolverSettings tangential;          ///< ||p_t - p_t,old|| / ||p_t||, and the estimated error
    SolverSettings outer{1e-6, 100};    ///< of the loop that dissimilar bodies, slip laws and forces need
    /// Where Newton's method does not get there, TangCG is tried after it; never the other way round.
    TangentialSolver tangential_solver = TangentialSolver::newton;

    bool operator==(const ContactSettings&) const = default;
};

/// full: boundary elements (NORM, TangCG, steady rolling). hertz: closed forms for elliptic contact. fastsim: Hertzian
/// contact with Kalker's simplified theory of rolling. The simplified ones need a paraboloid or semi-axes.
enum class Model { full, hertz, fastsim };

struct ContactSetup {
    Grid grid;
    Bodies bodies;
    Model model = Model::full;
    /// Of a thin sheet between the bodies, of model full only: each pressure times this adds to the normal displacement
    /// of its element (mm^3/N).
    double sheet_flexibility = 0;
    std::optional<FrictionLaw> friction;  ///< absent: frictionless
    ContactSettings settings;
    std::optional<ContactColumns> columns{};  ///< where the surface is curved along y; absent: a plane
};

/// Whether its bodies are those of a line contact; of models full and hertz.
bool is_line_contact(const ContactSetup& setup);

}  // namespace contactd
