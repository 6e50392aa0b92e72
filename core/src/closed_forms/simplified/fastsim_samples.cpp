#include "fastsim_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "closed_forms/quad.hpp"
#include "types/simd.hpp"

namespace contactd {
namespace {

constexpr std::size_t lanes = 4;

struct Element {
    std::size_t index;
    double along;
};

// Describes elements that one march passes, from the leading edge backwards.
struct Line {
    double across;
    std::size_t first, count;  // index of the first element and number of elements
};

struct Lines {
    std::vector<Element> elements;
    std::vector<Line> lines;

    std::span<const Element> of(const Line& line) const { return {elements.data() + line.first, line.count}; }
};

struct Sample {
    Quad px, py;
    Quad::Mask slips;         // state in the last step
    Quad excess_x, excess_y;  // excess of the trial traction over the bound per length: the slip is -L times this
};

// Holds four lines side by side; the march through a line stops at its end.
struct FourLines {
    FastsimSlice<Quad> slice;
    Quad longest_step;
    FastsimPoint<Quad> point;
    std::vector<Quad> along;
    std::vector<Sample> samples;

    /// Repeats the last element in lines that are shorter than others.
    void extend(std::size_t length) {
        along.resize(length, along.back());
        samples.resize(length);
    }
};

// Three groups alternate at each step, since each waits for its own square roots.
constexpr std::size_t together = 3;

// Describes the path of four lines to their next elements.
struct NextElement {
    Quad begin, x, way, steps, per_step;
    TractionAt<Quad> last;
    Quad::Mask slips;
};

CONTACTD_INLINE Quad ceil(const Quad& a) {
    return Quad(Four{std::ceil(a.value[0]), std::ceil(a.value[1]), std::ceil(a.value[2]), std::ceil(a.value[3])});
}

CONTACTD_INLINE TractionAt<Quad> chosen(const Quad::Mask& first, const TractionAt<Quad>& a, const TractionAt<Quad>& b) {
    return {chosen(first, a.x, b.x), chosen(first, a.px, b.px), chosen(first, a.py, b.py)};
}

}  // namespace

namespace {

CONTACTD_INLINE NextElement next_element(const FourLines& four, std::size_t i) {
    const Quad begin = four.point.traction.x, x = four.along[i], way = begin - x, none = 0, one = 1;
    const Quad needed = ceil(way / four.longest_step), steps = chosen(needed > one, needed, one);
    return {begin, x, way, steps, one / steps, four.point.traction, none > none};
}

CONTACTD_INLINE void go_on(const FastsimLaw<Quad>& law, const Quad& step_number, const Quad::Mask& between,
                           FourLines& four, NextElement& to) {
    const Quad next = chosen(between, to.begin - to.way * (step_number * to.per_step), to.x);
    const auto moves = four.point.traction.x > next;
    const FastsimStep<Quad> taken = step(law, four.slice, four.point, next);
    to.last = chosen(moves, four.point.traction, to.last);
    four.point.traction = chosen(moves, taken.end.traction, four.point.traction);
    four.point.slips = four.point.slips ^ ((four.point.slips ^ taken.end.slips) & moves);
    to.slips = to.slips ^ ((to.slips ^ taken.end.slips) & moves);
}

CONTACTD_INLINE Sample sample_of(const FastsimLaw<Quad>& law, const FourLines& four, const NextElement& to) {
    const TractionAt<Quad> trial = adhering(law, four.slice, to.last, to.x);
    const Quad none = 0, one = 1, length = chosen(to.slips, to.last.x - to.x, one);
    const Quad unit = chosen(to.slips, one, none) / length;
    const TractionAt<Quad>& at = four.point.traction;
    return {at.px, at.py, to.slips, (trial.px - at.px) * unit, (trial.py - at.py) * unit};
}

}  // namespace

CONTACTD_SIMD
static void march(const FastsimLaw<Quad>& law, std::array<FourLines, together>& groups) {
    for (std::size_t i = 0; i < groups[0].along.size(); ++i) {
        std::array<NextElement, together> next;
        for (std::size_t k = 0; k < together; ++k) next[k] = next_element(groups[k], i);
        for (Quad step_number = 1;; step_number += 1) {
            Quad::Mask between[together];
            for (std::size_t k = 0; k < together; ++k) {
                between[k] = next[k].steps > step_number;
                go_on(law, step_number, between[k], groups[k], next[k]);
            }
            if (!any(between[0] | between[1] | between[2])) break;
        }
        for (std::size_t k = 0; k < together; ++k) groups[k].samples[i] = sample_of(law, groups[k], next[k]);
    }
}

namespace {

std::size_t index_of(const Grid& grid, int ix, int iy) {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
}

/// Adds rows or columns as lines if they are along the rolling direction. The position along a line depends only on the
/// index in it, so that elements inside the ellipse lie between two indices that change little from line to line.
void add_rows(const Grid& grid, const RollingFrame& frame, Lines& lines) {
    const bool columns = frame.c == 0, backwards = (columns ? frame.s : frame.c) > 0;
    const int count = columns ? grid.nx : grid.ny, length = columns ? grid.ny : grid.nx;
    const auto place = [&](int number, int k) {
        const int at = backwards ? length - 1 - k : k;
        return columns ? std::pair{number, at} : std::pair{at, number};
    };
    std::vector<double> along, square;  // square of the position over the semi-axis
    int middle = 0;
    for (int k = 0; k < length; ++k) {
        const auto [ix, iy] = place(0, k);
        along.push_back(frame.along(grid.x(ix), grid.y(iy)));
        const double X = along.back() / frame.axes.a;
        square.push_back(X * X);
        if (square.back() < square[static_cast<std::size_t>(middle)]) middle = k;
    }
    int first = middle, last = middle;
    for (int number = 0; number < count; ++number) {
        const auto [x, y] = place(number, 0);
        const double across = frame.across(grid.x(x), grid.y(y)), Y = across / frame.axes.b, square_across = Y * Y;
        const auto is_inside = [&](int k) { return square[static_cast<std::size_t>(k)] + square_across < 1; };
        if (!is_inside(middle)) continue;
        while (first > 0 && is_inside(first - 1)) --first;
        while (!is_inside(first)) ++first;
        while (last < length - 1 && is_inside(last + 1)) ++last;
        while (!is_inside(last)) --last;
        lines.lines.push_back({across, lines.elements.size(), static_cast<std::size_t>(last - first + 1)});
        for (int k = first; k <= last; ++k) {
            const auto [ix, iy] = place(number, k);
            lines.elements.push_back({index_of(grid, ix, iy), along[static_cast<std::size_t>(k)]});
        }
    }
}

Lines lines_of(const Grid& grid, const RollingFrame& frame) {
    Lines result;
    result.elements.reserve(grid.size());
    if (frame.s == 0 || frame.c == 0) {
        add_rows(grid, frame, result);
        return result;
    }
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const double along = frame.along(grid.x(ix), grid.y(iy)), across = frame.across(grid.x(ix), grid.y(iy));
            const double X = along / frame.axes.a, Y = across / frame.axes.b;
            if (X * X + Y * Y >= 1) continue;
            result.lines.push_back({across, result.elements.size(), 1});
            result.elements.push_back({index_of(grid, ix, iy), along});
        }
    return result;
}

/// Lines at the same distance from the middle have nearly the same length, so they are paired.
void pair_lines(std::vector<Line>& lines) {
    const std::vector<Line> given = lines;
    for (std::size_t j = 0; j < given.size(); ++j) lines[j] = given[j % 2 == 0 ? j / 2 : given.size() - 1 - j / 2];
}

void place(const Lines& all, std::span<const Line> lines, const FastsimEllipse& ellipse,
           const FastsimCreepages<Quad>& creepages, int steps, FourLines& four) {
    std::size_t longest = 0;
    for (const Line& line : lines) longest = std::max(longest, line.count);
    four.along.resize(longest);
    Quad across;
    for (std::size_t k = 0; k < lanes; ++k) {  // Lines beyond the last one repeat it.
        const Line& line = lines[std::min(k, lines.size() - 1)];
        across.value[k] = line.across;
        const std::span<const Element> elements = all.of(line);
        for (std::size_t i = 0; i < longest; ++i)
            four.along[i].value[k] = elements[std::min(i, elements.size() - 1)].along;
    }
    const Quad half = ellipse.half_chord(across);
    four.slice = ellipse.slice(creepages, across);
    four.longest_step = 2 * half / steps;
    four.point = {};
    four.point.traction.x = half;
}

}  // namespace

void sample(const Grid& grid, const RollingFrame& frame, const FastsimEllipse& ellipse,
            const FastsimCreepages<double>& creepages, int steps, EllipticFriction& result) {
    const FastsimCreepages<Quad> shared{creepages.xi, creepages.eta, creepages.phi};
    const FastsimLaw<Quad> law = ellipse.law(shared);
    const Flexibilities& L = ellipse.L();
    Lines all = lines_of(grid, frame);
    pair_lines(all.lines);
    std::array<FourLines, together> groups;
    constexpr std::size_t at_once = together * lanes;
    for (std::size_t first = 0; first < all.lines.size(); first += at_once) {
        std::array<std::span<const Line>, together> lines;
        for (std::size_t g = 0; g < together; ++g) {
            const std::size_t from = std::min(first + g * lanes, all.lines.size());
            lines[g] = {all.lines.data() + from, std::min(lanes, all.lines.size() - from)};
            // Without remaining lines, the group repeats the previous one.
            place(all, lines[g].empty() ? lines[0] : lines[g], ellipse, shared, steps, groups[g]);
        }
        std::size_t longest = 0;
        for (const FourLines& four : groups) longest = std::max(longest, four.along.size());
        for (FourLines& four : groups) four.extend(longest);
        march(law, groups);
        for (std::size_t g = 0; g < together; ++g)
            for (std::size_t k = 0; k < lines[g].size(); ++k) {
                const Sample* found = groups[g].samples.data();
                for (const Element& element : all.of(lines[g][k])) {
                    const std::size_t i = element.index;
                    const auto of = [&](const Quad& values) { return values.value[k]; };
                    const double px = of(found->px), py = of(found->py);
                    const double sx = -L.L1 * of(found->excess_x), sy = -L.L2 * of(found->excess_y);
                    result.traction_x[i] = frame.x_of(px, py);
                    result.traction_y[i] = frame.y_of(px, py);
                    result.slip_x[i] = frame.x_of(sx, sy);
                    result.slip_y[i] = frame.y_of(sx, sy);
                    result.element_division[i] =
                        found->slips.value[k] != 0 ? ElementState::slip : ElementState::adhesion;
                    ++found;
                }
            }
    }
}

}  // namespace contactd
