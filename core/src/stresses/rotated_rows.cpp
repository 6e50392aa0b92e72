// Tractions of a row act on another one as if they lay on its half-space, at the distance along the surface, rotated by
// the angle between both. With Y and Z the tractions along fixed axes, those in the axes of a row inclined by the angle
// a are Y cos a + Z sin a along it and -Y sin a + Z cos a out of it, so that five stress fields are sufficient for all
// rows.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "contact/support/solver_support.hpp"
#include "contactd/error.hpp"
#include "contactd/subsurface.hpp"
#include "stress_arrays.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

/// Interpolates linearly between the middles of the rows, with constants beyond.
double angle_at(const Grid& grid, std::span<const double> angles, double y) {
    const double place = std::clamp((y - grid.y(0)) / grid.dy, 0.0, static_cast<double>(grid.ny - 1));
    const auto row = std::min(static_cast<std::size_t>(place), angles.size() - 1);
    if (row + 1 == angles.size()) return angles[row];
    return angles[row] + (place - static_cast<double>(row)) * (angles[row + 1] - angles[row]);
}

/// Returns tractions across the rows along fixed axes.
std::array<Values, 2> along_fixed_axes(const Grid& grid, const SurfaceTractions& tractions,
                                       std::span<const double> angles) {
    std::array<Values, 2> result{Values(grid.size()), Values(grid.size())};
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const double angle = angles[i / static_cast<std::size_t>(grid.nx)];
        const double y = tractions.y.empty() ? 0 : tractions.y[i], z = tractions.z.empty() ? 0 : tractions.z[i];
        result[0][i] = y * std::cos(angle) - z * std::sin(angle);
        result[1][i] = y * std::sin(angle) + z * std::cos(angle);
    }
    return result;
}

std::size_t number_of(const SubsurfacePoints& points) {
    if (const auto* block = std::get_if<StressBlock>(&points)) return block->size();
    return std::get<StressPoints>(points).size();
}

double y_of(const SubsurfacePoints& points, std::size_t i) {
    if (const auto* block = std::get_if<StressBlock>(&points)) return block->y[i / block->x.size() % block->y.size()];
    return std::get<StressPoints>(points)[i][1];
}

SubsurfaceStress of_plane(const Grid& grid, const SurfaceTractions& tractions, double nu,
                          const SubsurfacePoints& points, Observer& observer) {
    if (const auto* block = std::get_if<StressBlock>(&points))
        return subsurface_stress(grid, tractions, nu, *block, observer);
    return subsurface_stress(grid, tractions, nu, std::get<StressPoints>(points), observer);
}

}  // namespace

SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   std::span<const double> angles, const SubsurfacePoints& points, Observer& observer) {
    validate(grid, "grid");
    if (angles.size() != static_cast<std::size_t>(grid.ny))
        throw InvalidArgument("angles", "has " + std::to_string(angles.size()) + " values; the grid has " +
                                            std::to_string(grid.ny) + " rows");
    for (const double angle : angles)
        if (!std::isfinite(angle))
            throw InvalidArgument("angles", "contains " + number_text(angle) + "; every angle must be finite");
    for (const Values* values : {&tractions.y, &tractions.z})
        if (!values->empty()) require_size(*values, grid.size(), "tractions");
    const auto [Y, Z] = along_fixed_axes(grid, tractions, angles);
    using Factor = double (*)(double);
    const std::array<std::pair<SurfaceTractions, Factor>, 5> fields{{
        {{.x = tractions.x, .y = {}, .z = {}}, [](double) { return 1.0; }},
        {{.x = {}, .y = Y, .z = {}}, [](double angle) { return std::cos(angle); }},
        {{.x = {}, .y = Z, .z = {}}, [](double angle) { return std::sin(angle); }},
        {{.x = {}, .y = {}, .z = Y}, [](double angle) { return 0 - std::sin(angle); }},
        {{.x = {}, .y = {}, .z = Z}, [](double angle) { return std::cos(angle); }},
    }};
    const std::size_t n = number_of(points);
    SubsurfaceStress result;
    for (Values* values : components_of(result)) values->assign(n, 0);
    for (std::size_t part = 0; part < fields.size(); ++part) {
        const auto all = static_cast<double>(fields.size()), before = static_cast<double>(part);
        PartObserver reports(observer, before / all, (before + 1) / all);
        SubsurfaceStress field = of_plane(grid, fields[part].first, nu, points, reports);
        const auto from = components_of(field), to = components_of(result);
        for (std::size_t i = 0; i < n; ++i) {
            const double factor = fields[part].second(angle_at(grid, angles, y_of(points, i)));
            for (std::size_t c = 0; c < to.size(); ++c) (*to[c])[i] += factor * (*from[c])[i];
        }
    }
    result.von_mises.resize(n);
    find_von_mises(result);
    return result;
}

}  // namespace contactd
