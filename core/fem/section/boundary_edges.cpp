#include "boundary_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "contactd/count_of.hpp"

namespace contactd::fem {
namespace {

constexpr double largest_turn = std::numbers::pi / 12;
/// The number of edges of a stretch is summed over these sub-steps.
constexpr int steps = 400;

double distance(const PlanePoint& a, const PlanePoint& b) {
    return std::hypot(a.y - b.y, a.z - b.z);
}

/// Between two of these positions the outline is smooth, and is wholly inside or outside strips and clamped parts.
struct Stretch {
    std::size_t loop, piece;
    double from, to;
    int strip;
};

struct Fine {
    PlanePoint at;
    double size, growth;
};

std::vector<Stretch> stretches(const SectionOutline& outline) {
    std::vector<Stretch> result;
    const double length = length_of(outline.loops[outline.carrier]);
    // Returns the ends of strips along their loop, in [0, length).
    std::vector<double> ends;
    for (int i = 0; i <= outline.strips; ++i) {
        const double s = outline.first_strip + i;
        ends.push_back(s - length * std::floor(s / length));
    }
    double begin = 0;
    for (std::size_t loop = 0; loop < outline.loops.size(); ++loop) {
        begin = 0;
        for (std::size_t piece = 0; piece < outline.loops[loop].size(); ++piece) {
            const double piece_length = outline.loops[loop][piece].length,
                         rounding = 1e-7 * std::min(1.0, piece_length);
            std::vector<double> cuts{0, piece_length};
            if (loop == outline.carrier)
                for (const double end : ends)
                    if (end - begin > rounding && end - begin < piece_length - rounding) cuts.push_back(end - begin);
            std::ranges::sort(cuts);
            for (std::size_t cut = 0; cut + 1 < cuts.size(); ++cut) {
                if (cut > 0 && cuts[cut + 1] - cuts[cut] < rounding) continue;
                double at = begin + (cuts[cut] + cuts[cut + 1]) / 2 - outline.first_strip;
                at -= length * std::floor(at / length);
                const bool on_strips = loop == outline.carrier && at < outline.strips;
                result.push_back(
                    {loop, piece, cuts[cut], cuts[cut + 1], on_strips ? static_cast<int>(std::floor(at)) : -1});
            }
            begin += piece_length;
        }
    }
    return result;
}

double turn_rate(const OutlinePiece& piece, double s) {
    const double step = 1e-4 * piece.length, from = std::max(0.0, s - step), to = std::min(piece.length, s + step);
    const PlanePoint a = piece.normal(from), b = piece.normal(to);
    return std::abs(std::atan2(a.y * b.z - a.z * b.y, a.y * b.y + a.z * b.z)) / (to - from);
}

/// Returns the corners where stresses are singular.
std::vector<PlanePoint> singular_corners(const SectionOutline& outline) {
    constexpr double straight_enough = 0.02;
    std::vector<PlanePoint> result;
    for (const OutlineLoop& loop : outline.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const OutlinePiece &before = loop[i], &after = loop[(i + 1) % loop.size()];
            const PlanePoint a = before.normal(before.length), b = after.normal(0);
            // Is positive where the outline turns left, away from the body.
            const double turn = std::atan2(a.y * b.z - a.z * b.y, a.y * b.y + a.z * b.z);
            if (turn > straight_enough || before.clamped != after.clamped) result.push_back(after.point(0));
        }
    return result;
}

class Division {
   public:
    Division(const SectionOutline& outline, const MeshDensity& density)
        : outline_(outline), density_(density), stretches_(stretches(outline)) {
        sample();
        for (int i = 0; i <= 2 * outline.strips; ++i)
            strips_.push_back(point_at(outline, position_at(outline, outline.carrier, outline.first_strip + 0.5 * i)));
        for (const PlanePoint& at : strips_) fine_.push_back({at, 1.0 / density.edges_a_strip, density.growth});
        const double growth = std::min(density.growth, 0.35);
        for (const PlanePoint& corner : singular_corners(outline))
            fine_.push_back({corner, std::max(density.corner_share * from_strips(corner), 1e-3), growth});
    }

    DividedOutline divide() const {
        DividedOutline result;
        result.extent = extent_;
        std::size_t loop = outline_.loops.size();
        for (const Stretch& stretch : stretches_) {
            if (stretch.loop != loop) {
                close(result);
                result.loop_begin.push_back(static_cast<int>(result.edges.size()));
                loop = stretch.loop;
            }
            const std::vector<double> cuts = cuts_of(stretch);
            const OutlinePiece& piece = outline_.loops[stretch.loop][stretch.piece];
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
                const int vertex = static_cast<int>(result.vertices.size());
                result.vertices.push_back(piece.point(cuts[i]));
                result.edges.push_back({stretch.loop, stretch.piece, cuts[i], cuts[i + 1], stretch.strip, piece.clamped,
                                        vertex, vertex + 1});
            }
        }
        close(result);
        result.loop_begin.push_back(static_cast<int>(result.edges.size()));
        return result;
    }

   private:
    static void close(DividedOutline& result) {
        if (!result.edges.empty()) result.edges.back().second = result.edges[result.loop_begin.back()].first;
    }

    /// Returns points along the outline, to estimate its extent and the thickness of the body.
    void sample() {
        for (const Stretch& stretch : stretches_) {
            if (stretch.strip >= 0) continue;
            constexpr int count = 40;
            const OutlinePiece& piece = outline_.loops[stretch.loop][stretch.piece];
            for (int i = 0; i < count; ++i) {
                const double a = stretch.from + (stretch.to - stretch.from) * i / count,
                             b = stretch.from + (stretch.to - stretch.from) * (i + 1) / count;
                walls_.push_back({piece.point(a), piece.point(b)});
            }
        }
        if (outline_.strips > 0)
            for (int i = 0; i < outline_.strips; ++i)
                walls_.push_back(
                    {point_at(outline_, position_at(outline_, outline_.carrier, outline_.first_strip + i)),
                     point_at(outline_, position_at(outline_, outline_.carrier, outline_.first_strip + i + 1))});
        PlanePoint low = walls_.front()[0], high = low;
        for (const auto& wall : walls_) {
            low = {std::min(low.y, wall[0].y), std::min(low.z, wall[0].z)};
            high = {std::max(high.y, wall[0].y), std::max(high.z, wall[0].z)};
        }
        extent_ = std::max(high.y - low.y, high.z - low.z);
    }

    double from_strips(const PlanePoint& at) const {
        double least = extent_;
        for (const PlanePoint& strip : strips_) least = std::min(least, distance(at, strip));
        return least;
    }

    /// Returns the distance along the inward normal to the next wall.
    double thickness(const PlanePoint& at, const PlanePoint& normal) const {
        double least = extent_;
        for (const auto& wall : walls_) {
            const PlanePoint along{wall[1].y - wall[0].y, wall[1].z - wall[0].z};
            const PlanePoint to{wall[0].y - at.y, wall[0].z - at.z};
            // at - t normal = wall[0] + r along
            const double across = along.y * normal.z - along.z * normal.y;
            if (std::abs(across) < 1e-12 * distance(wall[0], wall[1])) continue;
            const double t = (to.z * along.y - to.y * along.z) / -across,
                         r = (to.y * normal.z - to.z * normal.y) / -across;
            if (r >= 0 && r <= 1 && t > 1e-6 * extent_) least = std::min(least, t);
        }
        return least;
    }

    /// Returns the number of edges per length at `s` of a piece.
    double edges_a_length(const OutlinePiece& piece, double s) const {
        const PlanePoint at = piece.point(s);
        double size = extent_ / density_.edges_a_body;
        for (const Fine& fine : fine_) size = std::min(size, fine.size + fine.growth * distance(at, fine.at));
        // Where a layer is thin compared with its distance from the strips, displacements are small.
        constexpr double slow_growth = 0.1;
        if (const double wall = std::max(thickness(at, piece.normal(s)), slow_growth * from_strips(at)); wall < size)
            size = wall;
        return std::max(1 / size, turn_rate(piece, s) / largest_turn);
    }

    std::vector<double> cuts_of(const Stretch& stretch) const {
        const OutlinePiece& piece = outline_.loops[stretch.loop][stretch.piece];
        const double length = stretch.to - stretch.from;
        std::vector<double> cuts;
        if (stretch.strip >= 0) {
            const double by_turn = length * turn_rate(piece, stretch.from + length / 2) / largest_turn;
            const int count = std::max(
                1,
                count_of(std::max(0.0, std::ceil(std::max(length * density_.edges_a_strip, by_turn) - 1e-6)),
                         {"ics.section", "turns too much within a strip", "edges of elements", "use narrower strips"}));
            for (int i = 0; i <= count; ++i) cuts.push_back(stretch.from + length * i / count);
            return cuts;
        }
        // Uses small steps at both ends, where sizes may be small: s = from + length (3 t^2 - 2 t^3).
        const auto place = [&](int step) {
            const double t = static_cast<double>(step) / steps;
            return stretch.from + length * t * t * (3 - 2 * t);
        };
        std::vector<double> sum{0};
        for (int step = 0; step < steps; ++step)
            sum.push_back(sum.back() +
                          edges_a_length(piece, (place(step) + place(step + 1)) / 2) * (place(step + 1) - place(step)));
        const int count =
            std::max(1, count_of(std::max(0.0, std::ceil(sum.back() - 1e-6)),
                                 {"ics.section", "has an outline that is too thin or too long for its strips",
                                  "edges of elements", "use wider strips, or a thicker section"}));
        int step = 0;
        for (int i = 0; i < count; ++i) {
            const double target = sum.back() * i / count;
            while (step + 1 < steps && sum[step + 1] <= target) ++step;
            const double share = (target - sum[step]) / (sum[step + 1] - sum[step]);
            cuts.push_back(place(step) + share * (place(step + 1) - place(step)));
        }
        cuts.push_back(stretch.to);
        return cuts;
    }

    const SectionOutline& outline_;
    const MeshDensity& density_;
    std::vector<Stretch> stretches_;
    std::vector<std::array<PlanePoint, 2>> walls_;
    std::vector<PlanePoint> strips_;
    std::vector<Fine> fine_;
    double extent_ = 0;
};

}  // namespace

DividedOutline divide(const SectionOutline& outline, const MeshDensity& density) {
    return Division(outline, density).divide();
}

SizeField::SizeField(const DividedOutline& outline, const MeshDensity& density)
    : growth_(density.growth), largest_(outline.extent / density.edges_a_body) {
    for (const BoundaryEdge& edge : outline.edges) {
        const PlanePoint &a = outline.vertices[edge.first], &b = outline.vertices[edge.second];
        sources_.push_back({{(a.y + b.y) / 2, (a.z + b.z) / 2}, distance(a, b)});
    }
}

double SizeField::operator()(const PlanePoint& at) const {
    double size = largest_;
    for (const Source& source : sources_) {
        // Computes the distance only where it can affect the size.
        const double room = (size - source.size) / growth_;
        if (room <= 0) continue;
        const double dy = at.y - source.at.y, dz = at.z - source.at.z, squared = dy * dy + dz * dz;
        if (squared < room * room) size = source.size + growth_ * std::sqrt(squared);
    }
    return size;
}

}  // namespace contactd::fem
