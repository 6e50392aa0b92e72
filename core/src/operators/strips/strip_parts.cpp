#include "strip_parts.hpp"

#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "table_coefficients.hpp"

namespace contactd {

StripParts::StripParts(std::shared_ptr<const StripCoefficients> coefficients, int nx, OffsetParity parity,
                       double left_out)
    : coefficients_(std::move(coefficients)), nx_(nx), parity_(parity), left_out_(left_out) {
    if (coefficients_->offsets() < nx)
        throw InvalidArgument("grid", "needs offsets up to " + std::to_string(nx) + " along x; the table contains " +
                                          std::to_string(coefficients_->offsets()));
}

StripParts::StripParts(StripTable table, int nx, OffsetParity parity, double left_out)
    : StripParts(std::make_shared<const TableCoefficients>(std::move(table)), nx, parity, left_out) {}

std::shared_ptr<const StripProducts> StripParts::on(const ElementBox& box) const {
    const ElementBox part{0, box.first_y, box.nx, box.ny};
    return cache_.get(
        part, [&] { return std::make_shared<const StripProducts>(coefficients_, part, reach(), parity_, left_out_); });
}

std::shared_ptr<const StripParts> StripParts::coarse(const ElementBox& box, int along_x, int along_y) const {
    const std::shared_ptr<const StripCoefficients> coarser = coefficients_->coarse(box, along_x, along_y);
    return std::make_shared<const StripParts>(coarser, coarser->offsets(), parity_, left_out_);
}

}  // namespace contactd
