#include "periodic_joint.hpp"

#include <algorithm>

namespace contactd {
namespace {

constexpr std::size_t most_nodes = 6;  // nodes of either sign: with fewer it is less smooth, and more do not help

}  // namespace

// The nodes are the last values at offsets - nodes .. offsets - 1, and those at minus these offsets, a period later.
PeriodicJoint::PeriodicJoint(std::size_t offsets, std::size_t period)
    : offsets_(offsets), nodes_(std::min(most_nodes, offsets - 1)) {
    if (nodes_ == 0) return;
    const auto node = [&](std::size_t at) {
        const double distance = static_cast<double>(offsets - nodes_ + at % nodes_);
        return at < nodes_ ? distance : static_cast<double>(period) - distance;
    };
    for (std::size_t place = offsets; place <= period / 2; ++place)
        for (std::size_t at = 0; at < 2 * nodes_; ++at) {
            double weight = 1;
            for (std::size_t other = 0; other < 2 * nodes_; ++other)
                if (other != at) weight *= (static_cast<double>(place) - node(other)) / (node(at) - node(other));
            (at < nodes_ ? positive_ : negative_).push_back(weight);
        }
}

void PeriodicJoint::fill(std::span<double> values, bool even) const {
    if (nodes_ == 0) return;
    const double sign = even ? 1 : -1;
    for (std::size_t place = 0; place * nodes_ < positive_.size(); ++place) {
        double value = 0;
        for (std::size_t at = 0; at < nodes_; ++at)
            value += (positive_[place * nodes_ + at] + sign * negative_[place * nodes_ + at]) *
                     values[offsets_ - nodes_ + at];
        values[values.size() - offsets_ - place] = sign * value;
        values[offsets_ + place] = value;
    }
}

std::size_t PeriodicJoint::least_period(std::size_t offsets) {
    return 2 * offsets - 1 + std::max<std::size_t>(8, offsets / 5);
}

}  // namespace contactd
