// The elements of a given contact area and vector fields on them, as the tangential solver uses them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

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
    return dot(a.x, b.x) + dot(a.y, b.y);
}

// The elements of the contact area, 0..m-1, with everything the problem says of them.
struct Contact {
    std::vector<std::size_t> elements;
    std::vector<double> bound;
    Field rigid;

    Contact(std::span<const double> g, std::span<const double> wx, std::span<const double> wy) {
        for (std::size_t i = 0; i < g.size(); ++i) {
            if (!(g[i] > 0)) continue;
            elements.push_back(i);
            bound.push_back(g[i]);
            rigid.x.push_back(wx[i]);
            rigid.y.push_back(wy[i]);
        }
    }
    std::size_t size() const { return elements.size(); }

    void scatter(const std::vector<double>& from, std::vector<double>& to) const {
        for (std::size_t e = 0; e < size(); ++e) to[elements[e]] = from[e];
    }
    /// out = `influence` times in, tangential components; the full fields are scratch of the grid's size, zero outside.
    template <class Influence>
    void product(const Influence& influence, const Field& in, Field& full_in, Field& full_out, Field& out) const {
        scatter(in.x, full_in.x);
        scatter(in.y, full_in.y);
        influence.tangential(full_in.x, full_in.y, full_out.x, full_out.y);
        gather(full_out.x, out.x);
        gather(full_out.y, out.y);
    }
    void gather(std::span<const double> from, std::vector<double>& to) const {
        for (std::size_t e = 0; e < size(); ++e) to[e] = from[elements[e]];
    }
};

}  // namespace contactd
