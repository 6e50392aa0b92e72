#include "contactd/ic_table.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "contactd/error.hpp"

namespace contactd {

double IcTable::at(Axis i, Axis j, int k, int l) const {
    const auto [along_x, along_y] = parity(i, j);
    const int sign = (k < 0 ? along_x : 1) * (l < 0 ? along_y : 1);
    return sign * (*this)(i, j, std::abs(k), std::abs(l));
}

IcTable scaled(const IcTable& table, double factor) {
    IcTable result = table;
    for (double& value : result.values) value *= factor;
    return result;
}

IcTable cropped(const IcTable& table, int nx, int ny, double factor) {
    if (nx > table.nx || ny > table.ny)
        throw InvalidArgument("grid", "needs offsets up to " + std::to_string(nx) + " x " + std::to_string(ny) +
                                          "; the table holds " + std::to_string(table.nx) + " x " +
                                          std::to_string(table.ny));
    IcTable result(nx, ny);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int l = 0; l < ny; ++l) {
                const auto from =
                    table.values.begin() + static_cast<std::ptrdiff_t>(table.index(Axis(i), Axis(j), 0, l));
                const auto to =
                    result.values.begin() + static_cast<std::ptrdiff_t>(result.index(Axis(i), Axis(j), 0, l));
                std::transform(from, from + nx, to, [factor](double value) { return value * factor; });
            }
    return result;
}

IcTable pair_of(IcTable upper, const IcTable& lower) {
    if (upper.nx != lower.nx || upper.ny != lower.ny)
        throw InvalidArgument("lower", "has a different extent than upper; both tables of a pair must have the same");
    const std::size_t n = upper.component_size();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const double sign = ((i == 2) != (j == 2)) ? -1 : 1;
            const std::size_t first = (3 * i + j) * n;
            for (std::size_t at = first; at < first + n; ++at)
                upper.values[at] = lower.values[at] + sign * upper.values[at];
        }
    return upper;
}

}  // namespace contactd
