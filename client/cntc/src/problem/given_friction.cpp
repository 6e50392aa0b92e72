#include "given_friction.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "edge/arguments.hpp"
#include "edge/codes.hpp"
#include "edge/last_error.hpp"
#include "types/number_text.hpp"
#include "types/units/plain_text.hpp"

namespace contactd::cntc {
namespace {

enum Law { coulomb = 0, linear = 2, rational = 3, exponential = 4, polach = 5, by_temperature = 6 };
enum Varies { nowhere = 0, with_angle = 1, along_track = 2 };

[[noreturn]] void refuse(const std::string& sentence) {
    throw Refused(error_code::friction, sentence);
}

FrictionLaw coulomb_of(const std::vector<double>& given) {
    if (given[0] != given[1])
        refuse(
            "fstat and fkin differ; friction that changes to another value at the first slip has no solution here. "
            "Give the same, or a law that falls with the slip velocity (2, 3 or 4).");
    if (given[0] < 0) refuse("fstat is negative.");
    return {{given[0]}};
}

/// Slip velocity of a term of core's law that has halved at s.
double slip_velocity_of(int law, double s) {
    return law == linear ? 2 * s : law == exponential ? s / std::numbers::ln2 : s;
}

/// Terms f1 and f2 that have halved at s1 and s2: max(0, 1 - v/(2 s)), 2^(-v/s), or 1/(1 + v/s) and 1/(1 + (v/s)^2).
FrictionLaw falling_of(int law, const std::vector<double>& given) {
    const double fkin = given[0], distance = given[5], least_velocity = given[6];
    SecondTerm first{given[1], slip_velocity_of(law, given[2])}, second{given[3], slip_velocity_of(law, given[4])};
    if (fkin < 0 || first.fall < 0 || second.fall < 0) refuse("fkin, f1 or f2 is negative.");
    if (first.fall == 0 && second.fall == 0) return {{fkin}};
    if (first.fall == 0 && law != rational) std::swap(first, second);
    if (first.fall == 0) first.slip_velocity = second.slip_velocity;
    if (!(first.slip_velocity > 0)) refuse("s1 must be positive.");
    if (second.fall > 0 && !(second.slip_velocity > 0)) refuse("s2 must be positive.");
    if (distance < 0 || least_velocity < 0) refuse("memdst or mem_s0 is negative.");
    const SlipLaw name = law == linear ? SlipLaw::linear : law == rational ? SlipLaw::rational : SlipLaw::exponential;
    KineticFriction kinetic{name, fkin, first.slip_velocity};
    if (second.fall > 0) kinetic.second = second;
    if (distance > 0) kinetic.memory = FrictionMemory{distance, least_velocity};
    return {{fkin + first.fall + second.fall}, kinetic};
}

/// mu (A + (1 - A) exp(-B v)) of [mu, A, B] is the exponential law that has halved at ln 2/B, which the program gives a
/// memory of its own. A second term of 0 has its usual velocity.
std::vector<double> exponential_of(const std::vector<double>& polach_law) {
    constexpr double usual_velocity_of_second = 10'000, memory_distance = 1e-3, memory_velocity = 10;  // mm, mm/s
    const double mu = polach_law[0], A = polach_law[1], B = polach_law[2];
    if (!(A >= 0 && A <= 1)) refuse("polach_a = " + number_text(A) + ": the share of friction left lies in 0 to 1.");
    if (!(B >= 0)) refuse("polach_b = " + number_text(B) + ": it must not be negative.");
    const bool falls = B > 0;
    return {falls ? A * mu : mu,
            falls ? mu - A * mu : 0,
            falls ? std::numbers::ln2 / B : usual_velocity_of_second,
            0,
            usual_velocity_of_second,
            memory_distance,
            memory_velocity};
}

/// [fref, tref, dfheat, dtheat, memdst, mem_s0].
FrictionLaw heated_of(const std::vector<double>& given) {
    const double distance = given[4], least_velocity = given[5];
    if (distance < 0 || least_velocity < 0) refuse("memdst or mem_s0 is negative.");
    FrictionLaw law{{given[0]}, {}, {}, TemperatureFriction{given[2], given[1], given[3]}};
    if (distance > 0) law.temperature->memory = FrictionMemory{distance, least_velocity};
    validate(*law.temperature, law.mu);
    return law;
}

int parameters_of(int law) {
    constexpr int of_falling = 7;
    return law == coulomb ? 2 : law == polach ? 3 : law == by_temperature ? 6 : of_falling;
}

/// Parameters that are lengths or velocities, in mm. Polach's B is one over a velocity.
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

GivenFriction same_friction(int method, const std::vector<double>& parameters, const Units& units) {
    auto given = in_mm(method, parameters, units.length);
    if (method == polach) {
        given = exponential_of(given);
        method = exponential;
    }
    return {method, given, law_of(method, given)};
}

/// A term without a share has any slip velocity, and one that can be interpolated, as input files have it.
std::vector<double> interpolable(int law, std::vector<double> given) {
    constexpr double least_share = 1e-8, least_slip_velocity = 1e-4;  // mm/s
    if (law == coulomb || law == by_temperature) return given;
    for (const std::size_t share : {1, 3})
        if (given[share] < least_share) given[share + 1] = std::max(given[share + 1], least_slip_velocity);
    return given;
}

/// Of friction by temperature.
std::optional<FrictionMemory> memory_of(const FrictionLaw& law) {
    return law.temperature ? law.temperature->memory : std::nullopt;
}

/// [number, and of each its angle or place, and the parameters of the law there].
GivenFriction varying_friction(int method, const std::vector<double>& given, const Units& units) {
    const int law = method % 10, varies = method / 10, size = 1 + parameters_of(law);
    const int count = given.empty() ? 0 : whole(given[0], "the number of places of friction");
    if (count < 1 || given.size() != 1 + static_cast<std::size_t>(count) * static_cast<std::size_t>(size))
        refuse("Friction that varies has " + std::to_string(given.size()) + " values, which " + std::to_string(count) +
               " places with " + std::to_string(size) + " values each are not.");
    GivenFriction friction;
    double last = 0;
    for (int k = 0; k < count; ++k) {
        const auto first = given.begin() + 1 + k * size;
        const GivenFriction here = same_friction(law, {first + 1, first + size}, units);
        const double place = *first * (varies == along_track ? units.length : 1);
        if (k > 0 && place <= last) refuse("Angles or places of friction must ascend.");
        last = place;
        if (varies == with_angle && k > 0 && memory_of(here.law) != memory_of(friction.by_angle.front().law))
            refuse("memdst or mem_s0 differs between angles. Give the same memory for all.");
        if (k == 0) friction = here;
        if (varies == with_angle)
            friction.by_angle.push_back({place, here.law});
        else
            friction.along_track.push_back({place, interpolable(here.method, here.parameters)});
    }
    friction.method += 10 * varies;
    return friction;
}

}  // namespace

GivenFriction read_friction(int method, const double* params, const int* nparam, const Settings& settings) {
    const bool on_rails = settings.module == module_number::wheel_rail;
    const int law = method % 10, varies = method / 10;
    const bool has_law = law == coulomb || (law >= linear && law <= by_temperature);
    if (method < 0 || !has_law || varies > (on_rails ? along_track : nowhere))
        refuse("Friction method " + std::to_string(method) + " is not supported; use 0, 2, 3, 4, 5 or 6" +
               (on_rails ? ", plus 10 for friction by the rail's angle or 20 for friction along the track."
                         : ": friction of basic contact does not vary."));
    if (varies != nowhere) return varying_friction(method, numbers(params, nparam, 1, "params"), settings.units);
    return same_friction(method, list(params, nparam, parameters_of(law), "params"), settings.units);
}

FrictionLaw friction_at(const GivenFriction& friction, double place) {
    const int law = friction.method % 10;
    if (const auto thin = thin_friction(law, friction.along_track, place))
        warn("Coefficients of friction at the places " + plain_text(thin->from) + " and " + plain_text(thin->to) +
             " mm along the track differ by " + plain_text(thin->difference) +
             "; a straight line between these is a guess. Give friction at more places.");
    return law_of(law, friction_along_track(friction.along_track, place));
}

std::vector<double> numbers_of(const GivenFriction& friction, const Units& units) {
    return in_mm(friction.method % 10, friction.parameters, 1 / units.length);
}

}  // namespace contactd::cntc
