#include "contactd/subsurface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "contact/support/solver_support.hpp"
#include "contactd/error.hpp"
#include "stress_arrays.hpp"
#include "subsurface_direct.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

/// Holds the components of a field, point by point.
template <class Field>
using Arrays = std::array<Values, components_of_field<Field>>;

template <class Field>
Arrays<Field> zeros(std::size_t n) {
    Arrays<Field> result;
    for (Values& values : result) values.resize(n);
    return result;
}

template <class Components, std::size_t n>
void store(const Components& components, std::size_t at, std::array<Values, n>& result) {
    for (std::size_t c = 0; c < n; ++c) result[c][at] = components[c];
}

SubsurfaceStress with_von_mises(Arrays<StressField>&& components) {
    SubsurfaceStress result;
    const auto to = components_of(result);
    for (std::size_t c = 0; c < components.size(); ++c) *to[c] = std::move(components[c]);
    result.von_mises.resize(result.xx.size());
    find_von_mises(result);
    return result;
}

void check(const Grid& grid, const SurfaceTractions& tractions, double nu) {
    validate(grid, "grid");
    if (!(nu >= 0 && nu <= 0.5)) throw InvalidArgument("nu", "is " + number_text(nu) + "; it must lie in [0, 0.5]");
    for (const auto& [values, field] : {std::pair{&tractions.x, "tractions.x"}, std::pair{&tractions.y, "tractions.y"},
                                        std::pair{&tractions.z, "tractions.z"}}) {
        if (!values->empty()) require_size(*values, grid.size(), field);
        for (const double value : *values)
            if (!std::isfinite(value))
                throw InvalidArgument(field, "contains " + number_text(value) + "; every value must be finite");
    }
}

void check_coordinate(double value, bool depth, const char* field) {
    constexpr double farthest = 1e50;  // Higher powers must be finite.
    if (!(std::abs(value) <= farthest))
        throw InvalidArgument(field, "contains " + number_text(value) +
                                         "; every coordinate must be finite and at most 1e50 in magnitude");
    if (depth && value > 0)
        throw InvalidArgument(
            field, "contains z = " + number_text(value) + "; points of the body have z <= 0 in its own frame");
}

// Reports the completed fraction of the work.
class Meter {
   public:
    Meter(Observer& observer, double work) : observer_(observer), work_(work) { observer.throw_if_cancelled(); }

    const Observer& observer() const { return observer_; }

    void add(double work) {
        done_ += work;
        if (done_ - reported_ < step && done_ < work_) return;
        reported_ = done_;
        observer_.on_progress({"subsurface", done_ < work_ ? done_ / work_ : 1});
        observer_.throw_if_cancelled();
    }

   private:
    static constexpr double step = 1e5;  // in corners, which take about ten milliseconds
    Observer& observer_;
    double work_, done_ = 0, reported_ = 0;
};

// Holds coordinates that differ from the centre of the first element by the same fraction of an element.
struct Class {
    double fraction;
    std::vector<double> whole;
    std::vector<std::size_t> place;  // in the block

    double first() const { return *std::min_element(whole.begin(), whole.end()); }
    double points() const { return *std::max_element(whole.begin(), whole.end()) - first() + 1; }
};

std::vector<Class> classes_of(const Values& coordinates, double first_centre, double size) {
    constexpr double resolution = 0x1p-40;  // above rounding errors, and exact for halves of elements
    std::map<double, Class> classes;        // sorted, so that sums are the same in every run
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const double steps = std::round((coordinates[i] - first_centre) / size / resolution) * resolution;
        const double whole = std::floor(steps), fraction = steps - whole;
        Class& found = classes.try_emplace(fraction, Class{fraction, {}, {}}).first->second;
        found.whole.push_back(whole);
        found.place.push_back(i);
    }
    std::vector<Class> result;
    for (auto& entry : classes) result.push_back(std::move(entry.second));
    return result;
}

// Computes the points of one class along x and one along y, at all depths, by convolution or by direct sums, whichever
// requires fewer corners.
class ClassPair {
   public:
    ClassPair(const LoadedPatch& patch, const Class& along_x, const Class& along_y, std::size_t corners)
        : patch_(patch), along_x_(along_x), along_y_(along_y), first_x_(along_x.first()), first_y_(along_y.first()) {
        // Transforms multiply the cost of the corners of a convolution by this factor.
        constexpr double transforms = 1.5;
        constexpr double farthest = 1e6;                          // in elements
        constexpr double most_offsets = 4.0 * max_grid_elements;  // between a raster of the largest grid and the grid
        // There may be at most this number of offsets for each element and point.
        constexpr double sparsest = 16;
        const bool far = std::max(std::abs(first_x_), std::abs(first_y_)) > farthest;
        const double offsets = (patch.nx() + along_x.points()) * (patch.ny() + along_y.points());
        const double points = static_cast<double>(along_x.whole.size()) * static_cast<double>(along_y.whole.size());
        const double elements = static_cast<double>(patch.nx()) * patch.ny();
        // The raster of a few points may exceed the memory.
        const bool fits = offsets <= std::min(most_offsets, sparsest * (elements + points));
        by_convolution_ = transforms * offsets;
        directly_ = points * static_cast<double>(corners);
        convolve_ = !far && fits && by_convolution_ < directly_;
    }

    double work() const { return convolve_ ? by_convolution_ : directly_; }

    template <class Field>
    void compute(const StressBlock& block, std::size_t iz, const DirectSum<Field>& direct, Meter& meter,
                 Arrays<Field>& result) const {
        const auto for_points = [&](const auto& field_at) {
            for (std::size_t j = 0; j < along_y_.place.size(); ++j)
                for (std::size_t i = 0; i < along_x_.place.size(); ++i)
                    store(field_at(i, j),
                          (iz * block.y.size() + along_y_.place[j]) * block.x.size() + along_x_.place[i], result);
        };
        if (!convolve_) {
            for_points([&](std::size_t i, std::size_t j) {
                meter.add(static_cast<double>(direct.corners()));
                return direct.at(block.x[along_x_.place[i]], block.y[along_y_.place[j]], block.z[iz]);
            });
            return;
        }
        const Raster raster{static_cast<int>(along_x_.points()), static_cast<int>(along_y_.points()),
                            first_x_ + along_x_.fraction, first_y_ + along_y_.fraction};
        Arrays<Field> sum = zeros<Field>(static_cast<std::size_t>(raster.nx) * raster.ny);
        for (const Axis load : {Axis::x, Axis::y, Axis::z}) {
            const TractionPatch& traction = patch_.loads()[static_cast<std::size_t>(load)];
            if (!traction.values.empty())
                add_field(direct.field(), load, traction, raster, -block.z[iz], sum, meter.observer());
        }
        for_points([&](std::size_t i, std::size_t j) {
            const auto at =
                static_cast<std::size_t>((along_y_.whole[j] - first_y_) * raster.nx + along_x_.whole[i] - first_x_);
            typename Field::Components components;
            for (std::size_t c = 0; c < sum.size(); ++c) components[c] = sum[c][at];
            return components;
        });
        meter.add(by_convolution_);
    }

   private:
    const LoadedPatch& patch_;
    const Class &along_x_, &along_y_;
    double first_x_, first_y_, by_convolution_, directly_;
    bool convolve_;
};

void check_is_one_row(const Grid& grid) {
    if (grid.ny != 1)
        throw InvalidArgument("grid.ny", "is " + std::to_string(grid.ny) +
                                             "; a line contact has one row of elements, which is infinite along y");
}

template <class Field>
Arrays<Field> at_points(const LoadedPatch& patch, double nu, std::span<const std::array<double, 3>> points,
                        Observer& observer) {
    if (points.empty()) throw InvalidArgument("points", "is empty; give at least one");
    for (const auto& [x, y, z] : points) {
        check_coordinate(x, false, "points");
        check_coordinate(y, false, "points");
        check_coordinate(z, true, "points");
    }
    const DirectSum direct(Field{nu, patch.smallest()}, patch);
    const double work = static_cast<double>(direct.corners());
    Meter meter(observer, work * static_cast<double>(points.size()));
    Arrays<Field> result = zeros<Field>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        store(direct.at(points[i][0], points[i][1], points[i][2]), i, result);
        meter.add(work);
    }
    return result;
}

void check(const StressBlock& block) {
    for (const auto& [values, field] :
         {std::pair{&block.x, "block.x"}, std::pair{&block.y, "block.y"}, std::pair{&block.z, "block.z"}}) {
        if (values->empty()) throw InvalidArgument(field, "is empty; give at least one coordinate");
        for (const double value : *values) check_coordinate(value, values == &block.z, field);
    }
}

template <class Field>
Arrays<Field> on_block(const Grid& grid, const LoadedPatch& patch, double nu, const StressBlock& block,
                       Observer& observer) {
    const DirectSum direct(Field{nu, patch.smallest()}, patch);
    const auto along_x = classes_of(block.x, patch.x(), grid.dx), along_y = classes_of(block.y, patch.y(), grid.dy);
    std::vector<ClassPair> pairs;
    double work = 0;
    for (const Class& of_y : along_y)
        for (const Class& of_x : along_x) work += pairs.emplace_back(patch, of_x, of_y, direct.corners()).work();
    Meter meter(observer, work * static_cast<double>(block.z.size()));
    Arrays<Field> result = zeros<Field>(block.size());
    for (std::size_t iz = 0; iz < block.z.size(); ++iz)
        for (const ClassPair& pair : pairs) pair.compute(block, iz, direct, meter, result);
    return result;
}

// Copies the values of the plane y = 0 to every y of the block.
Arrays<StressField> spread_along_y(const Arrays<StressField>& plane, const StressBlock& block) {
    Arrays<StressField> result = zeros<StressField>(block.size());
    const auto nx = static_cast<std::ptrdiff_t>(block.x.size());
    for (std::size_t c = 0; c < result.size(); ++c) {
        auto next = result[c].begin();
        for (std::size_t iz = 0; iz < block.z.size(); ++iz)
            for (std::size_t iy = 0; iy < block.y.size(); ++iy)
                next = std::copy_n(plane[c].begin() + static_cast<std::ptrdiff_t>(iz) * nx, nx, next);
    }
    return result;
}

}  // namespace

SurfaceTractions tractions_on(ContactBody body, std::span<const double> pressure, std::span<const double> traction_x,
                              std::span<const double> traction_y) {
    const auto times = [](double factor, std::span<const double> values) {
        Values result(values.begin(), values.end());
        for (double& value : result) value *= factor;
        return result;
    };
    const double sign = body == ContactBody::upper ? 1 : -1;
    return {times(sign, traction_x), times(sign, traction_y), times(-1, pressure)};
}

SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   std::span<const std::array<double, 3>> points, Observer& observer) {
    check(grid, tractions, nu);
    return with_von_mises(at_points<StressField>(LoadedPatch(grid, tractions), nu, points, observer));
}

SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   const StressBlock& block, Observer& observer) {
    check(grid, tractions, nu);
    check(block);
    return with_von_mises(on_block<StressField>(grid, LoadedPatch(grid, tractions), nu, block, observer));
}

SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, PlaneStrain body,
                                   std::span<const std::array<double, 3>> points, Observer& observer) {
    check(grid, tractions, body.nu);
    check_is_one_row(grid);
    return with_von_mises(
        at_points<StressField>(LoadedPatch(grid, tractions, RowEnds::nowhere), body.nu, points, observer));
}

SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, PlaneStrain body,
                                   const StressBlock& block, Observer& observer) {
    check(grid, tractions, body.nu);
    check_is_one_row(grid);
    check(block);
    const StressBlock plane{block.x, {0}, block.z};
    const LoadedPatch patch(grid, tractions, RowEnds::nowhere);
    return with_von_mises(spread_along_y(on_block<StressField>(grid, patch, body.nu, plane, observer), block));
}

SubsurfaceDisplacement subsurface_displacement(const Grid& grid, const SurfaceTractions& tractions,
                                               const Material& body, const SubsurfacePoints& points,
                                               Observer& observer) {
    validate(body, "material", true);
    check(grid, tractions, body.nu);
    const LoadedPatch patch(grid, tractions);
    Arrays<DisplacementField> found;
    if (const auto* block = std::get_if<StressBlock>(&points)) {
        check(*block);
        found = on_block<DisplacementField>(grid, patch, body.nu, *block, observer);
    } else {
        found = at_points<DisplacementField>(patch, body.nu, std::get<StressPoints>(points), observer);
    }
    for (Values& values : found)
        for (double& value : values) value /= body.G;
    return {std::move(found[0]), std::move(found[1]), std::move(found[2])};
}

}  // namespace contactd
