#include "fastsim_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
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

// Elements that one march passes, from the leading edge backwards.
struct Line {
    double across;
    std::size_t first, count;  // of the elements of all lines
};

struct Lines {
    std::vector<Element> elements;
    std::vector<Line> lines;

    std::span<const Element> of(const Line& line) const { return {elements.data() + line.first, line.count}; }
};

struct Sample {
    Quad px, py;
    Quad slip;                // length of the last step that slipped
    Quad excess_x, excess_y;  // what took the trial traction beyond the bound, per length: the slip is -L times this
};

// Four lines side by side; the march through a line that has ended stays where it is.
struct FourLines {
    FastsimSlice<Quad> slice;
    Quad longest_step;
    FastsimPoint<Quad> point;
    std::vector<Quad> along;
};

CONTACTD_INLINE Quad ceil(const Quad& a) {
    return Quad(Four{std::ceil(a.value[0]), std::ceil(a.value[1]), std::ceil(a.value[2]), std::ceil(a.value[3])});
}

CONTACTD_INLINE TractionAt<Quad> chosen(const Quad::Mask& first, const TractionAt<Quad>& a, const TractionAt<Quad>& b) {
    return {chosen(first, a.x, b.x), chosen(first, a.px, b.px), chosen(first, a.py, b.py)};
}

}  // namespace

CONTACTD_SIMD
static void march(const FastsimLaw<Quad>& law, FourLines& four, std::span<Sample> samples) {
    const Quad none = 0, one = 1;
    FastsimPoint<Quad> point = four.point;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Quad begin = point.traction.x, x = four.along[i], way = begin - x;
        const Quad needed = ceil(way / four.longest_step), steps = chosen(needed > one, needed, one);
        TractionAt<Quad> last = point.traction;
        Quad slip = none;
        for (Quad step_number = 1;; step_number += 1) {
            const auto between = steps > step_number;
            const Quad next = chosen(between, begin - way * (step_number / steps), x);
            const auto moves = point.traction.x > next;
            const FastsimStep<Quad> taken = step(law, four.slice, point, next);
            last = chosen(moves, point.traction, last);
            point.traction = chosen(moves, taken.end.traction, point.traction);
            point.room = chosen(moves, taken.end.room, point.room);
            slip = chosen(moves, taken.slip_start - next, slip);
            if (!any(between)) break;
        }
        const TractionAt<Quad> trial = adhering(law, four.slice, last, x);
        const auto slips = slip > none;
        const Quad length = chosen(slips, last.x - x, one);
        samples[i] = {point.traction.px, point.traction.py, slip,
                      chosen(slips, (trial.px - point.traction.px) / length, none),
                      chosen(slips, (trial.py - point.traction.py) / length, none)};
    }
}

namespace {

Lines lines_of(const Grid& grid, const RollingFrame& frame) {
    const bool rows = frame.s == 0, columns = frame.c == 0;
    const int count = columns ? grid.nx : grid.ny, length = columns ? grid.ny : grid.nx;
    const bool backwards = (columns ? frame.s : frame.c) > 0;
    Lines result;
    result.elements.reserve(grid.size());
    result.lines.reserve(rows || columns ? static_cast<std::size_t>(count) : grid.size());
    for (int number = 0; number < count; ++number) {
        bool begins = true;
        for (int k = 0; k < length; ++k) {
            const int at = backwards ? length - 1 - k : k;
            const int ix = columns ? number : at, iy = columns ? at : number;
            const double along = frame.along(grid.x(ix), grid.y(iy)), across = frame.across(grid.x(ix), grid.y(iy));
            const double X = along / frame.axes.a, Y = across / frame.axes.b;
            if (X * X + Y * Y >= 1) continue;
            if (begins || !(rows || columns)) result.lines.push_back({across, result.elements.size(), 0});
            begins = false;
            ++result.lines.back().count;
            result.elements.push_back(
                {static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix),
                 along});
        }
    }
    return result;
}

void place(const Lines& all, std::span<const Line> lines, const FastsimEllipse& ellipse,
           const FastsimCreepages<Quad>& creepages, int steps, FourLines& four) {
    std::size_t longest = 0;
    for (const Line& line : lines) longest = std::max(longest, line.count);
    four.along.resize(longest);
    Quad across;
    for (std::size_t k = 0; k < lanes; ++k) {  // those beyond the last are like it
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
    const Lines all = lines_of(grid, frame);
    FourLines four;
    std::vector<Sample> samples;
    for (std::size_t first = 0; first < all.lines.size(); first += lanes) {
        const std::span<const Line> some(&all.lines[first], std::min(lanes, all.lines.size() - first));
        place(all, some, ellipse, shared, steps, four);
        samples.resize(four.along.size());
        march(law, four, samples);
        for (std::size_t k = 0; k < some.size(); ++k) {
            std::size_t j = 0;
            for (const Element& element : all.of(some[k])) {
                const std::size_t i = element.index;
                const Sample& found = samples[j++];
                const auto of = [&](const Quad& values) { return values.value[k]; };
                const double px = of(found.px), py = of(found.py);
                const double sx = -L.L1 * of(found.excess_x), sy = -L.L2 * of(found.excess_y);
                result.traction_x[i] = frame.x_of(px, py);
                result.traction_y[i] = frame.y_of(px, py);
                result.slip_x[i] = frame.x_of(sx, sy);
                result.slip_y[i] = frame.y_of(sx, sy);
                result.element_division[i] = of(found.slip) > 0 ? ElementState::slip : ElementState::adhesion;
            }
        }
    }
}

}  // namespace contactd
