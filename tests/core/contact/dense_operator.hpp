// Represents a body whose coefficients are a matrix, as an operator without convolutions, coarser grids and boxes.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include "contact_cases.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/step_operator.hpp"
#include "influence/shifted_table.hpp"

namespace contactd::test {

/// Holds square matrices M[i,j], shape [n, n], of displacement i at an element for a traction along j on another.
class DenseMatrices {
   public:
    using Entry = std::function<double(Axis i, Axis j, std::size_t at, std::size_t from)>;
    DenseMatrices(std::size_t n, int displacements, const Entry& entry) : n_(n) {
        for (int i = 0; i < displacements; ++i)
            for (int j = 0; j < 3; ++j) {
                Values& matrix = values_[index(Axis(i), Axis(j))];
                for (std::size_t at = 0; at < n; ++at)
                    for (std::size_t from = 0; from < n; ++from) matrix.push_back(entry(Axis(i), Axis(j), at, from));
            }
    }
    std::size_t size() const { return n_; }
    double operator()(Axis i, Axis j, std::size_t at, std::size_t from) const {
        return values_[index(i, j)][at * n_ + from];
    }
    /// u = M[i,j] p, added to what u holds.
    void add(Axis i, Axis j, std::span<const double> p, std::span<double> u) const {
        for (std::size_t at = 0; at < n_; ++at)
            for (std::size_t from = 0; from < n_; ++from) u[at] += (*this)(i, j, at, from) * p[from];
    }

   private:
    static std::size_t index(Axis i, Axis j) { return 3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(j); }
    std::size_t n_;
    std::array<Values, 9> values_;
};

class DenseOperator final : public InfluenceOperator {
   public:
    explicit DenseOperator(DenseMatrices matrices) : A_(std::move(matrices)) {}

    std::size_t size() const override { return A_.size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override { sum(uz, {{Axis::z, pz}}, Axis::z); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        sum(ux, {{Axis::x, px}, {Axis::y, py}}, Axis::x);
        sum(uy, {{Axis::x, px}, {Axis::y, py}}, Axis::y);
    }
    bool coupled() const override { return true; }
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override {
        sum(uz, {{Axis::x, px}, {Axis::y, py}}, Axis::z);
    }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        sum(ux, {{Axis::z, pz}}, Axis::x);
        sum(uy, {{Axis::z, pz}}, Axis::y);
    }
    Values diagonal(Axis i) const override {
        Values values;
        for (std::size_t at = 0; at < size(); ++at) values.push_back(A_(i, i, at, at));
        return values;
    }
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override {
        for (std::size_t at = 0; at < size(); ++at) z[at] = r[at] / A_(i, i, at, at);
    }
    std::size_t bytes() const override { return 9 * size() * size() * sizeof(double); }

   private:
    using Loads = std::initializer_list<std::pair<Axis, std::span<const double>>>;
    void sum(std::span<double> u, const Loads& loads, Axis i) const {
        std::fill(u.begin(), u.end(), 0.0);
        for (const auto& [j, p] : loads) A_.add(i, j, p, u);
    }
    DenseMatrices A_;
};

class DenseStep final : public StepOperator {
   public:
    explicit DenseStep(DenseMatrices matrices) : C_(std::move(matrices)) {}

    std::size_t size() const override { return C_.size(); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        for (const auto& [i, u] : {std::pair{Axis::x, ux}, std::pair{Axis::y, uy}}) {
            std::fill(u.begin(), u.end(), 0.0);
            C_.add(i, Axis::x, px, u);
            C_.add(i, Axis::y, py, u);
        }
    }
    bool coupled() const override { return true; }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        for (const auto& [i, u] : {std::pair{Axis::x, ux}, std::pair{Axis::y, uy}}) {
            std::fill(u.begin(), u.end(), 0.0);
            C_.add(i, Axis::z, pz, u);
        }
    }
    std::size_t bytes() const override { return 6 * size() * size() * sizeof(double); }

   private:
    DenseMatrices C_;
};

/// Returns entries of tables, by the offset of the elements.
template <class Table>
DenseMatrices::Entry entries_of(const Table& table, const Grid& grid) {
    return [table, nx = grid.nx](Axis i, Axis j, std::size_t at, std::size_t from) {
        const int to = static_cast<int>(at), of = static_cast<int>(from);
        const int k = to % nx - of % nx, l = to / nx - of / nx;
        if constexpr (requires { table.at(i, j, k, l); })
            return table.at(i, j, k, l);
        else
            return table(i, j, k, l);
    };
}

}  // namespace contactd::test
