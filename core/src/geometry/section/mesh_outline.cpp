#include "geometry/section/mesh_outline.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::geometry {
namespace {

// Divides one curve.
class Division {
   public:
    Division(const SectionGeometry& section, std::size_t curve, const MeshSizes& sizes, const EdgeLengths& lengths)
        : section_(section),
          curve_(section.curves()[curve]),
          carries_(curve == section.carrier_index()),
          sizes_(sizes),
          lengths_(lengths) {}

    OutlineLoop edges() const {
        OutlineLoop loop;
        const auto stops = this->stops();
        for (std::size_t i = 0; i + 1 < stops.size(); ++i) add(stops[i], stops[i + 1], loop);
        return loop;
    }

   private:
    // Arc lengths of vertices that must be, from 0 to the length. Ends and midpoints of columns go before joints that
    // they all but coincide with.
    std::vector<double> stops() const {
        std::vector<double> stops;
        const double near = 1e-6 * section_.ds(), length = curve_.length();
        if (carries_)
            for (int half = 0; half <= 2 * section_.columns(); ++half)
                stops.push_back(curve_.reduced(section_.begin_of(0) + half * section_.ds() / 2));
        const std::size_t first_joint = stops.size();
        for (std::size_t i = 0; i <= curve_.pieces().size(); ++i) {
            const double joint = curve_.begin_of(i);
            const bool taken = std::any_of(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(first_joint),
                                           [&](double stop) { return std::abs(stop - joint) < near; });
            if (!taken || i == 0 || i == curve_.pieces().size()) stops.push_back(joint);
        }
        std::sort(stops.begin(), stops.end());
        std::vector<double> apart{0};
        for (const double stop : stops)
            if (stop > apart.back() + near && stop < length - near) apart.push_back(stop);
        apart.push_back(length);
        return apart;
    }

    int column_at(double s) const {
        if (!carries_) return -1;
        const double along = curve_.reduced(s - section_.begin_of(0)) / section_.ds();
        return along < section_.columns() ? static_cast<int>(along) : -1;
    }

    void add(double begin, double end, OutlineLoop& loop) const {
        const double middle = (begin + end) / 2;
        const int column = column_at(middle);
        const bool held = curve_.pieces()[curve_.piece_at(middle)].held();
        const auto vertices = column < 0 ? graded(begin, end) : even(begin, end);
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
            loop.push_back({curve_.place(vertices[i]).at, vertices[i], vertices[i + 1], held, column});
    }

    std::vector<double> even(double begin, double end) const {
        const double edge = section_.ds() / sizes_.edges_per_column;
        const int n = std::max(1, static_cast<int>(std::ceil((end - begin) / edge - 1e-6)));
        std::vector<double> vertices;
        for (int i = 0; i < n; ++i) vertices.push_back(begin + i * (end - begin) / n);
        vertices.push_back(end);
        return vertices;
    }

    double edge_at(double s) const {
        const double shortest = 1e-6 * curve_.length();  // at a cusp of a spline
        const OutlinePlace here = curve_.place(s);
        return std::min(lengths_.at(here.at), std::max(sizes_.most_turn / std::abs(here.curvature), shortest));
    }

    // So that the integral of ds / edge is the same over all edges: first along steps that are small beside edges.
    std::vector<double> graded(double begin, double end) const {
        constexpr double small = 0.05;
        std::vector<double> places{begin}, sums{0};
        while (places.back() < end) {
            const double s = places.back();
            double step = small * edge_at(s);
            step = std::min({step, small * edge_at(std::min(s + step, end)) * 2, end - s});
            const double next = s + step > end - 1e-12 * curve_.length() ? end : s + step;
            sums.push_back(sums.back() + (next - s) / edge_at((s + next) / 2));
            places.push_back(next);
        }
        const int n = std::max(1, static_cast<int>(std::ceil(sums.back() - 0.2)));
        std::vector<double> vertices{begin};
        for (int i = 1; i < n; ++i) {
            const double wanted = i * sums.back() / n;
            const auto behind =
                static_cast<std::size_t>(std::lower_bound(sums.begin(), sums.end(), wanted) - sums.begin());
            const double share = (wanted - sums[behind - 1]) / (sums[behind] - sums[behind - 1]);
            vertices.push_back(places[behind - 1] + share * (places[behind] - places[behind - 1]));
        }
        vertices.push_back(end);
        return vertices;
    }

    const SectionGeometry& section_;
    const ClosedCurve& curve_;
    const bool carries_;
    const MeshSizes& sizes_;
    const EdgeLengths& lengths_;
};

}  // namespace

std::vector<OutlineLoop> mesh_outline(const SectionGeometry& section, const MeshSizes& sizes) {
    const EdgeLengths lengths(section, sizes);
    std::vector<OutlineLoop> loops;
    for (std::size_t curve = 0; curve < section.curves().size(); ++curve)
        loops.push_back(Division(section, curve, sizes, lengths).edges());
    return loops;
}

}  // namespace contactd::geometry
