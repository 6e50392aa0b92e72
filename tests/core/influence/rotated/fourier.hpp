// Fourier integrals by Gauss's rule on intervals that grow.
#pragma once

#include <algorithm>

#include "influence/layered/gauss_legendre.hpp"

namespace contactd::test {

/// Calls `visit` with nodes and weights of a rule from `from` to `to`: in intervals that are at most `longest` long,
/// and no longer than their distance from `from`; the first one has the length `first`.
template <class Visit>
void for_each_node(double from, double to, double first, double longest, const Visit& visit) {
    static const auto rule = gauss_legendre(24);
    double begin = from, length = first;
    while (begin < to) {
        const double end = std::min(begin + length, to);
        for (const GaussPoint& point : rule) visit(begin + point.node * (end - begin), (end - begin) * point.weight);
        begin = end;
        length = std::min(begin - from, longest);
    }
}

template <class Function>
double integral(const Function& f, double from, double to, double first, double longest) {
    double sum = 0;
    for_each_node(from, to, first, longest, [&](double at, double weight) { sum += weight * f(at); });
    return sum;
}

}  // namespace contactd::test
