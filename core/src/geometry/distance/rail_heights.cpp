#include <cmath>

#include "geometry/distance/heights.hpp"
#include "geometry/placement/ascending_root.hpp"

namespace contactd::geometry {
namespace {

/// The profile at some x, in the coordinates of the contact.
class Section {
   public:
    Section(const RailSurface& rail, const ContactReference& reference)
        : rail_(rail), reference_(reference), cosine_(std::cos(reference.angle)), sine_(std::sin(reference.angle)) {
        s_ = 0.5 * (rail.visible().from + rail.visible().to);
        rail.find_y(reference.y, s_);
        span_ = ascending_span(rail.profile(), s_, [&](const ProfilePoint& point) {
            const Vector3 at = rail.frame().outside({0, point.y, point.z});
            return cosine_ * at.y + sine_ * at.z;
        });
    }

    double height(double x, double y) {
        Vector3 at;
        const bool found = find_ascending(
            [&](double s) {
                const auto place = rail_.place(s);
                at = {x, place.at.y - reference_.y, rail_.z_at(x, place.at.z) - reference_.z};
                return Sloped{cosine_ * at.y + sine_ * at.z,
                              cosine_ * place.slope.y + sine_ * rail_.z_slope_at(x, place.at.z) * place.slope.z};
            },
            y, span_.from, span_.to, s_);
        return found ? cosine_ * at.z - sine_ * at.y : no_height;
    }

   private:
    const RailSurface& rail_;
    const ContactReference& reference_;
    double cosine_, sine_, s_ = 0;
    Span span_;
};

}  // namespace

std::vector<double> rail_heights(const RailSurface& rail, const ContactReference& reference, const Grid& grid) {
    Section section(rail, reference);
    std::vector<double> heights;
    const int columns = rail.axle() ? grid.nx : 1;
    heights.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(grid.ny));
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < columns; ++ix)
            heights.push_back(section.height(reference.x + (rail.axle() ? grid.x(ix) : 0), grid.y(iy)));
    return heights;
}

}  // namespace contactd::geometry
