// Defines requests and answers of rolling contact fatigue of a body in steady rolling as plain values.
//
// In steady rolling, the history of a particle consists of the stresses along a line parallel to x, one line per row
// and depth. Residual stresses in equilibrium do not depend on x and do not change xz. So |xz| <= k is necessary for
// shakedown (Johnson, Contact Mechanics, section 9.2), for any residual stresses. docs/damage.md discusses the
// uncertainties.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contactd/wear.hpp"

namespace contactd {

/// Describes the strength of a steel. There are no defaults.
struct FatigueStrength {
    std::string name, source;       ///< neither is empty
    double shear_yield = 0;         ///< k, in cyclic shear (N/mm^2), > 0
    std::optional<double> a_DV{};   ///< Dang Van's coefficient of the hydrostatic stress, >= 0
    std::optional<double> tau_e{};  ///< endurance limit in alternating shear (N/mm^2), > 0

    bool operator==(const FatigueStrength&) const = default;
};

/// Describes the damage of a passage as a function of T gamma without spin (N). Negative damage means that wear removes
/// cracks (Burstow 2004).
struct DamageFunction {
    std::string name, source;         ///< neither is empty; each function has its own name
    WearRange range{};                ///< of T gamma
    std::vector<WearPiece> pieces{};  ///< ascending; the first one starts at 0

    bool operator==(const DamageFunction&) const = default;
};

/// Describes residual stresses at a depth (mm), tension positive (N/mm^2). Equilibrium excludes those along z.
struct ResidualStress {
    double depth = 0, xx = 0, yy = 0;

    bool operator==(const ResidualStress&) const = default;
};

/// Describes the stresses below the rows of a contact while it passes over them.
struct Passage {
    std::vector<double> depths{};  ///< (mm), ascending; if empty: 0 and 20 more, up to twice the smaller half-length
    std::vector<ResidualStress> residual{};  ///< by ascending depth; linear between depths, constant beyond them

    bool operator==(const Passage&) const = default;
};

struct FatigueRequest {
    WornBody body = WornBody::upper;
    std::optional<FatigueStrength> strength{};
    std::vector<DamageFunction> damages{};
    std::optional<Passage> passage{};

    bool operator==(const FatigueRequest&) const = default;
};

/// Holds the largest value of a stress (N/mm^2) and its position: the middle of its row and the depth below (mm).
struct StressPlace {
    double value = 0, y = 0, z = 0, depth = 0;

    bool operator==(const StressPlace&) const = default;
};

struct FunctionDamage {
    std::string name;
    double value = 0;  ///< damage of one passage

    bool operator==(const FunctionDamage&) const = default;
};

/// Describes a row of elements, dy wide, from the first to the last one in contact.
struct FatigueRow {
    double y = 0, z = 0, angle = 0;                ///< as in WearRow
    double pressure = 0, traction = 0;             ///< largest values in the row (N/mm^2)
    double force_x = 0, force_y = 0;               ///< tangential force on the body (N/mm)
    std::optional<double> shear{}, shear_depth{};  ///< see ContactFatigue (N/mm^2, mm)
    std::optional<double> dang_van{}, dang_van_depth{};

    bool operator==(const FatigueRow&) const = default;
};

struct ContactFatigue {
    WornBody body = WornBody::upper;
    double T_gamma = 0;               ///< without spin (N)
    double traction_coefficient = 0;  ///< mu_u = sqrt(Fx^2 + Fy^2)/Fn
    double force_angle = 0;           ///< direction of the force on the body, from the motion of the contact over it
                                      ///< (rad)
    bool driven = false;              ///< whether that force opposes this motion
    std::optional<double> FI_surf{};  ///< mu_u - 2 A k/(3 Fn) (Ekberg, Kabo and Andersson 2002), A the contact area
    double FI_sub = 0;                ///< Fn (1 + mu_u^2)/(4 A) (N/mm^2), plus a_DV times the hydrostatic residual
                                      ///< stress
    std::optional<double> load{};     ///< largest pressure over k
    std::optional<double> limit{};    ///< limit of the load: the largest pressure over the largest shear stress
    /// This is the largest |xz| at a depth, or |t| on the surface. Residual stresses do not affect it.
    std::optional<StressPlace> shear{};
    std::optional<StressPlace> von_mises{};
    /// This is the largest tau_a + a_DV sigma_h (Dang Van 1993). tau_a is half the difference of the principal values
    /// of the deviator minus the centre of its path, which is that of the smallest enclosing ball. sigma_h is the
    /// hydrostatic stress.
    std::optional<StressPlace> dang_van{};
    std::optional<double> utilisation{};  ///< dang_van over tau_e
    std::vector<FunctionDamage> damages{};
    std::vector<FatigueRow> rows{};  ///< by ascending y of the grid; empty without contact

    bool operator==(const ContactFatigue&) const = default;
};

/// Throws InvalidArgument, which names `field` or a field below it, such as "fatigue.damages[0].source".
void validate(const FatigueRequest& request, const std::string& field);

/// Returns the residual stresses at a depth (mm), which are zero without a table.
ResidualStress residual_at(const std::vector<ResidualStress>& table, double depth);

}  // namespace contactd
