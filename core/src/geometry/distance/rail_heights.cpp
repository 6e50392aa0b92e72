#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/distance/heights.hpp"
#include "geometry/distance/row_nodes.hpp"
#include "geometry/placement/ascending_root.hpp"

namespace contactd::geometry {
namespace {

/// Represents a profile of the rail in the coordinates of the contact.
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
                const auto place = rail_.rotated_to(x, rail_.placed(profile_, s));
                at = {x, place.at.y - reference_.y, place.at.z - reference_.z};
                return Sloped{cosine_ * at.y + sine_ * at.z, cosine_ * place.slope.y + sine_ * place.slope.z};
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

/// Computes columns of a rail from slice to slice.
class RailFromSlices {
   public:
    RailFromSlices(const RailSurface& rail, const ContactReference& reference, const PlanePoints& points)
        : rail_(rail), reference_(reference), points_(points) {}

    std::vector<double> heights() {
        const int nx = points_.nx();
        heights_.resize(static_cast<std::size_t>(nx) * points_.rows.size());
        for (int first = 0; first < nx;) {
            const double next_slice = rail_.next_slice(x(first));
            int end = first + 1;
            while (end < nx && x(end) <= next_slice) ++end;
            if (end - first < worthwhile || !by_nodes(first, end - first))
                for (int ix = first; ix < end; ++ix) set(ix, column(x(ix)));
            first = end;
        }
        return std::move(heights_);
    }

   private:
    static constexpr int worthwhile = 12;     // columns between two slices
    static constexpr double settled = 1e-10;  // mm

    double x(int ix) const { return reference_.x + points_.x(ix); }
    std::vector<double> column(double x) const {
        Section section(rail_, rail_.section(x), reference_);
        std::vector<double> heights;
        for (const double y : points_.rows) heights.push_back(section.height(x, y));
        return heights;
    }
    void set(int ix, const std::vector<double>& column) {
        for (std::size_t iy = 0; iy < column.size(); ++iy)
            heights_[iy * static_cast<std::size_t>(points_.nx()) + static_cast<std::size_t>(ix)] = column[iy];
    }
    /// Computes columns from a few of them, because profiles are expensive. Returns false if these are not sufficient
    /// between slices.
    bool by_nodes(int first, int count) {
        const RowNodes nodes(x(first), points_.columns.dx, count);
        std::vector<std::vector<double>> columns;
        for (const double x_of_node : nodes.x()) columns.push_back(column(x_of_node));
        std::vector<std::vector<double>> rows;
        for (std::size_t iy = 0; iy < points_.rows.size(); ++iy) {
            RowNodes::Values values;
            for (std::size_t j = 0; j < RowNodes::count; ++j) values[j] = columns[j][iy];
            if (!RowNodes::smooth(values, settled)) return false;
            nodes.interpolate(values, rows.emplace_back());
        }
        for (std::size_t iy = 0; iy < rows.size(); ++iy)
            std::copy(rows[iy].begin(), rows[iy].end(),
                      heights_.begin() + static_cast<std::ptrdiff_t>(iy) * points_.nx() + first);
        return true;
    }

    const RailSurface& rail_;
    const ContactReference& reference_;
    const PlanePoints& points_;
    std::vector<double> heights_;
};

}  // namespace

std::vector<double> rail_heights(const RailSurface& rail, const ContactReference& reference,
                                 const PlanePoints& points) {
    if (rail.is_sliced()) return RailFromSlices(rail, reference, points).heights();
    const auto nx = static_cast<std::size_t>(rail.varies() ? points.nx() : 1), ny = points.rows.size();
    std::vector<double> heights(nx * ny);
    Section section(rail, rail.profile(), reference);
    for (std::size_t ix = 0; ix < nx; ++ix) {
        const double x = reference.x + points.x(static_cast<int>(ix));
        for (std::size_t iy = 0; iy < ny; ++iy) heights[iy * nx + ix] = section.height(x, points.rows[iy]);
    }
    return heights;
}

}  // namespace contactd::geometry
