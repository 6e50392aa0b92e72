#include "geometry/conicity/conicity_gradient.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

#include "contactd/error.hpp"
#include "geometry/conicity/least_gap.hpp"
#include "geometry/placement/gauge_point.hpp"
#include "geometry/placement/rail_origin_gradient.hpp"
#include "geometry/profile/curve_cotangent.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double longest_step = 0.05, longest_way = 0.05;  // mm: of the shift, and of the contact on the wheel
constexpr double leap = 1e-7;                              // mm: a contact that still moves within it leaps

/// Describes a contact of one side at a shift; its radius is relative to the mean of both nominal radii.
struct Contact {
    double shift = 0, wheel_s = 0, rail_s = 0, wheel_y = 0, radius = 0;
};

/// Describes an oscillation, which passes each shift twice in a turn of t.
struct Turn {
    double centre, amplitude;

    double shift(double t) const { return centre + amplitude * std::sin(t); }
    double sine(double shift) const { return std::fmin(std::fmax((shift - centre) / amplitude, -1), 1); }
    double t(double shift) const { return std::asin(sine(shift)); }
};

/// Represents one side of a wheelset; `outwards` is 1 for the right one and -1 for the left one.
class Side {
   public:
    Side(const WheelOverRail& pair, double outwards, double mean_radius)
        : pair_(pair),
          outwards_(outwards),
          larger_(pair.nominal_radius - mean_radius),
          wheel_(pair.wheel),
          rail_(pair.rail) {}

    /// Finds the contacts from one shift to another so closely that the contact moves little between two of them,
    /// unless it leaps.
    void look(const Turn& turn, const Observer& observer) {
        const int steps = static_cast<int>(std::ceil(std::numbers::pi * turn.amplitude / longest_step));
        contacts_.assign(1, at(turn.centre - turn.amplitude));
        for (int i = 1; i <= steps; ++i) {
            observer.throw_if_cancelled();
            fill(Contact(contacts_.back()), at(turn.shift(std::numbers::pi * (static_cast<double>(i) / steps - 0.5))));
        }
    }
    const std::vector<Contact>& contacts() const { return contacts_; }
    double outwards() const { return outwards_; }
    static bool leaps(const Contact& a, const Contact& b) {
        return b.shift - a.shift <= leap && std::abs(b.wheel_y - a.wheel_y) > longest_way;
    }

    /// Adds the gradient by the radius of a contact.
    void add_radius(const Contact& at, double by_radius) {
        const double closing = second(pair_.wheel.place(at.wheel_s)) - second(pair_.rail.place(at.rail_s));
        const double slope = first(pair_.wheel.place(at.wheel_s));
        add_height(wheel_, at.wheel_s, by_radius, -by_radius * slope / closing);
        add_height(rail_, at.rail_s, 0, by_radius * slope / closing);
        origin_.y -= by_radius * slope * second(pair_.rail.place(at.rail_s)) / closing;
    }
    /// Adds the gradient by the shift at which two contacts have the same gap.
    void add_leap(const Contact& a, const Contact& b, double by_shift) {
        const double slope_a = first(pair_.rail.place(a.rail_s)), slope_b = first(pair_.rail.place(b.rail_s));
        const double by_gap = by_shift / (outwards_ * (slope_a - slope_b));
        for (const auto& [contact, sign, slope] : {std::tuple(&a, -1, slope_a), std::tuple(&b, 1, slope_b)}) {
            add_height(rail_, contact->rail_s, sign * by_gap, 0);
            add_height(wheel_, contact->wheel_s, -sign * by_gap, 0);
            origin_.y -= sign * by_gap * slope;
        }
    }
    SideGradient result() const { return {wheel_.by_points(), rail_.by_points(), origin_}; }

   private:
    static double first(const ProfileCurve::Place& here) { return here.slope.z / here.slope.y; }
    static double second(const ProfileCurve::Place& here) {
        return (here.curving.z * here.slope.y - here.slope.z * here.curving.y) / std::pow(here.slope.y, 3);
    }
    /// Adds the gradient by the height of a curve at constant y and by its derivative along y: with n the displacement
    /// along (-z', y'), the height changes by n/y', and its derivative by (n' - n y''/y')/y'^2.
    static void add_height(CurveCotangent& curve, double s, double by_height, double by_slope) {
        const auto here = curve.curve().place(s);
        const double along = here.slope.y;
        curve.add_normal(s, by_height / along - by_slope * here.curving.y / (along * along * along),
                         by_slope / (along * along));
    }
    Contact at(double shift) const {
        const LeastGap found = least_gap(pair_, outwards_ * shift, 0);
        if (std::isinf(found.gap) || found.at_end)
            throw InvalidArgument("amplitudes[0]", "reaches the shift " + number_text(shift) +
                                                       " mm, where a wheel is at the end of a profile; use a smaller "
                                                       "amplitude or longer profiles");
        const ProfilePoint on_wheel = pair_.wheel.at(found.wheel_s);
        return {shift, found.wheel_s, found.rail_s, on_wheel.y, larger_ + on_wheel.z};
    }
    void fill(const Contact& from, const Contact& to) {
        if (std::abs(to.wheel_y - from.wheel_y) > longest_way && to.shift - from.shift > leap) {
            const Contact middle = at((from.shift + to.shift) / 2);
            fill(from, middle);
            fill(middle, to);
            return;
        }
        contacts_.push_back(to);
    }

    const WheelOverRail& pair_;
    double outwards_, larger_;
    CurveCotangent wheel_, rail_;
    ProfilePoint origin_{};
    std::vector<Contact> contacts_;
};

/// Calls `at` with the contacts of a side and their weights in an integral over a turn by the trapezoidal rule in t.
template <class At>
void integrate(const Side& side, const Turn& turn, const At& at) {
    const auto& contacts = side.contacts();
    for (std::size_t i = 0; i + 1 < contacts.size(); ++i) {
        const double width = turn.t(contacts[i + 1].shift) - turn.t(contacts[i].shift);
        at(contacts[i], width);  // half of the width, at two times of the turn
        at(contacts[i + 1], width);
    }
}

}  // namespace

// The conicity is 1/(2 pi A) times the integral of dr sin t, with a centre at which that of dr vanishes. The centre
// moves by -D/E for a change D of the latter, so that the weight of a change of dr is sin t - C/E, where C and E are
// the integrals of dr' sin t and of dr'.
ConicityGradient harmonic_gradient(const WheelsetOnTrack& wheelset, double amplitude, const ConicitySettings& settings,
                                   const Observer& observer) {
    if (settings.roll != WheelsetRoll::neglected)
        throw InvalidArgument("settings.roll", "is demanded, for which the conicity has no gradient; use neglected");
    const double conicity = equivalent_conicities(wheelset, std::array{amplitude}, settings, observer).front().harmonic;
    if (std::isnan(conicity))
        throw InvalidArgument("amplitudes[0]", "is " + number_text(amplitude) +
                                                   " mm, at which the wheelset does not oscillate, so the conicity has "
                                                   "no gradient; use another amplitude");
    const double radius = (wheelset.right.nominal_radius + wheelset.left.nominal_radius) / 2;
    Side right(wheelset.right, 1, radius), left(wheelset.left, -1, radius);
    Turn turn{0, amplitude};
    const auto look = [&] {
        for (Side* side : {&right, &left}) side->look(turn, observer);
    };
    double mean = 0, swing = 0;  // integrals of dr and dr sin t
    const auto measure = [&] {
        mean = swing = 0;
        for (const Side* side : {&right, &left})
            integrate(*side, turn, [&](const Contact& contact, double width) {
                mean += side->outwards() * width * contact.radius;
                swing += side->outwards() * width * contact.radius * turn.sine(contact.shift);
            });
    };
    // The integrals of dr' and dr' sin t follow from the changes of dr, and include its leaps.
    double rise = 0, tilt = 0;
    const auto measure_slopes = [&] {
        rise = tilt = 0;
        for (const Side* side : {&right, &left}) {
            const auto& contacts = side->contacts();
            for (std::size_t i = 0; i + 1 < contacts.size(); ++i) {
                const double from = turn.t(contacts[i].shift), to = turn.t(contacts[i + 1].shift);
                const double change = side->outwards() * (contacts[i + 1].radius - contacts[i].radius) /
                                      (contacts[i + 1].shift - contacts[i].shift);
                rise += 2 * change * (to - from);
                tilt += 2 * change * (std::cos(from) - std::cos(to));
            }
        }
    };
    for (int iteration = 0; iteration < 10; ++iteration) {
        look();
        measure();
        measure_slopes();
        if (!(std::abs(mean) > 1e-6 * amplitude * std::abs(rise))) break;
        turn.centre -= mean / rise;
    }
    const double offset = rise == 0 ? 0 : tilt / rise, factor = 1 / (2 * std::numbers::pi * amplitude);
    for (Side* side : {&right, &left}) {
        const double sign = side->outwards();
        integrate(*side, turn, [&](const Contact& contact, double width) {
            side->add_radius(contact, factor * sign * width * (turn.sine(contact.shift) - offset));
        });
        const auto& contacts = side->contacts();
        for (std::size_t i = 0; i + 1 < contacts.size(); ++i) {
            const Contact &a = contacts[i], &b = contacts[i + 1];
            if (!Side::leaps(a, b)) continue;
            const double sine = turn.sine(a.shift), speed = amplitude * std::sqrt(std::fmax(1 - sine * sine, 1e-12));
            const double by_shift = -2 * factor * sign * (b.radius - a.radius) * (sine - offset) / speed;
            side->add_leap(a, b, by_shift);
        }
    }
    return {factor * swing, left.result(), right.result()};
}

std::vector<ProfilePoint> by_rail_points(const SideGradient& side, const ProfileCurve& rail, const Track& track) {
    CurveCotangent curve(rail);
    add_by_rail_origin(track, side.rail_origin, curve);
    std::vector<ProfilePoint> by_points = curve.by_points();
    for (std::size_t i = 0; i < by_points.size(); ++i) {
        const ProfilePoint upright = canted(side.rail[i], -track.cant);
        by_points[i].y += upright.y;
        by_points[i].z += upright.z;
    }
    return by_points;
}

}  // namespace contactd::geometry
