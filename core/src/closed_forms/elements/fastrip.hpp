// Computes FaStrip (Sichani, Enblom, Berg 2016): strip theory where elements adhere, FASTSIM's direction where they
// slip.
#pragma once

#include "element_fastsim.hpp"

namespace contactd {

/// Returns the spin of strip theory, S = -3 G sqrt(ab) C23 phi/(2 pi mu p0). The theory is intended for |S| < 1.
template <class Number>
Number strip_spin(const RollingTheory& theory, const Number& phi, double mu) {
    const auto [a, b] = theory.counted;
    const double p0 = 1.5 * theory.Fn / (std::numbers::pi * a * b);
    return -3 * theory.G * std::sqrt(a * b) * theory.C.C23 / (2 * std::numbers::pi * mu * p0) * phi;
}

namespace strip {

/// Describes a strip of the contact, a line of elements that begins at the place `first`.
struct Row {
    int line, first, last;  // places, the last one included
    double middle, half;    // middle of the strip and half of its length (mm)
};

/// Visits rows of elements above zero; a line that is interrupted has several.
template <class Visit>
void each_row(const ElementLines& lines, std::span<const double> bound, Visit visit) {
    for (int line = 0; line < lines.count(); ++line)
        for (int place = 0; place < lines.length(); ++place) {
            if (!(bound[lines.element(line, place)] > 0)) continue;
            const int first = place;
            while (place + 1 < lines.length() && bound[lines.element(line, place + 1)] > 0) ++place;
            visit(Row{line, first, place, 0.5 * (lines.along(first) + lines.along(place)),
                      0.5 * lines.step() * (place - first + 1)});
        }
}

/// Holds the theory of one strip; d is half of the length of its slip zone.
template <class Number>
struct Strip {
    Number d, c, l, S;
    bool slips_fully = false;
};

template <class Number>
Strip<Number> strip_of(const RollingTheory& theory, const FastsimCreepages<Number>& w, double mu, double across,
                       double middle) {
    using std::sqrt;
    const auto [a, b] = theory.counted;
    const double p0 = 1.5 * theory.Fn / (std::numbers::pi * a * b);
    const double unit = -2 * theory.G * (1 - theory.nu) / (std::numbers::pi * std::numbers::pi * mu * p0);
    // Reduced flexibilities reduce the slope of strips by the same factor.
    const Number slope = slope_factor(theory, w, mu), none{};
    const Number S = slope * strip_spin(theory, w.phi, mu);
    const Number k = slope * (unit * theory.C.C11 * w.xi) - across / a * S;
    const Number E = slope * (unit * theory.C.C22 * (w.eta + middle * w.phi));
    const Number root = E * E + (1 - S * S) * (k * k);
    Strip<Number> strip{none, none, none, S};
    const Number rest = 1 - S * S;
    if (root < none || rest == none) {
        strip.slips_fully = true;
        return strip;
    }
    strip.d = a / (1 - theory.nu) * (sqrt(root) + E * S) / rest;
    if (strip.d < none) {
        strip.slips_fully = true;
        return strip;
    }
    const Number lateral = E + S * strip.d / a, size = sqrt(k * k + lateral * lateral);
    if (size > none) {
        strip.c = k / size;
        strip.l = lateral / size;
    }
    return strip;
}

}  // namespace strip

/// Returns the tractions by strips. Each strip has the constant creepage of its line, and a slip zone of length 2 d at
/// the trailing edge. Elements there have the direction of FASTSIM's tractions and the size of their bound g. Strips
/// whose tractions would exceed mu times the largest pressure keep those of FASTSIM. `bound` is g over mu, shape [ny,
/// nx] (N/mm^2).
template <class Number>
ElementTractions<Number> fastrip(const ElementLines& lines, std::span<const double> bound, const RollingTheory& theory,
                                 const FastsimCreepages<Number>& w, double mu) {
    using std::sqrt;
    ElementTractions<Number> t = fastsim_on_elements(lines, bound, theory, w, mu);
    if (!(mu > 0)) return t;
    const auto [a, b] = theory.counted;
    const double most = mu * 1.5 * theory.Fn / (std::numbers::pi * a * b);
    const Number none{};
    const auto root = [&](const Number& square) { return square > none ? Number(sqrt(square)) : none; };
    strip::each_row(lines, bound, [&](const strip::Row& row) {
        const strip::Strip<Number> s = strip::strip_of(theory, w, mu, lines.across(row.line), row.middle);
        std::vector<Number> px(static_cast<std::size_t>(row.last - row.first + 1)), py = px;
        std::vector<bool> adheres(px.size());
        for (std::size_t k = 0; k < px.size() && !s.slips_fully; ++k) {
            const double x = lines.along(row.first + static_cast<int>(k)) - row.middle;
            if (!(Number(x + row.half) > 2 * s.d)) continue;
            const Number s1 = std::sqrt(std::max(0.0, row.half * row.half - x * x)) / a;
            const Number s2 = root((row.half - s.d) * (row.half - s.d) - (x - s.d) * (x - s.d)) / a;
            px[k] = most * (s.c * (s1 - s2));
            py[k] = most * (s.l * s1 - (s.l - s.S) * s2);
            adheres[k] = true;
            if (px[k] * px[k] + py[k] * py[k] > Number(most * most)) return;
        }
        for (std::size_t k = 0; k < px.size(); ++k) {
            const std::size_t i = lines.element(row.line, row.first + static_cast<int>(k));
            if (adheres[k]) {
                t.px[i] = px[k];
                t.py[i] = py[k];
                t.slip_x[i] = t.slip_y[i] = none;
                t.division[i] = ElementState::adhesion;
                continue;
            }
            const Number size = sqrt(t.px[i] * t.px[i] + t.py[i] * t.py[i]);
            const Number share = size > none ? mu * bound[i] / size : none;
            t.px[i] = share * t.px[i];
            t.py[i] = share * t.py[i];
            t.division[i] = ElementState::slip;
        }
    });
    return t;
}

}  // namespace contactd
