// Defines the set-up of a contact, which all steps of a simulation share.
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

/// Holds the stopping criterion and the iteration limit of an iterative solver.
struct SolverSettings {
    double tolerance = 1e-6;  ///< in the paper's stopping criteria (sections 4.1 and 4.2)
    int max_iterations = 1000;

    bool operator==(const SolverSettings&) const = default;
};

/// Selects the solver of the tractions under friction: Newton's method on the friction law or, for shifts and transient
/// rolling, TangCG, bound-constrained conjugate gradients (Zhao, Vollebregt, Oosterlee 2014; paper section 4.2).
enum class TangentialSolver { newton, tangcg };

/// Holds the settings of the solvers of a contact problem.
struct ContactSettings {
    SolverSettings normal{1e-8, 1000};  ///< ||d||_rms / ||h||_rms; all results depend on the pressures
    SolverSettings tangential;          ///< ||p_t - p_t,old|| / ||p_t||, and the estimated error
    SolverSettings outer{1e-6, 100};    ///< settings of the loop for dissimilar bodies, slip laws and forces
    /// If Newton's method fails, TangCG is tried afterwards, but not vice versa.
    TangentialSolver tangential_solver = TangentialSolver::newton;

    bool operator==(const ContactSettings&) const = default;
};

/// full uses boundary elements (NORM, TangCG, steady rolling). hertz uses closed forms for elliptic contact. The others
/// are models of vehicle codes for steady rolling: fastsim is Kalker's simplified theory, fastrip is strip theory with
/// FASTSIM in the slip area, and polach computes forces only. All models except full require a paraboloid or semi-axes,
/// unless a NormalModel computes the pressures.
enum class Model { full, hertz, fastsim, fastrip, polach };

/// of_model computes pressures by boundary elements or Hertz, according to the model. kp (Piotrowski and Kik 2008),
/// kpec (Piotrowski, Liu and Bruni 2017) and analyn (Sichani, Enblom and Berg 2014) use the overlap of the undeformed
/// surfaces. elliptic and parabolic prescribe the pressures: Hertz's in the ellipse of the gap, and a paraboloid over
/// the same ellipse under the same force.
enum class NormalModel { of_model, kp, kpec, analyn, elliptic, parabolic };

/// Describes the reduction of the initial slope (Spiryagin, Polach, Cole 2013). Flexibilities are divided by k = k0
/// (alpha + (1 - alpha)/(1 + beta eps)), with eps = G pi a b k0 C11 w/(4 mu Fn) and w the size of the creepage
/// including spin.
struct SlopeReduction {
    double k0 = 1, alpha = 1, beta = 0;

    bool operator==(const SlopeReduction&) const = default;
};

/// Selects FASTSIM's bound in an ellipse: mu 2 Fn/(pi a b) (1 - x^2/a^2 - y^2/b^2), or mu times Hertz's pressure.
enum class TractionBound { parabolic, elliptic };

/// Selects Kalker's coefficients: computed, or interpolated in the table of his book (1990, table E.3).
enum class CreepageCoefficients { computed, printed };

/// Holds options of the models fastsim, fastrip and polach. A model refuses options that it does not use.
struct SimplifiedSettings {
    SlopeReduction slope;
    TractionBound bound = TractionBound::parabolic;
    /// Uses whole steps of the grid's elements in FASTSIM, with sums over elements as forces. Options that require
    /// this select it automatically.
    bool on_elements = false;
    bool blended = false;  ///< whether the three flexibilities merge as slip increases
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
    /// The flexibility describes a thin sheet between the bodies, for model full (mm^3/N). Its product with the
    /// pressure is added to the normal displacement of the same element.
    double sheet_flexibility = 0;
    /// Thermal properties of both bodies request surface temperatures. They require steady rolling along x.
    std::optional<ThermalBodies> temperature{};
    std::optional<WearRequest> wear{};        ///< requests wear; steady rolling along x only
    std::optional<FatigueRequest> fatigue{};  ///< requests fatigue; steady rolling along x only
    std::optional<FrictionLaw> friction;      ///< absent: frictionless
    ContactSettings settings;
    std::optional<ContactColumns> columns{};  ///< shape of a surface curved along y; absent: a plane
    std::optional<ContactRegions> regions{};  ///< regions of contact, for model full; absent: everywhere
    /// Requests tangential forces of steady rolling that are extrapolated to elements of zero size, with this error: of
    /// Fx and Fy over mu Fn, and of Mz over mu Fn sqrt(ab).
    std::optional<double> accuracy{};
};

/// Throws InvalidArgument ("simplified.*", "normal_model") if options do not fit the model.
void validate_models(const ContactSetup& setup);

/// These are the bounds of ContactSetup::accuracy. The finest grids reach the finer one for most contacts.
inline constexpr double finest_force_accuracy = 3e-4, coarsest_force_accuracy = 0.1;

/// Returns whether the bodies are those of a line contact, for models full and hertz.
bool is_line_contact(const ContactSetup& setup);

}  // namespace contactd
