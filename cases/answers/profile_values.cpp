#include "profile_values.hpp"

#include <string>

#include "geometry/placement/gauge_point.hpp"
#include "given/not_covered.hpp"

namespace contactd::cases {
namespace {

/// Returns positions along the curve.
std::vector<double> samples(const ProfileCurve& curve, const ProfileQuery& query) {
    const std::vector<double>& knots = curve.knots();
    if (query.sampling <= 0) return knots;
    std::vector<double> places;
    if (query.sampling == 1) {
        const double length = curve.end() - curve.begin();
        if (!(query.step > 0) || length / query.step > double{most_profile_points})
            throw NotCovered(Subject::input, "The distance of the points is " + std::to_string(query.step) +
                                                 " mm: it must be positive and produce at most " +
                                                 std::to_string(most_profile_points) + " points.");
        for (int i = 0; i <= static_cast<int>(length / query.step); ++i)
            places.push_back(curve.begin() + i * query.step);
        return places;
    }
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        for (int piece = 0; piece < query.sampling; ++piece)
            places.push_back(knots[i] + (knots[i + 1] - knots[i]) * piece / query.sampling);
    places.push_back(knots.back());
    return places;
}

/// Returns the values of task 3, with the points of the canted profile.
std::vector<double> gauge_values(const ProfileCurve& profile, const Track& track, const RailFrames& frames) {
    const double top = geometry::s_of_top(profile, track.cant);
    const double highest = geometry::canted(profile.at(top), track.cant).z;
    const auto lowest = geometry::s_of_depth(profile, track.cant, top, highest + track.gauge_height);
    if (!lowest) throw NotCovered(Subject::profile, "The profile of the rail ends above the gauge height GAUGHT.");
    const double face = geometry::least_y(profile, track.cant, *lowest, top);
    const ProfilePoint end = geometry::canted(profile.at(*lowest), track.cant);
    return {face, end.z, frames.side * frames.rail.origin.y, frames.rail.origin.z, end.y, highest + track.gauge_height};
}

}  // namespace

std::vector<double> profile_values(const ProfileQuery& query, const RailOutlines& outlines,
                                   const std::function<RailFrames()>& frames_of) {
    if (query.task < 0 || query.task > 5)
        throw NotCovered(Subject::input, "itask = " + std::to_string(query.task) +
                                             " is not supported. Use -1 to 5; sections of varying profiles are not "
                                             "available.");
    const auto& [setup, profiles] = outlines;
    const ProfileCurve& curve = query.wheel ? profiles.wheel : profiles.rail;
    const std::vector<double> places = samples(curve, query);
    if (query.task == 0) return {static_cast<double>(places.size())};
    std::vector<double> first, second;
    if (query.task >= 4) {
        for (const double s : places) first.push_back(query.task == 4 ? s : curve.angle(s));
        return first;
    }
    if (query.task == 1) {
        for (const double s : places) first.push_back(curve.at(s).y), second.push_back(curve.at(s).z);
    } else {
        const RailFrames frames = frames_of();
        if (query.task == 3) {
            if (query.wheel) throw NotCovered(Subject::profile, "A wheel has no gauge. Use itask = 3 for the rail.");
            return gauge_values(curve, setup.track, frames);
        }
        const geometry::Frame& frame = query.wheel ? frames.wheel : frames.rail;
        for (const double s : places) {
            const geometry::Vector3 at = frame.outside({0, curve.at(s).y, curve.at(s).z});
            first.push_back(frames.side * at.y);
            second.push_back(at.z);
        }
    }
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

}  // namespace contactd::cases
