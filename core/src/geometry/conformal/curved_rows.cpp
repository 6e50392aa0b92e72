#include "geometry/conformal/curved_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace contactd::geometry {
namespace {

constexpr double facing = 0.9;  // least length of the mean of both normals
constexpr double least_cosine = 0.1;
constexpr int beside = 2;  // rows on both sides

/// Describes a point of a surface in the plane x = const of the track, and the direction of the surface there.
struct SectionPoint {
    double y, z, y_slope, z_slope;
};

class RailSection {
   public:
    RailSection(const RailSurface& rail, const ContactReference& reference)
        : rail_(rail), x_(reference.x), profile_(rail.section(reference.x)) {
        const Vector3 inside = rail.frame().inside({0, reference.y, reference.z});
        start_ = profile_.arc_length(profile_.s_at_y(inside.y));
        length_ = profile_.arc_length(profile_.end());
    }

    double start() const { return start_; }

    /// Returns the point at this arc length from the reference, or nothing beyond the profile.
    std::optional<SectionPoint> at(double from_reference) const {
        const double arc = start_ + from_reference;
        if (!(arc >= 0 && arc <= length_)) return std::nullopt;
        const ProfileCurve::Place place = rail_.rotated_to(x_, rail_.placed(profile_, profile_.s_at_arc_length(arc)));
        return SectionPoint{place.at.y, place.at.z, place.slope.y, place.slope.z};
    }

   private:
    const RailSurface& rail_;
    double x_, start_ = 0, length_ = 0;
    ProfileCurve profile_;
};

class WheelSection {
   public:
    WheelSection(const WheelSurface& wheel, const ContactReference& reference) : wheel_(wheel), x_(reference.x) {
        const Vector3 inside = wheel.frame().inside({reference.x, reference.y, reference.z});
        start_ = wheel.profile().arc_length(wheel.profile().s_at_y(inside.y - wheel.base_y()));
        length_ = wheel.profile().arc_length(wheel.profile().end());
    }

    double start() const { return start_; }

    std::optional<SectionPoint> at(double from_reference) const {
        constexpr double step = 1e-3;  // mm, for the direction
        const double arc = start_ + from_reference;
        if (!(arc - step >= 0 && arc + step <= length_)) return std::nullopt;
        const Vector3 here = point(arc), before = point(arc - step), behind = point(arc + step);
        return SectionPoint{here.y, here.z, behind.y - before.y, behind.z - before.z};
    }

   private:
    Vector3 point(double arc) const {
        constexpr int iterations = 4;  // each reduces the error by the lean of the axle
        const double s = wheel_.profile().s_at_arc_length(arc);
        const Frame& frame = wheel_.frame();
        double x = frame.inside({x_, 0, frame.origin.z + wheel_.nominal_radius()}).x;
        Vector3 at = frame.outside(wheel_.in_wheel(x, s));
        for (int iteration = 0; iteration < iterations; ++iteration) {
            x += (x_ - at.x) / frame.axes.x.x;
            at = frame.outside(wheel_.in_wheel(x, s));
        }
        return at;
    }

    const WheelSurface& wheel_;
    double x_, start_ = 0, length_ = 0;
};

/// Returns the row half-way between both, or nothing if they do not face each other.
std::optional<ContactRow> row_between(const std::optional<SectionPoint>& rail,
                                      const std::optional<SectionPoint>& wheel) {
    if (!rail || !wheel) return std::nullopt;
    const double of_rail = std::hypot(rail->y_slope, rail->z_slope);
    const double of_wheel = std::hypot(wheel->y_slope, wheel->z_slope);
    const double y = 0.5 * (rail->y_slope / of_rail + wheel->y_slope / of_wheel);
    const double z = 0.5 * (rail->z_slope / of_rail + wheel->z_slope / of_wheel);
    if (!(std::hypot(y, z) > facing)) return std::nullopt;
    return ContactRow{0.5 * (rail->y + wheel->y), 0.5 * (rail->z + wheel->z), std::atan2(z, y)};
}

}  // namespace

std::vector<double> CurvedRows::in_plane(const ContactReference& reference) const {
    std::vector<double> across;
    for (const ContactRow& row : rows)
        across.push_back((row.y - reference.y) * std::cos(reference.angle) +
                         (row.z - reference.z) * std::sin(reference.angle));
    return across;
}

CurvedRows curved_rows(const WheelSurface& wheel, const RailSurface& rail, const ContactReference& reference,
                       const Extent& y, double step, double middle, int more_below, int more_above) {
    const RailSection on_rail(rail, reference);
    const WheelSection on_wheel(wheel, reference);
    const auto row = [&](int i) -> std::optional<ContactRow> {
        const double at = i * step + middle;
        const std::optional<ContactRow> between = row_between(on_rail.at(at), on_wheel.at(at));
        // Further rows would be perpendicular to the plane of the reference.
        if (between && std::cos(between->angle - reference.angle) < least_cosine) return std::nullopt;
        return between;
    };
    CurvedRows found;
    const std::optional<ContactRow> start = row(0);
    if (!start) return found;
    found.rows.push_back(*start);
    // Adds rows from the reference to both sides while they lie within, and some more.
    const auto extend = [&](int direction, int more, const auto& is_within, const auto& add) {
        int left = beside + more;
        for (int i = direction; left > 0; i += direction) {
            const std::optional<ContactRow> next = row(i);
            if (!next) return;
            if (!is_within(*next)) --left;
            add(*next);
        }
    };
    extend(
        -1, more_below, [&](const ContactRow& at) { return at.y >= y.from; },
        [&](const ContactRow& at) {
            found.rows.insert(found.rows.begin(), at);
            --found.first;
        });
    extend(
        1, more_above, [&](const ContactRow& at) { return at.y <= y.to; },
        [&](const ContactRow& at) { found.rows.push_back(at); });
    found.on_rail = on_rail.start() + found.first * step + middle;
    found.on_wheel = on_wheel.start() + found.first * step + middle;
    return found;
}

}  // namespace contactd::geometry
