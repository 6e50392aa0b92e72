#include "force_border.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

constexpr double outdated = 0.1;    // part of the division that may change before an update
constexpr double singular = 1e-10;  // sums in full slip, which rigid slip does not change

}  // namespace

ForceBorder::ForceBorder(const ForcesGiven& forces, std::size_t m) : forces_(forces), m_(m) {}

Pair ForceBorder::missing(const Field& p) const {
    return given(forces_.sum.x(), forces_.sum.y()) - sum(p);
}

Pair ForceBorder::sum(const Vectors& step) const {
    const Sums all = sums(m_, step);
    return given(all.x, all.y);
}

Pair ForceBorder::sum_of_free(const Linearisation& law, const Vectors& step) const {
    const Sums all = free_sums(m_, law.normal, step);
    return given(all.x, all.y);
}

void ForceBorder::prepare(Compliance& compliance, const Linearisation& law, int iteration) {
    if (is_made_ && static_cast<double>(changed_) <= outdated * static_cast<double>(m_)) return;
    is_made_ = true;
    changed_ = 0;
    Field unit(m_);
    for (const std::size_t k : {0u, 1u}) {
        if (!forces_.given[k]) continue;
        std::fill(unit.x.begin(), unit.x.end(), k == 0 ? 1.0 : 0.0);
        std::fill(unit.y.begin(), unit.y.end(), k == 1 ? 1.0 : 0.0);
        law.take_rows(unit);
        response_[k] = Field(m_);
        compliance.precondition(unit, response_[k], Compliance::Residual::later, iteration);
        const auto column = static_cast<Eigen::Index>(k);
        const Pair of_unit = sum(response_[k]);
        for (const Eigen::Index row : {0, 1})
            if (forces_.given[static_cast<std::size_t>(row)]) sums_(row, column) = of_unit[row];
    }
}

void ForceBorder::division_changed(const std::vector<char>& before, const std::vector<char>& after) {
    for (std::size_t e = 0; e < m_; ++e) changed_ += before[e] != after[e];
}

Pair ForceBorder::correct(Field& z, const Pair& missing) const {
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix2d> solver;
    solver.setThreshold(singular);
    const Pair rigid = solver.compute(sums_).solve(sum(z) - missing);
    for (const std::size_t k : {0u, 1u}) {
        if (!forces_.given[k]) continue;
        const double factor = rigid[static_cast<Eigen::Index>(k)];
        for (std::size_t e = 0; e < m_; ++e) {
            z.x[e] -= factor * response_[k].x[e];
            z.y[e] -= factor * response_[k].y[e];
        }
    }
    return rigid;
}

}  // namespace contactd
