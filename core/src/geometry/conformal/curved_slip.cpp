#include "geometry/conformal/curved_slip.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "geometry/conformal/curved_rows.hpp"
#include "geometry/distance/heights.hpp"
#include "geometry/motion/creepages.hpp"
#include "geometry/motion/surface_motion.hpp"

namespace contactd::geometry {
namespace {

struct Slip {
    double along = 0, across = 0;
};

/// Represents both surfaces, at points that face each other.
class FacingSurfaces {
   public:
    /// `along_track` is the speed at which the contact moves. Relative to it both surfaces pass through the contact,
    /// and lean; it is absent if they do not lean.
    FacingSurfaces(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state, double rail_share,
                   double velocity, std::optional<double> along_track)
        : wheel_(wheel),
          rail_(rail),
          state_(state),
          rail_share_(rail_share),
          velocity_(velocity),
          along_track_(along_track) {}

    Slip slip(const Vector3& on_rail, const Vector3& on_wheel, double angle) const {
        const Vector3 ground = of_rail(rail_, state_, on_rail).velocity;
        const Vector3 rim = of_wheel(wheel_, state_, on_wheel).velocity;
        const Rotation axes = Rotation::roll(angle);
        const Vector3 over = ground - rim;
        const double across = dot(over, axes.y) / velocity_;
        if (!along_track_) return {over.x / velocity_, across};
        const Vector3 moving{*along_track_, 0, 0};
        const Vector3 through = rail_share_ * (ground - moving) + (1 - rail_share_) * (rim - moving);
        const double x = through.x, n = dot(through, axes.z), length = std::hypot(x, n);
        const double lean_x = length > 0 ? std::abs(x) / length : 1;
        const double lean_n = length > 0 ? std::copysign(n, x * n) / length : 0;
        return {(over.x * lean_x + dot(over, axes.z) * lean_n) / velocity_, across};
    }

   private:
    const WheelSurface& wheel_;
    const RailSurface& rail_;
    const WheelRailState& state_;
    double rail_share_, velocity_;
    std::optional<double> along_track_;
};

/// Fits w_x = xi - phi y, w_y = eta + phi x.
class CreepageFit {
   public:
    void add(double x, double y, const Slip& slip) {
        ++count_;
        x_ += x;
        y_ += y;
        along_ += slip.along;
        across_ += slip.across;
        moment_ += x * slip.across - y * slip.along;
        squares_ += x * x + y * y;
    }
    void find(Creepages& creepages) const {
        if (count_ == 0) return;
        const double spread = squares_ - (x_ * x_ + y_ * y_) / count_;
        creepages.phi = spread > 0 ? (moment_ - (x_ * across_ - y_ * along_) / count_) / spread : 0;
        creepages.xi = (along_ + creepages.phi * y_) / count_;
        creepages.eta = (across_ - creepages.phi * x_) / count_;
    }

   private:
    double count_ = 0, x_ = 0, y_ = 0, along_ = 0, across_ = 0, moment_ = 0, squares_ = 0;
};

}  // namespace

CurvedSlip curved_slip(const WheelSurface& wheel, const RailSurface& rail, const WheelRailState& state,
                       const ContactPlace& place, const SurfaceHeights& heights, const std::vector<double>& gap,
                       double rail_share, const Creepages& from, const SlipConvention& convention) {
    const Grid& grid = place.grid;
    CurvedSlip result{from, {std::vector<double>(grid.size()), std::vector<double>(grid.size())}};
    if (!(from.velocity > 0)) return result;
    const bool rolls = state.motion != WheelRailMotion::shift;
    if (rolls && !rail.axle() && state.velocity.x != 0) result.creepages.velocity = std::abs(state.velocity.x);
    const bool curved = !place.rows.empty();
    const PlanePoints points =
        curved ? PlanePoints(grid, CurvedRows{.rows = place.rows}.in_plane(place.reference)) : PlanePoints(grid);
    const auto& [of_rail_surface, of_wheel_surface] = heights;
    // The contact moves along a rail, but stays on a roller.
    std::optional<double> along_track;
    if (rolls) along_track = rail.axle() ? 0 : state.velocity.x;
    if (!rolls && convention.leans_in_shifts) along_track = result.creepages.velocity;
    const FacingSurfaces surfaces(wheel, rail, state, rail_share, result.creepages.velocity, along_track);
    const Frame contact = contact_frame(place.reference);
    const double ahead = convention.spin_ahead * std::cos(from.chi);
    CreepageFit fit;
    std::vector<Slip> slips(grid.size());
    std::vector<bool> known(grid.size());
    std::size_t i = 0;
    for (std::size_t row = 0; row < points.rows.size(); ++row) {
        const double angle = curved ? place.rows[row].angle : place.reference.angle;
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            const double rail_height = of_rail_surface[rail.varies() ? i : row], wheel_height = of_wheel_surface[i];
            known[i] = std::isfinite(rail_height) && std::isfinite(wheel_height);
            if (!known[i]) continue;
            const auto in_track = [&](double height) {
                return contact.outside({grid.x(ix), points.rows[row], height});
            };
            slips[i] = surfaces.slip(in_track(rail_height), in_track(wheel_height), angle);
            if (gap[i] < place.approach) fit.add(grid.x(ix) + ahead, grid.y(static_cast<int>(row)), slips[i]);
        }
    }
    fit.find(result.creepages);
    if (!is_rolling(result.creepages)) return {{}, std::move(result.rest)};
    const auto& [xi, eta, phi, chi, velocity] = result.creepages;
    for (i = 0; i < slips.size(); ++i) {
        if (!known[i]) continue;
        const int ix = static_cast<int>(i) % grid.nx, iy = static_cast<int>(i) / grid.nx;
        result.rest.x[i] = slips[i].along - (xi - phi * grid.y(iy));
        result.rest.y[i] = slips[i].across - (eta + phi * (grid.x(ix) + ahead));
    }
    return result;
}

}  // namespace contactd::geometry
