// Computes sums over the bodies of a pair, for SumOperator and SumStep.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contactd/error.hpp"

namespace contactd {

/// Holds operators of the upper and of the lower body, on the same elements; null for a rigid body, but not for both.
template <class Operator>
struct OfBodies {
    std::shared_ptr<const Operator> upper, lower;
};

namespace sums {

/// These are the signs of xz, yz, zx and zy, as in pair_of.
inline constexpr double upper_sign = -1, lower_sign = 1;

/// Returns one term for each body that deforms.
template <class Term, class Operator>
std::vector<Term> terms_of(OfBodies<Operator>& bodies) {
    std::vector<Term> terms;
    if (bodies.upper) terms.push_back({std::move(bodies.upper), upper_sign});
    if (bodies.lower) terms.push_back({std::move(bodies.lower), lower_sign});
    if (terms.empty()) throw InvalidArgument("bodies", "are both rigid; one of them must be elastic");
    if (terms.front().body->size() != terms.back().body->size())
        throw InvalidArgument("bodies", "have operators on different numbers of elements");
    return terms;
}

inline void add(std::span<const double> values, std::span<double> sum, double factor = 1) {
    for (std::size_t at = 0; at < sum.size(); ++at) sum[at] += factor * values[at];
}

/// Computes u = sum of factor(term) * product(term), one component.
template <class Terms, class Product, class Factor>
void sum(const Terms& terms, std::span<double> u, const Factor& factor, const Product& product) {
    std::vector<double> part(u.size());
    std::fill(u.begin(), u.end(), 0.0);
    for (const auto& term : terms) {
        product(term, std::span<double>(part));
        add(part, u, factor(term));
    }
}

/// Sums the products of two components.
template <class Terms, class Product, class Factor>
void sum(const Terms& terms, std::span<double> ux, std::span<double> uy, const Factor& factor, const Product& product) {
    std::vector<double> y(uy.size());
    std::fill(uy.begin(), uy.end(), 0.0);
    sum(terms, ux, factor, [&](const auto& term, std::span<double> x) {
        product(term, x, std::span<double>(y));
        add(y, uy, factor(term));
    });
}

inline constexpr auto plain = [](const auto&) { return 1.0; };
inline constexpr auto coupling = [](const auto& term) { return term.coupling_sign; };

template <class Terms>
bool any_coupled(const Terms& terms) {
    return std::any_of(terms.begin(), terms.end(), [](const auto& term) { return term.body->coupled(); });
}

/// Returns the same part of each term, as upper and lower; null if `of` one of them is null.
template <class Operator, class Terms, class Of>
OfBodies<Operator> each(const Terms& terms, const Of& of) {
    OfBodies<Operator> bodies;
    for (const auto& term : terms) {
        std::shared_ptr<const Operator> found = of(*term.body);
        if (!found) return {};
        (term.coupling_sign == upper_sign ? bodies.upper : bodies.lower) = std::move(found);
    }
    return bodies;
}

template <class Operator>
bool none(const OfBodies<Operator>& bodies) {
    return !bodies.upper && !bodies.lower;
}

/// Returns a pointer without ownership to something that lives as long as this operator.
template <class Operator>
std::shared_ptr<const Operator> borrowed(const Operator* lasting) {
    return {std::shared_ptr<void>(), lasting};
}

}  // namespace sums
}  // namespace contactd
