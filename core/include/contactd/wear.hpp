// Defines wear of surfaces in steady rolling as plain values: laws stated by users, with a source and their tested
// range, and the answers of a contact. There are no default laws or coefficients.
//
// Surfaces pass a contact along x. A point of a row loses the depth h = int f dx, with f the depth per length of path
// by a law of pressure p, traction t and relative slip s (slip over distance rolled; zero in adhesion). Depths are
// along the normal of each row. docs/damage.md describes the assumptions.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace contactd {

/// Selects the surface to which a law applies; the contact itself does not depend on it.
enum class WornBody { upper, lower };

/// Selects the scaling of the dissipation |t s| of the elements, whose sum is too low by a term of first order in dx.
/// `scaled` multiplies slips by one factor per patch, so that the sum is T gamma from forces and creepages, with spin.
/// `plain` does not scale them.
enum class WearEnergy { scaled, plain };

/// Describes the tested range of a law's argument.
struct WearRange {
    double least = 0, most = 0;

    bool operator==(const WearRange&) const = default;
};

/// Describes Archard's k (-) for sliding velocities between two bounds.
struct SevereWear {
    double k = 0;
    WearRange velocity{};  ///< (mm/s)

    bool operator==(const SevereWear&) const = default;
};

/// Describes Archard's k (-) for pressures above a fraction of the hardness, at any velocity.
struct SeizureWear {
    double k = 0;
    double pressure = 0;  ///< over the hardness

    bool operator==(const SeizureWear&) const = default;
};

/// Describes Archard's law (1953): f = k p |s|/H, with k from a map of sliding velocity V |s| and pressure. Its
/// argument is the sliding velocity (mm/s).
struct ArchardWear {
    double hardness = 0;                 ///< H (N/mm^2), > 0
    double mild = 0;                     ///< k (-) outside both other regions
    std::optional<SevereWear> severe{};  ///< absent: none
    std::optional<SeizureWear> seizure{};

    bool operator==(const ArchardWear&) const = default;
};

/// Describes the law f = c |t s|. Its argument is |t s| (N/mm^2).
struct EnergyWear {
    double coefficient = 0;  ///< c (mm^3/J)

    bool operator==(const EnergyWear&) const = default;
};

/// Describes a piece of a piecewise linear function, from an argument on: value + slope (argument - from).
struct WearPiece {
    double from = 0, value = 0, slope = 0;

    bool operator==(const WearPiece&) const = default;
};

/// Describes Sheffield's function (Lewis and Dwyer-Joyce 2004; Braghin et al. 2006): f = K(|t s|)/density. Its argument
/// is |t s| (N/mm^2), its values are K (ug/(m mm^2)).
struct UsfdWear {
    std::vector<WearPiece> pieces{};  ///< ascending; the first one starts at 0
    double density = 0;               ///< (kg/m^3)

    bool operator==(const UsfdWear&) const = default;
};

/// Describes British Rail's function (Pearce and Sherratt 1991) of a whole patch. Its values are D times the area that
/// the section of a wheel of diameter D loses per distance (mm mm^2/km), its argument is T gamma without spin (N). A
/// passage is a revolution, in which the diameter cancels. The area is distributed over the rows by |t s|.
struct BrWear {
    std::vector<WearPiece> pieces{};  ///< ascending; the first one starts at 0

    bool operator==(const BrWear&) const = default;
};

/// Describes Zobory's law (1997): f = k |t s|/density. Its argument is the power V |t s| (W/mm^2), its values are k
/// (kg/J).
struct ZoboryWear {
    std::vector<WearPiece> pieces{};  ///< ascending; the first one starts at 0
    double density = 0;               ///< (kg/m^3)

    bool operator==(const ZoboryWear&) const = default;
};

/// Describes a factor for depths on a surface inclined by `angle` (rad, from the horizontal, negative on the gauge
/// side).
struct WearZone {
    double angle = 0, factor = 0;

    bool operator==(const WearZone&) const = default;
};

/// Describes a law of wear, which has one of five kinds.
struct WearLaw {
    std::string name, source;  ///< neither is empty; each law has its own name
    WornBody body = WornBody::upper;
    WearRange range{};  ///< of the argument
    std::optional<ArchardWear> archard{};
    std::optional<EnergyWear> energy{};
    std::optional<UsfdWear> usfd{};
    std::optional<BrWear> br{};
    std::optional<ZoboryWear> zobory{};
    /// Zones are in order of ascending angles; factors are linear between them and constant beyond. Without zones, the
    /// factor is 1 everywhere. Use them for lubricated flanges.
    std::vector<WearZone> zones{};

    bool operator==(const WearLaw&) const = default;
};

struct WearRequest {
    WearEnergy energy = WearEnergy::scaled;
    std::vector<WearLaw> laws{};  ///< if empty, rows only contain the variables of laws

    bool operator==(const WearRequest&) const = default;
};

/// Describes a row of elements, dy wide, from the first to the last one in contact.
struct WearRow {
    double y = 0, z = 0;           ///< its middle (mm); for wheels on rails in track coordinates
    double angle = 0;              ///< its inclination (rad); depths are along its normal
    double pressure_slip = 0;      ///< int p |s| dx (N/mm)
    double dissipation = 0;        ///< int |t s| dx (N/mm)
    std::vector<double> depths{};  ///< removed in one passage (mm), by the laws in order

    bool operator==(const WearRow&) const = default;
};

/// Describes the wear of a contact by a law.
struct LawWear {
    std::string name;
    WornBody body = WornBody::upper;
    double area = 0;      ///< area of the section removed in a passage (mm^2): the volume per distance rolled
    double depth = 0;     ///< the largest of the rows (mm)
    double argument = 0;  ///< the largest argument of the law, in the unit of its range

    bool operator==(const LawWear&) const = default;
};

struct ContactWear {
    double T_gamma = 0;            ///< by forces and creepages, without spin: |Fx xi + Fy eta| (N, J/m)
    double T_gamma_with_spin = 0;  ///< including spin: -(Fx xi + Fy eta + Mz phi) (N)
    double dissipation = 0;        ///< sum of |t s| over the elements, not scaled (N)
    double factor = 1;             ///< factor of the slips
    double largest_pressure_slip = 0, largest_dissipation = 0;  ///< p |s| and |t s| at an element (N/mm^2)
    double largest_sliding_velocity = 0;                        ///< (mm/s)
    std::vector<WearRow> rows{};                                ///< by ascending y of the grid; empty without contact
    std::vector<LawWear> laws{};                                ///< in the order of the request

    bool operator==(const ContactWear&) const = default;
};

/// Throws InvalidArgument, which names `field` or a field below it, such as "wear.laws[0].source".
void validate(const WearRequest& request, const std::string& field);

/// Returns whether a law depends on the velocity of rolling.
bool needs_velocity(const WearLaw& law);

/// Returns the factor of a law for a row inclined by `angle` (rad).
double factor_at(const std::vector<WearZone>& zones, double angle);

/// Returns the value of a piecewise linear function with at least one piece.
double value_at(const std::vector<WearPiece>& pieces, double argument);

}  // namespace contactd
