// The set-up of a contact, which all steps of a simulation have in common.
#pragma once

#include <optional>

#include "contactd/body.hpp"
#include "contactd/contact_columns.hpp"
#include "contactd/contact_regions.hpp"
#include "contactd/fatigue.hpp"
#include "contactd/friction.hpp"
#include "contactd/grid.hpp"
#include "contactd/temperature.hpp"
#include "contactd/wear.hpp"

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

/// full: boundary elements (NORM, TangCG, steady rolling). hertz: closed forms for elliptic contact. Those of vehicle
/// codes, for steady rolling: fastsim, Kalker's simplified theory; fastrip, strip theory with FASTSIM where it slips;
/// polach, forces only. All but full need a paraboloid or semi-axes, unless pressures are those of a NormalModel.
enum class Model { full, hertz, fastsim, fastrip, polach };

/// of_model: pressures by boundary elements or Hertz, as the model says. The others find them from the overlap of the
/// undeformed surfaces: kp (Piotrowski and Kik 2008), kpec (Piotrowski, Liu and Bruni 2017), analyn (Sichani, Enblom
/// and Berg 2014); or prescribe them: elliptic, Hertz's in the ellipse of the gap, and parabolic, a paraboloid over the
/// same ellipse under the same force.
enum class NormalModel { of_model, kp, kpec, analyn, elliptic, parabolic };

/// Reduction of the initial slope (Spiryagin, Polach, Cole 2013): flexibilities over k = k0 (alpha + (1 - alpha)/
/// (1 + beta eps)), eps = G pi a b k0 C11 w/(4 mu Fn), w the size of the creepage with the share of spin.
struct SlopeReduction {
    double k0 = 1, alpha = 1, beta = 0;

    bool operator==(const SlopeReduction&) const = default;
};

/// FASTSIM's bound in an ellipse is mu 2 Fn/(pi a b) (1 - x^2/a^2 - y^2/b^2), or mu times Hertz's pressure.
enum class TractionBound { parabolic, elliptic };

/// Kalker's coefficients as computed here, or as printed in his book (1990, table E.3), between its lines.
enum class CreepageCoefficients { computed, printed };

/// Options of the models fastsim, fastrip and polach; each refuses those that are not its own.
struct SimplifiedSettings {
    SlopeReduction slope;
    TractionBound bound = TractionBound::parabolic;
    /// FASTSIM in whole steps of the grid's elements, its forces sums over them. What needs that takes it by itself.
    bool on_elements = false;
    bool blended = false;  ///< whether the three flexibilities become one as slip grows
    CreepageCoefficients coefficients = CreepageCoefficients::computed;
    double k_adhesion = 1, k_slip = 1;  ///< Polach's reductions, 0 < k_slip <= k_adhesion <= 1

    bool operator==(const SimplifiedSettings&) const = default;
};

struct ContactSetup {
    Grid grid;
    Bodies bodies;
    Model model = Model::full;
    NormalModel normal_model = NormalModel::of_model;
    SimplifiedSettings simplified{};
    /// Of a thin sheet between the bodies, of model full only: each pressure times this adds to the normal displacement
    /// of its element (mm^3/N).
    double sheet_flexibility = 0;
    /// What both bodies have to do with heat, where temperatures of the surfaces are wanted: of steady rolling along x.
    std::optional<ThermalBodies> temperature{};
    std::optional<WearRequest> wear{};        ///< where wear is wanted: of steady rolling along x
    std::optional<FatigueRequest> fatigue{};  ///< where fatigue is wanted, likewise
    std::optional<FrictionLaw> friction;      ///< absent: frictionless
    ContactSettings settings;
    std::optional<ContactColumns> columns{};  ///< where the surface is curved along y; absent: a plane
    std::optional<ContactRegions> regions{};  ///< where bodies may touch, of model full; absent: everywhere
};

/// Throws InvalidArgument ("simplified.*", "normal_model") for options that do not go with the model.
void validate_models(const ContactSetup& setup);

/// Whether its bodies are those of a line contact; of models full and hertz.
bool is_line_contact(const ContactSetup& setup);

}  // namespace contactd
