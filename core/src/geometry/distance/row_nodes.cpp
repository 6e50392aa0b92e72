#include "row_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contactd::geometry {
namespace {

constexpr std::size_t last = RowNodes::count - 1;

/// Returns the nodes on [-1, 1], by descending x.
RowNodes::Values unit_nodes() {
    RowNodes::Values nodes;
    for (std::size_t j = 0; j <= last; ++j) nodes[j] = std::cos(std::numbers::pi * static_cast<double>(j) / last);
    return nodes;
}

/// Returns the size of the term of degree k in the polynomial through the values.
double part_of(const RowNodes::Values& values, std::size_t k) {
    double sum = 0;
    for (std::size_t j = 0; j <= last; ++j) {
        const double share = j == 0 || j == last ? 0.5 : 1;
        sum += share * values[j] * std::cos(std::numbers::pi * static_cast<double>(j * k) / last);
    }
    return std::abs(sum) * (k == last ? 1 : 2) / last;
}

}  // namespace

// The barycentric formula has weights 1, -1, 1, ... over distances, halved at both ends.
RowNodes::RowNodes(double x0, double dx, int n) {
    const Values nodes = unit_nodes();
    const double half = 0.5 * (n - 1) * dx;
    for (std::size_t j = 0; j <= last; ++j) x_[j] = x0 + half + half * nodes[j];
    weights_.resize(static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        const double at = 2.0 * static_cast<double>(i) / (n - 1) - 1;
        Values& weights = weights_[i];
        double sum = 0;
        for (std::size_t j = 0; j <= last; ++j) {
            const double distance = at - nodes[j];
            if (std::abs(distance) < 1e-14) {
                weights.fill(0);
                weights[j] = sum = 1;
                break;
            }
            weights[j] = (j % 2 == 0 ? 1 : -1) * (j == 0 || j == last ? 0.5 : 1) / distance;
            sum += weights[j];
        }
        for (double& weight : weights) weight /= sum;
    }
}

bool RowNodes::smooth(const Values& values, double settled) {
    return part_of(values, last) <= settled && part_of(values, last - 1) <= settled;
}

void RowNodes::interpolate(const Values& values, std::vector<double>& row) const {
    for (const Values& weights : weights_) {
        double sum = 0;
        for (std::size_t j = 0; j <= last; ++j) sum += weights[j] * values[j];
        row.push_back(sum);
    }
}

}  // namespace contactd::geometry
