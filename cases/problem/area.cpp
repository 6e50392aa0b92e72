#include "area.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "closed_forms/hertz.hpp"
#include "history/moved.hpp"

namespace contactd::cases {
namespace {

const MaterialPair& materials_of(const Given& settings) {
    if (!settings.materials)
        throw NotCovered(Subject::input, "No material constants were given (cntc_setmaterialparameters).");
    return *settings.materials;
}

constexpr int of_halves = -6;

bool is_line(int option) {
    return option == -4 || option == -5;
}

/// Returns the radius for a curvature a1, h = a1 x^2, which is infinite in a flat direction.
double radius(double curvature) {
    return curvature == 0 ? std::numeric_limits<double>::infinity() : 1 / (2 * curvature);
}

double curvature(double radius) {
    return 1 / (2 * radius);
}

/// Holds the load that determines a Hertzian contact.
struct Load {
    bool by_force;
    double compliance;  ///< 1/E* (mm^2/N)
    double value;       ///< force (N) or approach (mm)

    explicit Load(const Given& settings)
        : by_force(settings.digits.normal == 1), compliance(materials_of(settings).normal_compliance()) {
        const auto& given = by_force ? settings.fn : settings.pen;
        if (!given)
            throw NotCovered(Subject::input, by_force ? "No normal force FN was given (cntc_setnormalforce)."
                                                      : "No penetration PEN was given (cntc_setpenetration).");
        value = *given;
        if (!(value > 0))
            throw NotCovered(
                Subject::input,
                std::string(by_force ? "FN" : "PEN") +
                    " must be positive for a Hertzian contact (IPOTCN < 0), whose elements follow from its "
                    "size. Use IPOTCN = 1 to 4 if the bodies may separate (cntc_setpotcontact).");
    }

    Paraboloid radii(const SemiAxes& axes) const {
        return by_force ? radii_of_force(axes, compliance, value) : radii_of_approach(axes, value);
    }
    HertzContact contact(const Paraboloid& gap) const {
        return by_force ? hertz_of_force(gap, compliance, value) : hertz_of_approach(gap, compliance, value);
    }
};

HertzResult by_curvatures(const HertzArea& area, const Load& load) {
    const HertzContact contact = load.contact({radius(area.first), radius(area.second)});
    return {area.first, area.second, {contact.a, contact.b}, area.scale};
}

/// Finds semi-axes in the ratio a/b with the curvature a1 along x. The curvature is proportional to b^-3 for a given
/// force, and to b^-2 for a given approach.
HertzResult by_curvature_and_ratio(const HertzArea& area, const Load& load) {
    const double of_unit = curvature(load.radii({area.second, 1}).Rx);
    const double b = load.by_force ? std::cbrt(of_unit / area.first) : std::sqrt(of_unit / area.first);
    const SemiAxes axes{area.second * b, b};
    return {area.first, curvature(load.radii(axes).Ry), axes, area.scale};
}

HertzResult by_semi_axes(const HertzArea& area, const Load& load) {
    const SemiAxes axes{area.first, area.second};
    const Paraboloid gap = load.radii(axes);
    return {curvature(gap.Rx), curvature(gap.Ry), axes, area.scale};
}

/// Returns the contact of a cylinder under the load P = Fn/(2 half width) per length: a^2 = 4 P R c/pi (Johnson,
/// Contact Mechanics, 4.2(c)).
HertzResult line_contact(const HertzArea& area, const Load& load) {
    if (!load.by_force)
        throw NotCovered(Subject::input,
                         "IPOTCN = " + std::to_string(area.option) +
                             ": the penetration PEN of a line contact does not determine its width. Prescribe FN with "
                             "N = 1 (cntc_setnormalforce).");
    const double squared = 4 * load.value / (2 * area.second) * load.compliance / std::numbers::pi;  // a^2/R
    const bool by_curvature = area.option == -4;
    const double R = by_curvature ? radius(area.first) : area.first * area.first / squared;
    return {curvature(R), 0, {std::sqrt(squared * R), area.second}, area.scale};
}

HertzResult by_option(const HertzArea& area, const Load& load) {
    switch (area.option) {
        case -1:
            return by_curvatures(area, load);
        case -2:
            return by_curvature_and_ratio(area, load);
        case -3:
        case of_halves:
            return by_semi_axes(area, load);
        default:
            return line_contact(area, load);
    }
}

HertzResult hertz_of(const HertzArea& area, const Given& settings) {
    HertzResult found = by_option(area, Load(settings));
    const bool has_halves = area.option == of_halves;
    found.negative = has_halves ? area.negative : found.axes.b;
    found.positive = has_halves ? area.positive : found.axes.b;
    return found;
}

/// Returns the number of rows of elements that divide a line. The other rows lie beyond its ends, equally many on
/// either side.
int rows_of_line(int rows, double scale) {
    if (scale <= 1) return rows;
    const int inside = std::max(1, static_cast<int>(std::nearbyint(rows / scale)));
    return (rows - inside) % 2 == 0 ? inside : inside + 1;
}

/// Returns the grid. A line contact ends at the given half width, between two rows of elements.
Grid grid_of(const HertzArea& area, const HertzResult& hertz) {
    const double width = 2 * hertz.axes.a * area.scale / area.mx;
    if (is_line(area.option))
        return Grid::of_elements(area.mx, area.my, width, 2 * hertz.axes.b / rows_of_line(area.my, area.scale));
    return Grid::of_elements(area.mx, area.my, width, 2 * hertz.axes.b * area.scale / area.my);
}

const HertzArea* hertz_area(const Given& settings) {
    return std::get_if<HertzArea>(&settings.area);
}

/// Returns the values of a function of x and y at the centres of the elements.
template <class Function>
std::vector<double> sampled(const Grid& grid, const Function& h) {
    std::vector<double> values;
    values.reserve(grid.size());
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) values.push_back(h(grid.x(ix), grid.y(iy)));
    return values;
}

constexpr double excluded = 1e6;  ///< distance of elements outside the contact (mm): above any approach, but finite

/// Returns the distance of a cylinder, with excluded rows beyond its ends.
Gap gap_of_line(const HertzResult& hertz, const Grid& grid) {
    return sampled(grid, [&](double x, double y) { return std::abs(y) > hertz.axes.b ? excluded : hertz.a1 * x * x; });
}

std::vector<double> sampled(const Grid& grid, const Quadratic& quadratic) {
    const auto& b = quadratic.b;
    return sampled(grid, [&](double x, double y) {
        return b[0] * x * x + b[1] * x * y + b[2] * y * y + b[3] * x + b[4] * y + b[5];
    });
}

Gap gap_of(const Quadratic& quadratic, const Grid& grid) {
    const auto& b = quadratic.b;
    if (b[1] == 0 && b[3] == 0 && b[4] == 0 && b[5] == 0) return Paraboloid{radius(b[0]), radius(b[2])};
    return sampled(grid, quadratic);
}

/// Interpolates linearly, and extrapolates beyond the first and last height.
double height_at(const RoundProfile& profile, double y) {
    const auto& heights = profile.heights;
    if (heights.size() == 1) return heights.front();
    const double place = (y - profile.y1) / profile.dy, last = static_cast<double>(heights.size() - 2);
    const auto left = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last));
    return heights[left] + (place - static_cast<double>(left)) * (heights[left + 1] - heights[left]);
}

Gap gap_of(const RoundProfile& profile, const Grid& grid) {
    return sampled(grid, [&](double x, double y) {
        return height_at(profile, y) + (x - profile.xm) * (x - profile.xm) / (2 * profile.rm);
    });
}

Gap gap_of(const Waves& waves, const Grid& grid) {
    const auto& b = waves.b;
    return sampled(grid, [&](double x, double y) {
        return b[0] * std::sin(b[1] * (x - b[2])) - b[3] * std::sin(b[4] * (x - b[5])) + x * x / b[6] + y * y / b[7];
    });
}

Gap gap_of(const std::vector<double>& values, const Grid& grid) {
    if (values.size() != grid.size())
        throw NotCovered(Subject::input, "The undeformed distance (IBASE = 9) has " + std::to_string(values.size()) +
                                             " values, but there are MX MY = " + std::to_string(grid.size()) +
                                             " elements.");
    return values;
}

Gap distance_on(const Grid& grid, const Given& settings) {
    if (!settings.distance)
        throw NotCovered(Subject::input, "No undeformed distance IBASE was given (cntc_setundeformeddistc).");
    return std::visit([&](const auto& distance) { return gap_of(distance, grid); }, *settings.distance);
}

/// Returns the elements outside the planform, or an empty list if there are none.
std::vector<bool> outside_of(const Planform& planform, const Grid& grid) {
    std::vector<bool> outside;
    if (const auto* conic = std::get_if<Quadratic>(&planform)) {
        for (const double value : sampled(grid, *conic)) outside.push_back(value >= 0);
        return outside;
    }
    const auto* regions = std::get_if<ContactRegions>(&planform);
    const auto* rectangles = regions ? &regions->limits : std::get_if<std::vector<RegionLimits>>(&planform);
    if (rectangles == nullptr) return outside;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix)
            outside.push_back(std::ranges::none_of(*rectangles, [&](const RegionLimits& in) {
                const double x = grid.x(ix), y = grid.y(iy);
                return x >= in.x.from && x <= in.x.to && y >= in.y.from && y <= in.y.to;
            }));
    return outside;
}

std::vector<double> values_of(const Gap& gap, const Grid& grid) {
    if (const auto* values = std::get_if<std::vector<double>>(&gap)) return *values;
    const auto curvature_of = [](double radius) { return std::isfinite(radius) ? curvature(radius) : 0; };
    const auto& paraboloid = std::get<Paraboloid>(gap);
    const double a = curvature_of(paraboloid.Rx), b = curvature_of(paraboloid.Ry);
    return sampled(grid, [&](double x, double y) { return a * x * x + b * y * y; });
}

void take_planform(const Planform& planform, Area& area) {
    const std::vector<bool> outside = outside_of(planform, area.grid);
    if (outside.empty()) return;
    std::vector<double> values = values_of(area.gap, area.grid);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (outside[i]) values[i] = excluded;
    area.gap = std::move(values);
    if (const auto* regions = std::get_if<ContactRegions>(&planform)) area.regions = *regions;
}

}  // namespace

HertzResult hertz_of(const Given& settings) {
    const HertzArea* area = hertz_area(settings);
    if (area == nullptr) throw NotCovered(Subject::input, "No Hertzian contact was given (cntc_sethertzcontact).");
    return hertz_of(*area, settings);
}

Grid grid_of(const Given& settings) {
    if (const auto* grid = std::get_if<Grid>(&settings.area)) return *grid;
    const HertzArea* area = hertz_area(settings);
    if (area == nullptr)
        throw NotCovered(Subject::discretisation,
                         "No potential contact IPOTCN was given (cntc_sethertzcontact or cntc_setpotcontact).");
    return grid_of(*area, hertz_of(*area, settings));
}

Area area_of(const Given& settings, const Grid* before) {
    const HertzArea* area = hertz_area(settings);
    if (area == nullptr) {
        const Grid grid = before ? continued(grid_of(settings), *before) : grid_of(settings);
        Area found{grid, distance_on(grid, settings), {}, {}};
        take_planform(settings.planform, found);
        return found;
    }
    const HertzResult hertz = hertz_of(*area, settings);
    const Grid own = grid_of(*area, hertz), grid = before ? continued(own, *before) : own;
    if (area->option == -3) return {grid, hertz.axes, hertz, {}};
    if (area->option == of_halves) return {grid, HalfEllipses{hertz.axes.a, hertz.negative, hertz.positive}, hertz, {}};
    if (is_line(area->option)) return {grid, gap_of_line(hertz, grid), hertz, {}};
    return {grid, Paraboloid{radius(hertz.a1), radius(hertz.b1)}, hertz, {}};
}

}  // namespace contactd::cases
