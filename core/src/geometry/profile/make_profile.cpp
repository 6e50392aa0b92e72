#include "contactd/make_profile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "contactd/error.hpp"
#include "contactd/read_profile.hpp"
#include "geometry/profile/cleaning.hpp"
#include "geometry/profile/formula_points.hpp"
#include "geometry/profile/measured_points.hpp"
#include "geometry/profile/profile_fit.hpp"
#include "geometry/profile/profile_warnings.hpp"
#include "geometry/profile/smoothing.hpp"
#include "geometry/profile/wheel_landmarks.hpp"
#include "profile_files/points_upwards.hpp"

namespace contactd {
namespace {

using geometry::Fit;
using geometry::Points;

/// Returns the distance of the curve from a point near s on it.
double distance(const ProfileCurve& curve, const ProfilePoint& point, double s) {
    for (int iteration = 0; iteration < 10; ++iteration) {
        const auto here = curve.place(s);
        const double speed = here.slope.y * here.slope.y + here.slope.z * here.slope.z;
        s += ((point.y - here.at.y) * here.slope.y + (point.z - here.at.z) * here.slope.z) / speed;
    }
    const ProfilePoint at = curve.at(s);
    return std::hypot(at.y - point.y, at.z - point.z);
}

double spacing_of(const ProfileCurve& curve) {
    return (curve.end() - curve.begin()) / static_cast<double>(curve.points().size() - 1);
}

/// Sets the distances of the curve from the points that it smooths.
void tell_smoothing(Profile& made, const Points& points, const geometry::Visible& visible, const Fit& fit) {
    ProfileEvidence& evidence = made.evidence;
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < visible.points.size(); ++i) {
        if (!visible.places[i]) continue;
        const double far = distance(made.curve, points[*visible.places[i]], made.curve.knots()[i]);
        evidence.largest_distance = std::max(evidence.largest_distance, far);
        squares += far * far;
        ++count;
    }
    evidence.rms_distance = std::sqrt(squares / count);
    evidence.cut_off = fit.lambda > 0 ? geometry::wavelength_of(fit.lambda * evidence.spacing) : fit.length;
}

/// Counts lengths from the point nearest to the origin if y does not ascend throughout, so that elements lie where
/// reference programs put them. It uses the last of several such points, and for wheels the first.
ProfileCurve counted(ProfileCurve curve, const Points& points, ProfileKind kind) {
    const auto recedes = [](const ProfilePoint& a, const ProfilePoint& b) { return !(b.y > a.y); };
    if (std::ranges::adjacent_find(points, recedes) == points.end()) return curve;
    const auto nearer = [](const ProfilePoint& a, const ProfilePoint& b) {
        return a.y * a.y + a.z * a.z < b.y * b.y + b.z * b.z;
    };
    const ProfilePoint nearest = kind == ProfileKind::wheel ? *std::ranges::min_element(points, nearer)
                                                            : *std::min_element(points.rbegin(), points.rend(), nearer);
    return curve.counted_from(curve.s_at_y(nearest.y));
}

/// Makes the curve through the points, or near them, as far as it is visible from above. Hidden points affect the
/// smoothing, too.
Profile of_points(const ProfilePoints& given, ProfileKind kind, const Fit& fit, double rounded_to) {
    const Points points = geometry::measured_points(given, kind);
    const auto kinks = geometry::kinks_of(points, fit.kinks);
    const ProfileCurve rough(points, kinks);
    const geometry::Visible visible =
        geometry::visible_part(fit.smooths() ? geometry::smoothed(rough, fit) : points, kinks, kind);
    if (visible.points.size() < 2)
        throw InvalidArgument(fit.lambda > 0 ? "profile.smoothing_lambda" : "profile.smoothing_length",
                              "leaves no part of the profile visible from above; use a smaller one");
    Profile made{kind,
                 counted(ProfileCurve(visible.points, visible.kinks), points, kind),
                 {given.points.size(), visible.points.size()}};
    ProfileEvidence& evidence = made.evidence;
    evidence.spacing = spacing_of(rough);
    evidence.rounded_to = rounded_to;
    for (const std::size_t kink : visible.kinks)
        if (visible.places[kink]) evidence.kinks.push_back(points[*visible.places[kink]].y);
    if (fit.smooths()) tell_smoothing(made, points, visible, fit);
    if (kind == ProfileKind::wheel) evidence.wheel = geometry::wheel_landmarks(made.curve);
    evidence.warnings = geometry::profile_warnings(made);
    for (const auto& [from, to] : visible.bridged)
        evidence.warnings.push_back(geometry::bridge_warning(kind, from, to));
    return made;
}

Profile made_of(const ProfilePoints& given, ProfileKind kind) {
    return of_points(given, kind, geometry::fit_of(given), given.unit * geometry::rounding_of(given.points));
}

Profile made_of(const ProfileFile& file, ProfileKind kind) {
    const PointsOfFile read = points_of(file, kind);
    const Fit fit = geometry::fit_of(file);
    Profile made = naming_file(file, [&] { return of_points(read.points, kind, fit, read.rounded_to); });
    made.evidence.file = read.reading;
    made.evidence.warnings.insert(made.evidence.warnings.begin(), read.warnings.begin(), read.warnings.end());
    return made;
}

/// Makes the curve of a formula.
Profile made_of(const auto& shape, ProfileKind kind) {
    const auto points = geometry::formula_points(shape);  // Sides of an inclined head may lean under it.
    ProfileCurve curve(kind == ProfileKind::rail ? geometry::rail_seen_from_above(points) : points);
    ProfileEvidence evidence{points.size(), curve.points().size(), spacing_of(curve)};
    if (kind == ProfileKind::wheel) evidence.wheel = geometry::wheel_landmarks(curve);
    return {kind, std::move(curve), std::move(evidence)};
}

}  // namespace

Profile make_profile(const ProfileSpec& spec) {
    validate(spec);
    return std::visit([&](const auto& shape) { return made_of(shape, spec.kind); }, spec.shape);
}

}  // namespace contactd
