// Defines tractions of rolling on elements, in the frame of rolling.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/contact.hpp"
#include "element_lines.hpp"

namespace contactd {

/// Arrays have shape [ny, nx]; slip is relative to the rolling velocity.
template <class Number>
struct ElementTractions {
    std::vector<Number> px, py, slip_x, slip_y;
    std::vector<ElementState> division;

    explicit ElementTractions(std::size_t n)
        : px(n), py(n), slip_x(n), slip_y(n), division(n, ElementState::exterior) {}
};

/// Holds sums over the elements; power is over the rolling velocity.
template <class Number>
struct ElementSums {
    Number Fx{}, Fy{}, Mz{}, power{};
    double slip_area = 0;
};

template <class Number>
ElementSums<Number> sums_of(const ElementLines& lines, const ElementTractions<Number>& t) {
    ElementSums<Number> sums;
    const double area = lines.step() * lines.width();
    for (int line = 0; line < lines.count(); ++line)
        for (int place = 0; place < lines.length(); ++place) {
            const std::size_t i = lines.element(line, place);
            if (t.division[i] == ElementState::exterior) continue;
            const Number px = area * t.px[i], py = area * t.py[i];
            sums.Fx += px;
            sums.Fy += py;
            sums.Mz += lines.along(place) * py - lines.across(line) * px;
            sums.power -= px * t.slip_x[i] + py * t.slip_y[i];
            if (t.division[i] == ElementState::slip) sums.slip_area += area;
        }
    return sums;
}

}  // namespace contactd
