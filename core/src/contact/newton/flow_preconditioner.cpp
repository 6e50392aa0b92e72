#include "flow_preconditioner.hpp"

#include <algorithm>

namespace contactd {
namespace {

constexpr double least_left = 0.2;  // least fraction of a diagonal that softening reduces

}  // namespace

FlowPreconditioner::FlowPreconditioner(const std::vector<double>& self, double soft, double close)
    : self_(self), soft_(soft), close_(close), rows_(self.size()), columns_(self.size()), rest_(self.size()) {}

void FlowPreconditioner::linearise(const Linearisation::Flow& flow) {
    flow_ = &flow;
    for (std::size_t e = 0; e < self_.size(); ++e) {
        const double soft = soft_ * self_[e], slope = flow.slope[e], unit = flow.unit[e];
        if (!(unit > 0)) continue;  // It has never flowed.
        const double hard = std::max(slope, 0.0);
        rows_[e] = slope > 0 ? soft / (unit * (1 + soft * hard)) : 0;
        columns_[e] = soft * hard / (1 + soft * hard);
        rest_[e] = (1 - columns_[e] * columns_[e]) / (unit * std::max(1 + close_ * self_[e] * slope, least_left));
    }
}

void FlowPreconditioner::scale_rows(const std::vector<double>& across, const Field& r, Field& to) const {
    for (std::size_t e = 0; e < self_.size(); ++e) {
        const double x = flow_->direction.x[e], y = flow_->direction.y[e];
        const double more = (rows_[e] - across[e]) * (r.x[e] * x + r.y[e] * y);
        to.x[e] = across[e] * r.x[e] + more * x;
        to.y[e] = across[e] * r.y[e] + more * y;
    }
}

void FlowPreconditioner::complete(const std::vector<double>& across, const std::vector<double>& rest, const Field& r,
                                  Field& z) const {
    for (std::size_t e = 0; e < self_.size(); ++e) {
        const double x = flow_->direction.x[e], y = flow_->direction.y[e];
        const double more =
            (columns_[e] - across[e]) * (z.x[e] * x + z.y[e] * y) + (rest_[e] - rest[e]) * (r.x[e] * x + r.y[e] * y);
        z.x[e] = across[e] * z.x[e] + rest[e] * r.x[e] + more * x;
        z.y[e] = across[e] * z.y[e] + rest[e] * r.y[e] + more * y;
    }
}

}  // namespace contactd
