#include "row_rotations.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {

RowRotations::RowRotations(std::span<const double> angles, int nx)
    : nx_(static_cast<std::size_t>(nx)), angles_(angles.begin(), angles.end()) {
    for (const double angle : angles_) {
        cosine_.push_back(std::cos(angle));
        sine_.push_back(std::sin(angle));
    }
}

RowRotations RowRotations::on(int first_row, int rows, int nx) const {
    return {std::span(angles_).subspan(static_cast<std::size_t>(first_row), static_cast<std::size_t>(rows)), nx};
}

RowRotations RowRotations::coarse(int along_x, int along_y) const {
    std::vector<double> means;
    const std::size_t several = static_cast<std::size_t>(along_y);
    for (std::size_t first = 0; first < angles_.size(); first += several) {
        const std::size_t end = std::min(first + several, angles_.size());
        double sum = 0;
        for (std::size_t row = first; row < end; ++row) sum += angles_[row];
        means.push_back(sum / static_cast<double>(end - first));
    }
    return {means, (static_cast<int>(nx_) + along_x - 1) / along_x};
}

std::vector<double> RowRotations::times(const std::vector<double>& factor, std::span<const double> values) const {
    std::vector<double> result(values.begin(), values.end());
    for (std::size_t at = 0; at < result.size(); ++at) result[at] *= factor[at / nx_];
    return result;
}

void RowRotations::along_z(const RowComponents& of_cosine, const RowComponents& of_sine, std::span<double> z) const {
    for (std::size_t at = 0; at < z.size(); ++at) {
        const std::size_t row = at / nx_;
        const double s = of_cosine.s[at] + of_sine.z[at], n = of_cosine.z[at] - of_sine.s[at];
        z[at] = sine_[row] * s + cosine_[row] * n;
    }
}

void RowRotations::along_s(const RowComponents& of_cosine, const RowComponents& of_sine, std::span<double> s) const {
    for (std::size_t at = 0; at < s.size(); ++at) {
        const std::size_t row = at / nx_;
        const double along = of_cosine.s[at] + of_sine.z[at], n = of_cosine.z[at] - of_sine.s[at];
        s[at] = cosine_[row] * along - sine_[row] * n;
    }
}

}  // namespace contactd
