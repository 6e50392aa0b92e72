// Defines the elements of a given contact area and vector fields on them for the tangential solvers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "contactd/influence_operator.hpp"
#include "solver_support.hpp"
#include "traction_loops.hpp"

namespace contactd {

struct Field {
    std::vector<double> x, y;
    explicit Field(std::size_t n = 0) : x(n), y(n) {}
    operator Vectors() const { return {x.data(), y.data()}; }
    operator MutableVectors() { return {x.data(), y.data()}; }
};

inline double inner(const Field& a, const Field& b) {
    return dot_product(a.x.size(), a.x.data(), b.x.data()) + dot_product(a.y.size(), a.y.data(), b.y.data());
}

inline bool any(const Field& field) {
    return inner(field, field) > 0;
}

inline void add(Field& to, const Field& from, double factor = 1) {
    for (std::size_t i = 0; i < to.x.size(); ++i) {
        to.x[i] += factor * from.x[i];
        to.y[i] += factor * from.y[i];
    }
}

// Holds the elements of the contact area, 0..m-1, with their data of the problem.
struct Contact {
    // Describes adjacent elements of the grid, first ... first + size - 1, the first of which is at grid_first in the
    // grid.
    struct Run {
        std::size_t first, grid_first, size;
    };

    std::vector<std::size_t> elements;
    std::vector<Run> runs;
    std::vector<double> bound;
    Field rigid;

    Contact(std::span<const double> g, std::span<const double> wx, std::span<const double> wy) {
        const auto size = static_cast<std::size_t>(std::count_if(g.begin(), g.end(), [](double b) { return b > 0; }));
        elements.reserve(size);
        for (std::vector<double>* values : {&bound, &rigid.x, &rigid.y}) values->reserve(size);
        for (std::size_t i = 0; i < g.size(); ++i) {
            if (!(g[i] > 0)) continue;
            if (!elements.empty() && elements.back() + 1 == i)
                ++runs.back().size;
            else
                runs.push_back({elements.size(), i, 1});
            elements.push_back(i);
            bound.push_back(g[i]);
            rigid.x.push_back(wx[i]);
            rigid.y.push_back(wy[i]);
        }
    }
    std::size_t size() const { return elements.size(); }

    void scatter(const std::vector<double>& from, std::vector<double>& to) const {
        for (const Run& run : runs) std::copy_n(&from[run.first], run.size, &to[run.grid_first]);
    }
    /// Computes out = `influence` times in, tangential components. The full fields are work arrays of the grid's size,
    /// zero outside.
    template <class Influence>
    void product(const Influence& influence, const Field& in, Field& full_in, Field& full_out, Field& out) const {
        scatter(in.x, full_in.x);
        scatter(in.y, full_in.y);
        influence.tangential(full_in.x, full_in.y, full_out.x, full_out.y);
        gather(full_out.x, out.x);
        gather(full_out.y, out.y);
    }
    void gather(std::span<const double> from, std::vector<double>& to) const {
        for (const Run& run : runs) std::copy_n(&from[run.grid_first], run.size, &to[run.first]);
    }
};

/// Returns the mean of A_xx and A_yy of each element in contact on itself.
inline std::vector<double> tangential_diagonal(const InfluenceOperator& influence, const Contact& contact) {
    const std::vector<double> x = influence.diagonal(Axis::x), y = influence.diagonal(Axis::y);
    std::vector<double> mean;
    mean.reserve(contact.size());
    for (const std::size_t i : contact.elements) mean.push_back(0.5 * (x[i] + y[i]));
    return mean;
}

}  // namespace contactd
