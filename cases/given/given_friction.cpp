#include "given_friction.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "given/not_covered.hpp"
#include "types/number_text.hpp"
#include "types/units/plain_text.hpp"

namespace contactd::cases {
namespace {

using namespace law;

[[noreturn]] void refuse(const std::string& sentence) {
    throw NotCovered(Subject::friction, sentence);
}

FrictionLaw coulomb_of(const std::vector<double>& given) {
    if (given[0] != given[1])
        refuse(
            "FSTAT and FKIN differ: friction that changes abruptly at the first slip is not supported. Use equal "
            "values, or a law that falls with the slip velocity (L = 2, 3 or 4).");
    if (given[0] < 0) refuse("FSTAT = " + number_text(given[0]) + ": the friction coefficient must be at least 0.");
    return {{given[0]}};
}

/// Returns the slip velocity of a term of core's law that has fallen to one half at s.
double slip_velocity_of(int law, double s) {
    return law == linear ? 2 * s : law == exponential ? s / std::numbers::ln2 : s;
}

/// Returns a law with terms f1 and f2 that have fallen to one half at s1 and s2: max(0, 1 - v/(2 s)), 2^(-v/s), or
/// 1/(1 + v/s) and 1/(1 + (v/s)^2).
FrictionLaw falling_of(int law, const std::vector<double>& given) {
    const double fkin = given[0], distance = given[5], least_velocity = given[6];
    SecondTerm first{given[1], slip_velocity_of(law, given[2])}, second{given[3], slip_velocity_of(law, given[4])};
    if (fkin < 0 || first.fall < 0 || second.fall < 0) refuse("FKIN, F1 and F2 must be at least 0.");
    if (first.fall == 0 && second.fall == 0) return {{fkin}};
    if (first.fall == 0 && law != rational) std::swap(first, second);
    if (first.fall == 0) first.slip_velocity = second.slip_velocity;
    if (!(first.slip_velocity > 0) || (second.fall > 0 && !(second.slip_velocity > 0)))
        refuse("SABSH1 must be positive if F1 is, and SABSH2 if F2 is (s1 and s2 of cntc_setfrictionmethod).");
    if (distance < 0 || least_velocity < 0) refuse("MEMDST and MEM_S0 must be at least 0.");
    const SlipLaw name = law == linear ? SlipLaw::linear : law == rational ? SlipLaw::rational : SlipLaw::exponential;
    KineticFriction kinetic{name, fkin, first.slip_velocity};
    if (second.fall > 0) kinetic.second = second;
    if (distance > 0) kinetic.memory = FrictionMemory{distance, least_velocity};
    return {{fkin + first.fall + second.fall}, kinetic};
}

/// Returns the numbers of the exponential law for Polach's law mu (A + (1 - A) exp(-B v)) of [mu, A, B]. Its term has
/// fallen to one half at ln 2/B. The memory is that of CONTACT. A second term of 0 has its default velocity.
std::vector<double> exponential_of(const std::vector<double>& polach_law) {
    constexpr double usual_velocity_of_second = 10'000, memory_distance = 1e-3, memory_velocity = 10;  // mm, mm/s
    const double mu = polach_law[0], A = polach_law[1], B = polach_law[2];
    if (!(A >= 0 && A <= 1))
        refuse("polach_a = " + number_text(A) +
               ": the fraction of friction at high slip velocities must lie in [0, 1].");
    if (!(B >= 0)) refuse("polach_b = " + number_text(B) + ": the decrease of friction must be at least 0.");
    const bool falls = B > 0;
    return {falls ? A * mu : mu,
            falls ? mu - A * mu : 0,
            falls ? std::numbers::ln2 / B : usual_velocity_of_second,
            0,
            usual_velocity_of_second,
            memory_distance,
            memory_velocity};
}

/// Returns temperature-dependent friction from [fref, tref, dfheat, dtheat, memdst, mem_s0].
FrictionLaw heated_of(const std::vector<double>& given) {
    const double distance = given[4], least_velocity = given[5];
    if (distance < 0 || least_velocity < 0) refuse("MEMDST and MEM_S0 must be at least 0.");
    FrictionLaw law{{given[0]}, {}, {}, TemperatureFriction{given[2], given[1], given[3]}};
    if (distance > 0) law.temperature->memory = FrictionMemory{distance, least_velocity};
    validate(*law.temperature, law.mu);
    return law;
}

/// Converts lengths and velocities among the parameters to mm. Polach's B is the inverse of a velocity.
std::vector<double> in_mm(int law, std::vector<double> parameters, double length) {
    if (law == coulomb) return parameters;
    if (law == polach) {
        parameters[2] /= length;
        return parameters;
    }
    if (law == by_temperature) {
        for (const std::size_t i : {4, 5}) parameters[i] *= length;
        return parameters;
    }
    for (const std::size_t i : {2, 4, 5, 6}) parameters[i] *= length;
    return parameters;
}

FrictionLaw law_of(int law, const std::vector<double>& given) {
    if (law == coulomb) return coulomb_of(given);
    return law == by_temperature ? heated_of(given) : falling_of(law, given);
}

/// Raises the slip velocity of terms that are zero, where it has no effect, so that it can be interpolated. CONTACT
/// does the same with input files.
std::vector<double> interpolable(int law, std::vector<double> given) {
    constexpr double least_share = 1e-8, least_slip_velocity = 1e-4;  // mm/s
    if (law == coulomb || law == by_temperature) return given;
    for (const std::size_t share : {1, 3})
        if (given[share] < least_share) given[share + 1] = std::max(given[share + 1], least_slip_velocity);
    return given;
}

/// Returns the memory of temperature-dependent friction.
std::optional<FrictionMemory> memory_of(const FrictionLaw& law) {
    return law.temperature ? law.temperature->memory : std::nullopt;
}

}  // namespace

int friction_numbers(int law) {
    switch (law) {
        case coulomb:
            return 2;
        case polach:
            return 3;
        case by_temperature:
            return 6;
        case linear:
        case rational:
        case exponential:
            return 7;
        default:
            return 0;
    }
}

GivenFriction uniform_friction(int law, const std::vector<double>& numbers, const Units& units) {
    auto given = in_mm(law, numbers, units.length);
    if (law == polach) {
        given = exponential_of(given);
        law = exponential;
    }
    return {law, given, law_of(law, given)};
}

GivenFriction varying_friction(int law, int varies, const std::vector<FrictionAt>& places, const Units& units) {
    GivenFriction friction;
    double last = 0;
    bool is_first = true;
    for (const FrictionAt& at : places) {
        const GivenFriction here = uniform_friction(law, at.numbers, units);
        const double place = at.place * (varies == varies::along_track ? units.length : 1);
        if (!is_first && place <= last)
            refuse(varies == varies::by_angle ? "The angles ALPHVF of friction must increase."
                                              : "The places SVF of friction must increase.");
        last = place;
        if (varies == varies::by_angle && !is_first && memory_of(here.law) != memory_of(friction.law))
            refuse("MEMDST or MEM_S0 differs between angles. Use the same values at all angles.");
        if (is_first) friction = here;
        is_first = false;
        if (varies == varies::by_angle) friction.by_angle.push_back({place, here.law});
        if (varies == varies::along_track)
            friction.along_track.push_back({place, interpolable(here.method, here.parameters)});
        if (varies == varies::by_row) friction.by_row.push_back(here.law);
    }
    friction.method += 10 * varies;
    return friction;
}

FrictionLaw friction_at(const GivenFriction& friction, double place) {
    if (friction.along_track.empty()) return friction.law;
    return law_of(friction.method % 10, friction_along_track(friction.along_track, place));
}

std::string warning_of_places(const GivenFriction& friction, double place) {
    const auto thin = thin_friction(friction.method % 10, friction.along_track, place);
    if (!thin) return {};
    return "The friction coefficients at " + plain_text(thin->from) + " and " + plain_text(thin->to) +
           " mm along the track differ by " + plain_text(thin->difference) +
           ". Interpolation over such a distance is uncertain. Give friction at more places SVF.";
}

std::vector<double> numbers_of(const GivenFriction& friction, const Units& units) {
    return in_mm(friction.method % 10, friction.parameters, 1 / units.length);
}

}  // namespace contactd::cases
