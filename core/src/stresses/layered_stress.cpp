#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/subsurface.hpp"
#include "layered_element.hpp"
#include "stress_arrays.hpp"
#include "subsurface_direct.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

/// Forwards cancellation, but no progress.
class Silent final : public Observer {
   public:
    explicit Silent(const Observer& observer) : observer_(observer) {}
    bool cancelled() const override { return observer_.cancelled(); }

   private:
    const Observer& observer_;
};

struct Place {
    double x, y;
    std::size_t index;  // index in the result
};

/// Holds points at one depth that differ by whole elements, counted from the first loaded element.
struct Lattice {
    double fraction_x, fraction_y;
    using Point = Place;  // x and y are whole numbers of elements
    std::vector<Point> points;
};

class DepthStress {
   public:
    DepthStress(const LoadedPatch& patch, const StressWaves& waves, const std::vector<Place>& places)
        : patch_(patch), dx_(patch.loads()[0].dx), dy_(patch.loads()[0].dy), element_(waves, farthest(places)) {
        std::map<std::pair<double, double>, Lattice> lattices;
        for (const auto& [x, y, index] : places) {
            const double steps_x = steps(x, patch.x(), dx_), steps_y = steps(y, patch.y(), dy_);
            const double whole_x = std::floor(steps_x), whole_y = std::floor(steps_y);
            const double of_x = steps_x - whole_x, of_y = steps_y - whole_y;
            Lattice& lattice = lattices.try_emplace({of_x, of_y}, Lattice{of_x, of_y, {}}).first->second;
            lattice.points.push_back({whole_x, whole_y, index});
        }
        for (auto& [key, lattice] : lattices) lattices_.push_back(std::move(lattice));
    }

    void add_to(SubsurfaceStress& result, const Observer& observer) const {
        for (const Lattice& lattice : lattices_) {
            observer.throw_if_cancelled();
            if (shares(lattice)) {
                add(lattice, result, observer);
                continue;
            }
            for (const Lattice::Point& point : lattice.points)
                add({lattice.fraction_x, lattice.fraction_y, {point}}, result, observer);
        }
    }

   private:
    struct Span {
        double first, last;
        double count() const { return last - first + 1; }
    };

    static double steps(double coordinate, double first, double size) {
        constexpr double resolution = 0x1p-40;  // above rounding errors, and exact for halves of elements
        return std::round((coordinate - first) / size / resolution) * resolution;
    }
    double farthest(const std::vector<Place>& places) const {
        double most = 0;
        for (const auto& [x, y, index] : places) {
            const double along_x = std::abs(x - patch_.x()) + (patch_.nx() + 1) * dx_;
            const double along_y = std::abs(y - patch_.y()) + (patch_.ny() + 1) * dy_;
            most = std::max(most, std::hypot(along_x, along_y));
        }
        return most;
    }
    static Span span(const Lattice& lattice, double Lattice::Point::* coordinate) {
        const auto [least, most] =
            std::minmax_element(lattice.points.begin(), lattice.points.end(),
                                [coordinate](const auto& a, const auto& b) { return a.*coordinate < b.*coordinate; });
        return {(*least).*coordinate, (*most).*coordinate};
    }
    /// Returns whether there are fewer offsets between all points and elements than pairs of them, and no more than in
    /// a raster of the largest grid.
    bool shares(const Lattice& lattice) const {
        const double offsets = (span(lattice, &Lattice::Point::x).count() + patch_.nx()) *
                               (span(lattice, &Lattice::Point::y).count() + patch_.ny());
        const double pairs = static_cast<double>(lattice.points.size()) * patch_.nx() * patch_.ny();
        return offsets <= 4.0 * std::min(pairs, static_cast<double>(max_grid_elements));
    }
    void add(const Lattice& lattice, SubsurfaceStress& result, const Observer& observer) const {
        const Span x = span(lattice, &Lattice::Point::x), y = span(lattice, &Lattice::Point::y);
        const int nx = patch_.nx(), ny = patch_.ny();
        const OffsetLattice offsets{(x.first - (nx - 1) + lattice.fraction_x) * dx_,
                                    (y.first - (ny - 1) + lattice.fraction_y) * dy_,
                                    static_cast<int>(x.count()) + nx - 1,
                                    static_cast<int>(y.count()) + ny - 1,
                                    dx_,
                                    dy_};
        const std::vector<ElementStresses> coefficients = element_.at(offsets, observer);
        const auto components = components_of(result);
        for (const Lattice::Point& point : lattice.points) {
            observer.throw_if_cancelled();
            const int k = static_cast<int>(point.x - x.first) + nx - 1,
                      l = static_cast<int>(point.y - y.first) + ny - 1;
            StressComponents sum{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::vector<double>& values = patch_.loads()[axis].values;
                for (std::size_t e = 0; e < values.size(); ++e) {
                    const int ix = static_cast<int>(e) % nx, iy = static_cast<int>(e) / nx;
                    const StressComponents& unit = coefficients[offsets.index(k - ix, l - iy)][axis];
                    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += values[e] * unit[c];
                }
            }
            for (std::size_t c = 0; c < sum.size(); ++c) (*components[c])[point.index] += sum[c];
        }
    }

    const LoadedPatch& patch_;
    const double dx_, dy_;
    LayeredElement element_;
    std::vector<Lattice> lattices_;
};

/// Converts the half-space's stresses at the points to those in layers.
SubsurfaceStress in_layers(const Grid& grid, const SurfaceTractions& tractions, const Layers& body,
                           SubsurfaceStress result, const std::map<double, std::vector<Place>>& depths,
                           const char* field, Observer& observer) {
    validate(body, grid.dx, "ics");
    double bottom = 0;
    for (const Layer& layer : body.layers) bottom += layer.thickness;
    if (const double deepest = depths.rbegin()->first; body.base.is_rigid() && deepest > bottom)
        throw InvalidArgument(field, "contains z = " + number_text(-deepest) +
                                         ", but the layers end at z = " + number_text(-bottom) + ", on a rigid base");
    const LoadedPatch patch(grid, tractions);
    const bool loaded = patch.nx() > 0;
    double done = 0;
    for (const auto& [depth, places] : depths) {
        const StressWaves waves(body, depth);
        if (!waves.in_first_layer())
            for (std::vector<double>* values : components_of(result))
                for (const Place& place : places) (*values)[place.index] = 0;
        if (loaded) DepthStress(patch, waves, places).add_to(result, observer);
        observer.on_progress({"subsurface", ++done / static_cast<double>(depths.size())});
    }
    find_von_mises(result);
    return result;
}

}  // namespace

SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, const Layers& body,
                                   std::span<const std::array<double, 3>> points, Observer& observer) {
    Silent silent(observer);
    SubsurfaceStress half_space = subsurface_stress(grid, tractions, body.surface().nu, points, silent);
    std::map<double, std::vector<Place>> depths;
    for (std::size_t i = 0; i < points.size(); ++i)
        depths[std::abs(points[i][2])].push_back({points[i][0], points[i][1], i});
    return in_layers(grid, tractions, body, std::move(half_space), depths, "points", observer);
}

SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, const Layers& body,
                                   const StressBlock& block, Observer& observer) {
    Silent silent(observer);
    SubsurfaceStress half_space = subsurface_stress(grid, tractions, body.surface().nu, block, silent);
    std::map<double, std::vector<Place>> depths;
    std::size_t index = 0;
    for (const double z : block.z)
        for (const double y : block.y)
            for (const double x : block.x) depths[std::abs(z)].push_back({x, y, index++});
    return in_layers(grid, tractions, body, std::move(half_space), depths, "block.z", observer);
}

}  // namespace contactd
