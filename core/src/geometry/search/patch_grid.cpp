#include "geometry/search/patch_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "contactd/count_of.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr int most_elements = 200'000;  // in one patch

/// Holds multiples of the step around zero that cover the extent, with one more on both sides.
struct Range {
    int first, last;
    int count() const { return last - first + 1; }
};

Range range_of(double from, double to, double step) {
    return {static_cast<int>(std::floor(from / step)) - 1, static_cast<int>(std::ceil(to / step)) + 1};
}

/// Returns the count of a range, even if it exceeds an int.
double number_of(const Extent& between, double step) {
    return std::ceil(between.to / step) - std::floor(between.from / step) + 3;
}

/// Doubles elements by the rule of reference programs, which is not proportional if there are few in one direction.
void keep_below(int most, const Extent& x, const Extent& y, double& dx, double& dy) {
    constexpr double few = 10;
    for (;;) {
        const double nx = number_of(x, dx), ny = number_of(y, dy);
        if (nx * ny < most || !(nx > few || ny > few)) return;
        if (nx > few) dx *= 2;
        if (ny > few) dy *= 2;
    }
}

void check_elements(double elements, double dx, double dy, double length, double width, int most) {
    count_of(elements, {"dx",
                        "and dy are " + number_text(dx) + " and " + number_text(dy) + " mm, and the contact " +
                            short_text(length) + " by " + short_text(width) + " mm",
                        "elements", "increase them, or lift the wheelset (position.z)", most});
}

double along_rail(const RailSurface& rail, double y) {
    double s = y <= rail.visible().low ? rail.visible().from : rail.visible().to;
    if (y > rail.visible().low && y < rail.visible().high) rail.find_y(y, s);
    return rail.profile().arc_length(s);
}

}  // namespace

double arc_length_of_middle(const ProfileCurve& profile) {
    return profile.arc_length(profile.middle());
}

double across_rail(const RailSurface& rail, double y) {
    return along_rail(rail, y) - arc_length_of_middle(rail.profile());
}

void check_size(const Grid& grid) {
    check_elements(static_cast<double>(grid.nx) * grid.ny, grid.dx, grid.dy, grid.nx * grid.dx, grid.ny * grid.dy,
                   most_elements);
}

Grid grid_of(const RegionGroup& group, const RailSurface& rail, double dx, double dy, const ElementMiddle& middle,
             int most) {
    const double here = along_rail(rail, group.reference.y);
    const double x_from = group.x.from - group.reference.x, x_to = group.x.to - group.reference.x;
    const double y_from = along_rail(rail, group.y.from) - here, y_to = along_rail(rail, group.y.to) - here;
    if (most > 0) keep_below(most, {x_from, x_to}, {y_from, y_to}, dx, dy);
    const double elements = ((x_to - x_from) / dx + 4) * ((y_to - y_from) / dy + 4);
    check_elements(elements, dx, dy, x_to - x_from, y_to - y_from, most_elements);
    const Range columns = range_of(x_from - middle.x, x_to - middle.x, dx);
    const Range rows = range_of(y_from - middle.y, y_to - middle.y, dy);
    return {columns.count(),
            rows.count(),
            dx,
            dy,
            (columns.first - 0.5) * dx + middle.x,
            (rows.first - 0.5) * dy + middle.y};
}

Grid convenient(Grid grid, bool all_rows) {
    constexpr std::size_t largest = 20'000;  // Beyond this, elements cost more than operators.
    if (grid.size() > largest) return grid;
    const int more_x = convenient_size(grid.nx) - grid.nx;
    const int more_y = all_rows ? convenient_size(grid.ny) - grid.ny : 0;
    grid.x0 -= more_x / 2 * grid.dx;
    grid.y0 -= more_y / 2 * grid.dy;
    grid.nx += more_x;
    grid.ny += more_y;
    return grid;
}

bool grow(Grid& grid, const std::vector<double>& gap, double approach) {
    constexpr int more = 2;
    const auto overlaps = [&](int ix, int iy) {
        return gap[static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix)] <
               approach;
    };
    bool left = false, right = false, below = false, above = false;
    for (int iy = 0; iy < grid.ny; ++iy) {
        left = left || overlaps(0, iy);
        right = right || overlaps(grid.nx - 1, iy);
    }
    for (int ix = 0; ix < grid.nx; ++ix) {
        below = below || overlaps(ix, 0);
        above = above || overlaps(ix, grid.ny - 1);
    }
    grid.x0 -= left * more * grid.dx;
    grid.y0 -= below * more * grid.dy;
    grid.nx += (left + right) * more;
    grid.ny += (below + above) * more;
    return (left || right || below || above) && grid.size() <= static_cast<std::size_t>(most_elements);
}

void cover(Grid& grid, double along, double across) {
    const double width = std::max(2 * along, grid.nx * grid.dx), height = std::max(2 * across, grid.ny * grid.dy);
    check_elements((width / grid.dx + 4) * (height / grid.dy + 4), grid.dx, grid.dy, width, height,
                   static_cast<int>(max_grid_elements));
    const auto more = [](double beyond, double size) {
        return std::max(0, static_cast<int>(std::ceil(beyond / size)));
    };
    const int left = more(grid.x0 + along, grid.dx), right = more(along - grid.x0 - grid.nx * grid.dx, grid.dx);
    const int below = more(grid.y0 + across, grid.dy), above = more(across - grid.y0 - grid.ny * grid.dy, grid.dy);
    grid.x0 -= left * grid.dx;
    grid.y0 -= below * grid.dy;
    grid.nx += left + right;
    grid.ny += below + above;
}

}  // namespace contactd::geometry
