#include "geometry/position.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "closed_forms/hertz.hpp"
#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "geometry/conformal/curved_rows.hpp"
#include "geometry/conformal/curved_slip.hpp"
#include "geometry/distance/heights.hpp"
#include "geometry/motion/creepages.hpp"
#include "geometry/profile/gauge_side.hpp"
#include "geometry/profile/profile_warnings.hpp"
#include "geometry/profile/wheel_landmarks.hpp"
#include "geometry/search/locus_search.hpp"
#include "geometry/search/mesh_search.hpp"
#include "geometry/search/patch_grid.hpp"
#include "geometry/search/search_nodes.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double out_of_reach = 10;  // gap (mm) of elements without wheel or rail

/// Returns a profile; errors use its name in the setup.
Profile profile_of(const ProfileSpec& spec, const std::string& name) {
    return renaming(in_place_of("profile", name), [&] { return make_profile(spec); });
}

ProfileCurve curve_of(const ProfileSpec& spec, const std::string& name) {
    return profile_of(spec, name).curve;
}

/// Checks that the profiles and the sizes around them are consistent.
void check_fit(const WheelRailSetup& setup, const ProfileCurve& wheel, const ProfileCurve& rail) {
    const double rail_width = rail.points().back().y - rail.points().front().y;
    if (!setup.track.rail_origin && !(setup.track.gauge > rail_width))
        throw InvalidArgument("track.gauge", "is " + number_text(setup.track.gauge) +
                                                 ", less than the width of a rail, " + short_text(rail_width) +
                                                 " mm: the rails would overlap");
    double highest = 0;
    for (const ProfilePoint& point : wheel.points()) highest = std::min(highest, point.z);
    if (!(setup.wheelset.nominal_radius > 2 * -highest))
        throw InvalidArgument("wheelset.nominal_radius", "is " + number_text(setup.wheelset.nominal_radius) +
                                                             ", but the wheel's profile reaches " +
                                                             short_text(-highest) +
                                                             " mm towards the axle; it must be more than twice that");
}

WheelsetPosition at_zero(WheelsetPosition position) {
    position.z = 0;
    return position;
}

/// Returns heights above the plane of the reference, which are NaN where a surface does not stand above it.
SurfaceHeights heights_of(const WheelRailSetup& setup, const WheelSurface& wheel, const RailSurface& rail,
                          const CandidatePatch& found) {
    const ContactPlace& place = found.place;
    const ContactReference& reference = place.reference;
    const PlanePoints points = place.rows.empty()
                                   ? PlanePoints(place.grid)
                                   : PlanePoints(place.grid, CurvedRows{.rows = place.rows}.in_plane(reference));
    return {rail_heights(rail, reference, points),
            setup.wheel_surface == WheelSurfaceKind::exact
                ? wheel_heights(wheel, reference, points)
                : meshed_wheel_heights(wheel, {place, found.needed, found.counted_from}, points)};
}

/// Returns distances along the normal of the plane, or of each row, which are NaN where wheel or rail are not above the
/// plane.
std::vector<double> distances(const RailSurface& rail, const ContactPlace& place, const SurfaceHeights& heights) {
    std::vector<double> h = heights.wheel;
    const auto nx = static_cast<std::size_t>(place.grid.nx);
    for (std::size_t i = 0; i < h.size(); ++i) {
        h[i] = heights.rail[rail.varies() ? i : i / nx] - h[i];
        if (!place.rows.empty()) h[i] *= std::cos(place.rows[i / nx].angle - place.reference.angle);
    }
    return h;
}

/// Excludes the distances of elements that may not be in contact.
void keep_apart(const Grid& grid, const Grid& touches, std::vector<double>& h) {
    const long left = std::lround((touches.x0 - grid.x0) / grid.dx),
               below = std::lround((touches.y0 - grid.y0) / grid.dy);
    for (std::size_t i = 0; i < h.size(); ++i) {
        const long ix = static_cast<long>(i) % grid.nx - left, iy = static_cast<long>(i) / grid.nx - below;
        if (ix < 0 || ix >= touches.nx || iy < 0 || iy >= touches.ny) h[i] = std::numeric_limits<double>::quiet_NaN();
    }
}

/// Converts distances to gaps; returns the approach.
double take_out_approach(std::vector<double>& h) {
    double least = std::numeric_limits<double>::infinity();
    for (const double distance : h)
        if (distance < least) least = distance;
    for (double& distance : h)
        distance = std::isfinite(distance) ? std::min(distance - least, out_of_reach) : out_of_reach;
    return -least;
}

ContactRadii radii_of(const WheelSurface& wheel, const RailSurface& rail, const ContactReference& reference) {
    const auto radius = [](double curvature) {
        return curvature == 0 ? std::numeric_limits<double>::infinity() : 1 / curvature;
    };
    double rail_s = 0.5 * (rail.visible().from + rail.visible().to);
    rail.find_y(reference.y, rail_s);
    const Vector3 inside = wheel.frame().inside({reference.x, reference.y, reference.z});
    const double wheel_s = wheel.profile().s_at_y(inside.y - wheel.base_y());
    const double upright = std::abs(std::cos(reference.angle));
    const double rail_curvature = rail.curvature_along(reference.x, reference.y, rail_s);
    return {wheel.radius_along(inside.x, wheel_s) / upright, radius(-wheel.profile().curvature(wheel_s)),
            radius(rail_curvature * upright), radius(rail.profile().curvature(rail_s))};
}

/// Counts the points of slices that are files, whose number is unknown before they are read.
class PointsOfFiles {
   public:
    explicit PointsOfFiles(const char* field) : field_(field) {}

    /// Throws InvalidArgument if there are too many.
    void add(const ProfileSpec& spec, const ProfileCurve& curve) {
        if (std::holds_alternative<ProfileFile>(spec.shape)) points_ += curve.points().size();
        if (points_ > most_points_of_slices)
            throw InvalidArgument(field_, "have more than " + std::to_string(most_points_of_slices) +
                                              " points together; omit some of them");
    }

   private:
    const char* field_;
    std::size_t points_ = 0;
};

/// Sets `mirrored` if all slices have their gauge side at y > 0; single ones may, such as noses and wings.
std::shared_ptr<const SlicedRail> sliced_rail(const WheelRailSetup& setup, bool& mirrored, const Observer& observer) {
    if (setup.rail_slices.empty()) return nullptr;
    std::vector<SlicedRail::Slice> slices;
    PointsOfFiles points("rail_slices");
    mirrored = true;
    for (std::size_t i = 0; i < setup.rail_slices.size(); ++i) {
        observer.throw_if_cancelled();
        const RailSlice& slice = setup.rail_slices[i];
        slices.push_back(
            {slice.x, curve_of(slice.profile, "rail_slices[" + std::to_string(i) + "].profile"), slice.features});
        points.add(slice.profile, slices.back().curve);
        mirrored = mirrored && has_gauge_side_at_right(slices.back().curve);
    }
    return std::make_shared<const SlicedRail>(slices, setup.rail_spline);
}

/// Returns the curves of the slices, or none for a round wheel.
std::vector<ProfileCurve> wheel_slices(const WheelRailSetup& setup, const Observer& observer) {
    std::vector<ProfileCurve> curves;
    PointsOfFiles points("wheel_slices");
    for (const WheelSlice& slice : setup.wheel_slices) {
        observer.throw_if_cancelled();
        curves.push_back(curve_of(slice.profile, "wheel_slices[" + std::to_string(curves.size()) + "].profile"));
        points.add(slice.profile, curves.back());
    }
    return curves;
}

std::shared_ptr<const OutOfRound> out_of_round(const WheelRailSetup& setup, const std::vector<ProfileCurve>& slices) {
    if (slices.empty()) return nullptr;
    std::vector<double> angles;
    for (const WheelSlice& slice : setup.wheel_slices) angles.push_back(slice.angle);
    return std::make_shared<const OutOfRound>(std::move(angles), slices, setup.wheel_spline);
}

/// Bodies touch where the stiffer one would be without the other: the share of a body is the compliance of the other.
double rail_share(const Bodies& bodies) {
    const MaterialPair both = bodies.materials();
    const double of_wheel = MaterialPair{Material::rigid(), both.lower}.normal_compliance();
    const double of_both = both.normal_compliance();
    return of_both > 0 ? of_wheel / of_both : 0.5;
}

RailSurface rail_surface(const WheelRailSetup& setup, const Profiles& profiles, const WheelRailState& state) {
    if (profiles.slices) return {profiles.slices, state.position.x, setup.track, profiles.rail_origin, state.rail};
    return {profiles.rail, setup.track, profiles.rail_origin, state.rail};
}

std::unique_ptr<OverlapSearch> search_of(const WheelRailSetup& setup, const WheelSurface& wheel,
                                         const RailSurface& rail, const Observer& observer) {
    const bool by_mesh = setup.patches.search == ContactSearch::mesh || !wheel.is_round();
    if (by_mesh && setup.wheel_surface == WheelSurfaceKind::bilinear)
        return std::make_unique<MeshSearch>(wheel, rail, search_nodes(wheel, setup.dx), 0.75 * setup.dy, observer);
    // Steps are in elements, as in reference programs, but limited (mm): contacts on flanks must not lie between nodes,
    // and a mesh must not have millions of them.
    if (by_mesh)
        return std::make_unique<MeshSearch>(wheel, rail, std::clamp(1.5 * setup.dx, 0.1, 0.75),
                                            std::clamp(0.75 * setup.dy, 0.05, 0.2), observer);
    const auto ends =
        setup.wheel_surface == WheelSurfaceKind::exact ? LocusSearch::Ends::exact : LocusSearch::Ends::straight;
    return std::make_unique<LocusSearch>(wheel, rail, setup.patches.locus_step * setup.dy, ends, observer);
}

}  // namespace

Profiles make_profiles(const WheelRailSetup& setup, const Observer& observer) {
    const std::vector<ProfileCurve> slices = wheel_slices(setup, observer);
    Profile wheel = slices.empty() ? profile_of(setup.wheel, "wheel") : Profile{ProfileKind::wheel, slices.front()};
    Profile rail = profile_of(setup.rail, "rail");
    check_fit(setup, wheel.curve, rail.curve);
    const ProfilePoint origin = rail_origin(rail.curve, setup.track);
    bool mirrored = false;
    auto sliced = sliced_rail(setup, mirrored, observer);
    if (sliced) rail.evidence.warnings.clear();
    if (mirrored) rail.evidence.warnings.push_back(gauge_side_warning("rail of rail_slices"));
    return {std::move(wheel.curve),
            std::move(rail.curve),
            origin,
            std::move(sliced),
            out_of_round(setup, slices),
            std::move(wheel.evidence.warnings),
            std::move(rail.evidence.warnings),
            slices.empty() ? wheel.evidence.wheel : wheel_landmarks(slices.front())};
}

Position::Position(const WheelRailSetup& setup, const Profiles& profiles, const WheelRailState& state,
                   const Observer& observer)
    : setup_(setup),
      state_(state),
      observer_(observer),
      wheel_(profiles.wheel, setup.wheelset, at_zero(state.position), state.wheel, profiles.out_of_round),
      rail_(rail_surface(setup, profiles, state)),
      search_(search_of(setup, wheel_, rail_, observer)) {}

std::vector<RegionGroup> Position::groups(double z, bool blends) const {
    observer_.throw_if_cancelled();
    return group_regions(search_->regions(z), setup_.patches, blends, rail_);
}

std::vector<CandidatePatch> Position::candidates(double z) const {
    const WheelSurface wheel = wheel_.lowered(z);
    std::vector<CandidatePatch> candidates;
    for (const RegionGroup& group : groups(z, has_distances(setup_)))
        candidates.push_back(candidate_of(group, wheel, z));
    return candidates;
}

double Position::expected_force(double z, double compliance) const {
    double force = 0;
    for (const RegionGroup& group : groups(z, false)) {
        const EquivalentEllipse ellipse = search_->ellipse(z, group);
        force += hertz_of_approach(ellipse.radii(), compliance, ellipse.approach).Fn * std::cos(group.reference.angle);
    }
    return force;
}

CandidatePatch Position::candidate_of(const RegionGroup& group, const WheelSurface& wheel, double z) const {
    CandidatePatch found;
    ContactPlace& place = found.place;
    place.reference = group.reference;
    place.regions = group.regions;
    place.shares = group.shares;
    for (const OverlapRegion& region : group.regions)
        place.penetration = std::max(place.penetration, region.penetration);
    find_elements(found);
    place.grid = found.needed = grid_of(group, rail_, setup_.dx, setup_.dy, found.middle, most_elements());
    place.radii = radii_of(wheel, rail_, place.reference);
    if (setup_.slope_forces != SlopeForces::none) found.slopes = rail_slopes(rail_, place.reference);
    if (has_distances(setup_)) {
        place.approach = place.penetration * std::abs(std::cos(place.reference.angle));
    } else {
        const EquivalentEllipse ellipse = search_->ellipse(z, group);
        found.paraboloid = ellipse.radii();
        place.approach = ellipse.approach;
        cover(place.grid, ellipse.along, ellipse.across);
    }
    take_creepages(found, wheel);
    found.quality = search_->quality_flags(z, group);
    if (setup_.conformal != Conformal::off && bend(found, wheel)) found.quality.bend = 0;
    return found;
}

void Position::take_creepages(CandidatePatch& found, const WheelSurface& wheel) const {
    ContactPlace& place = found.place;
    place.creepages = creepages(wheel, rail_, state_, place.reference, place.approach);
    found.rail_speed = rail_speed(wheel, rail_, state_, place.reference, place.approach);
}

/// Elements of a transient contact lie at multiples of their sizes along and across the rail, so that they do not move
/// with the reference. Those of steady rolling are not reused, and lie about the reference.
void Position::find_elements(CandidatePatch& found) const {
    const ContactReference& reference = found.place.reference;
    RailPlace& on_rail = found.place.on_rail;
    on_rail = {state_.position.x + reference.x, across_rail(rail_, reference.y)};
    if (state_.motion == WheelRailMotion::steady_rolling) return;
    found.counted_from = {-(state_.motion == WheelRailMotion::shift ? on_rail.along : reference.x), -on_rail.across};
    const auto next = [](double at, double size) { return size * std::ceil(at / size) - at; };
    found.middle = {next(state_.motion == WheelRailMotion::shift ? on_rail.along : reference.x, setup_.dx),
                    next(on_rail.across, setup_.dy)};
}

/// Elements of a transient contact are not doubled, because the tractions on them are kept.
int Position::most_elements() const {
    return state_.motion == WheelRailMotion::steady_rolling ? setup_.patches.max_elements : 0;
}

/// Makes the place a curved one if requested. Returns false if rail and wheel do not face each other there.
bool Position::bend(CandidatePatch& found, const WheelSurface& wheel) const {
    ContactPlace& place = found.place;
    Extent y = place.regions.front().y;
    for (const OverlapRegion& region : place.regions)
        y = {std::min(y.from, region.y.from), std::max(y.to, region.y.to)};
    CurvedRows curved = curved_rows(wheel, rail_, place.reference, y, place.grid.dy, found.middle.y, found.more_below,
                                    found.more_above);
    if (curved.rows.empty()) return false;
    place.rows = std::move(curved.rows);
    place.grid.ny = static_cast<int>(place.rows.size());
    place.grid.y0 = (curved.first - 0.5) * place.grid.dy + found.middle.y;
    found.row_on_rail = curved.on_rail;
    found.row_on_wheel = curved.on_wheel;
    return true;
}

void Position::widen(CandidatePatch& found, const Grid& grid, double z) const {
    const Grid before = found.place.grid;
    check_size(grid);
    found.place.grid = grid;
    if (found.place.rows.empty()) return;
    const int below = static_cast<int>(std::lround((before.y0 - grid.y0) / grid.dy));
    found.more_below += below;
    found.more_above += grid.ny - before.ny - below;
    bend(found, wheel_.lowered(z));
}

/// Returns the distance ahead at which solvers evaluate the spin of creepages (mm).
double Position::spin_ahead(const ContactPlace& place) const {
    if (state_.motion == WheelRailMotion::shift) return 0;
    const bool by_time = state_.motion == WheelRailMotion::transient_rolling && state_.time_step;
    const double step = by_time ? place.creepages.velocity * *state_.time_step : step_of_rolling(setup_, place.grid.dx);
    return spin_offset * step;
}

bool Position::measure(CandidatePatch& found, double z) const {
    if (!has_distances(setup_)) return std::isfinite(found.place.approach);
    constexpr int most_rounds = 50;
    const WheelSurface wheel = wheel_.lowered(z);
    ContactPlace& place = found.place;
    const bool flat = place.rows.empty();
    widen(found, convenient(place.grid, flat), z);
    SurfaceHeights heights;
    for (int round = 0; round < most_rounds; ++round) {
        observer_.throw_if_cancelled();
        heights = heights_of(setup_, wheel, rail_, found);
        found.gap = distances(rail_, place, heights);
        if (found.touches) keep_apart(place.grid, *found.touches, found.gap);
        place.approach = take_out_approach(found.gap);
        if (!std::isfinite(place.approach)) return false;
        Grid grid = place.grid;
        if (round + 1 == most_rounds || !grow(grid, found.gap, place.approach)) break;
        const Grid before = place.grid;
        widen(found, convenient(grid, flat), z);
        if (place.grid == before) break;  // There are no more rows.
    }
    if (rail_.varies() && setup_.slope_forces != SlopeForces::none)
        add_slopes_at_elements(found.slopes, place.grid, heights.rail);
    take_creepages(found, wheel);
    const bool by_elements = setup_.rigid_slip == RigidSlipKind::elements;
    if (!place.rows.empty() || by_elements) {
        auto [fitted, rest] =
            curved_slip(wheel, rail_, state_, place, heights, found.gap, rail_share(setup_.bodies), place.creepages,
                        by_elements ? SlipConvention{spin_ahead(place), true} : SlipConvention{});
        place.creepages = fitted;
        found.additional_slip = std::move(rest);
    } else if (setup_.rigid_slip == RigidSlipKind::surfaces) {
        found.row_slips = row_slips(wheel, rail_, state_, place.reference, place.creepages, place.grid);
    }
    return true;
}

}  // namespace contactd::geometry
