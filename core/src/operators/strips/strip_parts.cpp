#include "strip_parts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/given_ics.hpp"

namespace contactd {
namespace {

using enum Axis;

bool couples(const StripTable& table) {
    double self = 0, largest = 0;
    for (int I = 0; I < table.strips; ++I) self = std::max(self, table(z, z, I, I, 0));
    for (const auto& [i, j] : {std::pair{x, z}, {y, z}, {z, x}, {z, y}}) {
        const double* values = &table.values[table.index(i, j, 0, 0, 0)];
        for (std::size_t at = 0; at < table.component_size(); ++at) largest = std::max(largest, std::abs(values[at]));
    }
    return largest > coupling_tolerance * self;
}

}  // namespace

StripParts::StripParts(StripTable table, int nx, OffsetParity parity, double left_out)
    : nx_(nx), parity_(parity), coupled_(couples(table)), left_out_(left_out) {
    if (table.nx < nx)
        throw InvalidArgument("grid", "needs offsets up to " + std::to_string(nx) + " along x; the table holds " +
                                          std::to_string(table.nx));
    table_ = std::make_shared<const StripTable>(std::move(table));
}

std::shared_ptr<const StripProducts> StripParts::on(const ElementBox& box) const {
    const ElementBox part{0, box.first_y, box.nx, box.ny};
    return cache_.get(part, [&] {
        return std::make_shared<const StripProducts>(table_, part, table_->nx - nx_, parity_, left_out_);
    });
}

std::size_t StripParts::bytes_of(int nx, int strips) {
    constexpr std::size_t of_table = 9, of_symbols = 7, of_boxes = 4;  // numbers a pair of strips and an offset
    return static_cast<std::size_t>(nx) * static_cast<std::size_t>(strips) * static_cast<std::size_t>(strips) *
           (of_table + of_symbols + of_boxes) * sizeof(double);
}

std::size_t StripParts::bytes() const {
    return bytes_of(table_->nx, table_->strips);
}

StripTable StripParts::coarse(const ElementBox& box, int along_x, int along_y) const {
    const auto number = [](int n, int factor) { return (n + factor - 1) / factor; };
    StripTable result(number(box.nx, along_x), number(box.ny, along_y));
    // A pair of strips of which one lies beyond the last: both moved back by that much.
    const auto values_of = [&](Axis i, Axis j, int I, int J) {
        const int beyond = std::max({I - (box.ny - 1), J - (box.ny - 1), 0});
        const int at = box.first_y + std::max(I - beyond, 0), from = box.first_y + std::max(J - beyond, 0);
        return &table_->values[table_->index(i, j, at, from, 0)];
    };
    const int last = table_->nx - 1;
    std::vector<double> sums(static_cast<std::size_t>(table_->nx));  // over the pairs of strips of one coarse pair
    const auto fill = [&](Axis i, Axis j, int I, int J) {
        std::fill(sums.begin(), sums.end(), 0.0);
        for (int a = 0; a < along_y; ++a)
            for (int b = 0; b < along_y; ++b) {
                const double* values = values_of(i, j, I * along_y + a, J * along_y + b);
                for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += values[k];
            }
        const double sign = parity(i, j).along_x;
        double* mean = &result(i, j, I, J, 0);
        for (int k = 1 - along_x; k < along_x; ++k) {
            const double weight = static_cast<double>(along_x - std::abs(k)) / along_x / along_y;
            for (int K = 0; K < result.nx; ++K) {
                const int offset = std::min(K * along_x + k, last);
                const double sum = sums[static_cast<std::size_t>(std::abs(offset))];
                mean[K] += weight * (offset < 0 ? sign * sum : sum);
            }
        }
    };
    const auto components = coupled_ ? std::vector{x, y, z} : std::vector{x, y};
    for (int I = 0; I < result.strips; ++I)
        for (int J = 0; J < result.strips; ++J) {
            for (const Axis i : components)
                for (const Axis j : components) fill(i, j, I, J);
            if (!coupled_) fill(z, z, I, J);
        }
    return result;
}

}  // namespace contactd
