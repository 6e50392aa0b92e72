#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "geometry/distance/heights.hpp"
#include "geometry/placement/ascending_root.hpp"

namespace contactd::geometry {
namespace {

/// A profile of the rail, in the coordinates of the contact.
class Section {
   public:
    Section(const RailSurface& rail, ProfileCurve profile, const ContactReference& reference)
        : rail_(rail),
          profile_(std::move(profile)),
          reference_(reference),
          cosine_(std::cos(reference.angle)),
          sine_(std::sin(reference.angle)) {
        const Vector3 inside = rail.frame().inside({0, reference.y, reference.z});
        s_ = profile_.s_at_y(inside.y);
        span_ = ascending_span(profile_, s_, [&](const ProfilePoint& point) {
            const Vector3 at = rail.frame().outside({0, point.y, point.z});
            return cosine_ * at.y + sine_ * at.z;
        });
    }

    double height(double x, double y) {
        Vector3 at;
        const bool found = find_ascending(
            [&](double s) {
                const auto place = rail_.placed(profile_, s);
                at = {x, place.at.y - reference_.y, rail_.turned_z(x, place.at.z) - reference_.z};
                return Sloped{cosine_ * at.y + sine_ * at.z,
                              cosine_ * place.slope.y + sine_ * rail_.turned_slope(x, place.at.z) * place.slope.z};
            },
            y, span_.from, span_.to, s_);
        return found ? cosine_ * at.z - sine_ * at.y : no_height;
    }

   private:
    const RailSurface& rail_;
    const ProfileCurve profile_;
    const ContactReference& reference_;
    double cosine_, sine_, s_ = 0;
    Span span_;
};

}  // namespace

std::vector<double> rail_heights(const RailSurface& rail, const ContactReference& reference,
                                 const PlanePoints& points) {
    const auto nx = static_cast<std::size_t>(rail.varies() ? points.nx() : 1), ny = points.rows.size();
    std::vector<double> heights(nx * ny);
    std::optional<Section> section;
    for (std::size_t ix = 0; ix < nx; ++ix) {
        const double x = reference.x + points.x(static_cast<int>(ix));
        if (!section || rail.is_sliced()) section.emplace(rail, rail.section(x), reference);
        for (std::size_t iy = 0; iy < ny; ++iy) heights[iy * nx + ix] = section->height(x, points.rows[iy]);
    }
    return heights;
}

}  // namespace contactd::geometry
