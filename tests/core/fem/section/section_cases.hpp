// Creates outlines of the reference values (reference-sections), with lengths divided by ds.
#pragma once

#include <cmath>
#include <numbers>

#include "section/outline.hpp"

namespace contactd::fem {

/// Returns -width <= y <= 0, -height <= z <= 0, clamped below and at the left.
inline SectionOutline edge_block(double width, double height, double edge_distance, int strips) {
    const OutlineLoop loop{straight({-width, 0}, {0, 0}), straight({0, 0}, {0, -height}),
                           straight({0, -height}, {-width, -height}, true),
                           straight({-width, -height}, {-width, 0}, true)};
    return {{loop}, 0, width - edge_distance - strips, strips};
}

/// Returns |y| <= width, -height <= z <= 0, free on top only.
inline SectionOutline slab(double width, double height, int strips) {
    const OutlineLoop loop{straight({-width, 0}, {width, 0}), straight({width, 0}, {width, -height}, true),
                           straight({width, -height}, {-width, -height}, true),
                           straight({-width, -height}, {-width, 0}, true)};
    return {{loop}, 0, width - strips / 2.0, strips};
}

inline SectionOutline groove(double radius, double width, double height, int strips) {
    using std::numbers::pi;
    const OutlineLoop loop{straight({-width, 0}, {-radius, 0}),
                           arc({0, 0}, radius, pi, pi),
                           straight({radius, 0}, {width, 0}),
                           straight({width, 0}, {width, -height}),
                           straight({width, -height}, {-width, -height}, true),
                           straight({-width, -height}, {-width, 0})};
    return {{loop}, 0, width - radius + pi * radius / 2 - strips / 2.0, strips};
}

/// Returns half a circle below a slab that is clamped above, with strips from +y to -y.
inline SectionOutline round_end(double radius, double height, int strips) {
    using std::numbers::pi;
    const OutlineLoop loop{arc({0, 0}, radius, 0, -pi), straight({-radius, 0}, {-radius, height}),
                           straight({-radius, height}, {radius, height}, true),
                           straight({radius, height}, {radius, 0})};
    return {{loop}, 0, pi * radius / 2 - strips / 2.0, strips};
}

/// Returns the whole circle of strips; nothing is clamped without a core.
inline SectionOutline disc(int strips, double core) {
    using std::numbers::pi;
    const double radius = strips / (2 * pi);
    SectionOutline outline{{{arc({0, 0}, radius, pi / 2, -pi), arc({0, 0}, radius, -pi / 2, -pi)}}, 0, 0, strips};
    if (core > 0)
        outline.loops.push_back({arc({0, 0}, core * radius, 0, pi, true), arc({0, 0}, core * radius, pi, pi, true)});
    return outline;
}

}  // namespace contactd::fem
