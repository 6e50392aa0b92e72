#include "contactd/column_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "contactd/error.hpp"

namespace contactd {
namespace {

constexpr std::array<Axis, 3> axes = {Axis::x, Axis::y, Axis::z};

// -1 where displacement and load are one along `axis` and one across it.
double sign_of(Axis axis, Axis i, Axis j) {
    return (i == axis) != (j == axis) ? -1 : 1;
}

std::string extent(const ColumnTable& table) {
    return std::to_string(table.columns) + " columns and " + std::to_string(table.nx) + " offsets along x";
}

}  // namespace

double ColumnTable::at(Axis i, Axis j, int I, int J, int k) const {
    const double value = (*this)(i, j, I, J, std::abs(k));
    return k < 0 ? parity(i, j).along_x * value : value;
}

ColumnTable cropped(const ColumnTable& table, int first, int columns, int nx, double factor) {
    if (first < 0 || columns > table.columns - first || nx > table.nx)
        throw InvalidArgument("grid", "needs " + std::to_string(columns) + " columns from column " +
                                          std::to_string(first) + " on and " + std::to_string(nx) +
                                          " offsets along x; the table holds " + extent(table));
    ColumnTable result(nx, columns);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int I = 0; I < columns; ++I)
                for (int J = 0; J < columns; ++J) {
                    const double* from = &table.values[table.index(i, j, first + I, first + J, 0)];
                    std::transform(from, from + nx, &result.values[result.index(i, j, I, J, 0)],
                                   [factor](double value) { return value * factor; });
                }
    return result;
}

ColumnTable column_table_of(const IcTable& flat) {
    ColumnTable result(flat.nx, flat.ny);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int I = 0; I < flat.ny; ++I)
                for (int J = 0; J < flat.ny; ++J)
                    for (int k = 0; k < flat.nx; ++k) result(i, j, I, J, k) = flat.at(i, j, k, I - J);
    return result;
}

double reciprocity_defect(const ColumnTable& table) {
    double defect = 0, self = 0;
    for (int I = 0; I < table.columns; ++I) {
        self += table(Axis::z, Axis::z, I, I, 0) / table.columns;
        for (int J = 0; J <= I; ++J)
            for (const Axis i : axes)
                for (const Axis j : axes)
                    for (int k = 0; k < table.nx; ++k)
                        defect = std::max(defect, std::abs(table(i, j, I, J, k) - table.at(j, i, J, I, -k)));
    }
    return defect / self;
}

ColumnTable symmetrised(ColumnTable table) {
    for (const Axis i : axes)
        for (const Axis j : axes) {
            const double sign = parity(i, j).along_x;
            for (int I = 0; I < table.columns; ++I)
                for (int J = 0; J <= I; ++J)
                    for (int k = 0; k < table.nx; ++k) {
                        double &here = table(i, j, I, J, k), &there = table(j, i, J, I, k);
                        const double mean = 0.5 * (here + sign * there);
                        here = mean;
                        there = sign * mean;
                    }
        }
    return table;
}

ColumnTable mirrored(const ColumnTable& table) {
    ColumnTable result(table.nx, table.columns);
    const int last = table.columns - 1;
    for (const Axis i : axes)
        for (const Axis j : axes) {
            const double sign = sign_of(Axis::y, i, j);
            for (int I = 0; I <= last; ++I)
                for (int J = 0; J <= last; ++J)
                    for (int k = 0; k < table.nx; ++k)
                        result(i, j, I, J, k) = sign * table(i, j, last - I, last - J, k);
        }
    return result;
}

ColumnTable pair_of(const ColumnTable& upper, ColumnTable lower) {
    if (upper.nx != lower.nx || upper.columns != lower.columns)
        throw InvalidArgument("lower", "has " + extent(lower) + ", and upper " + extent(upper) +
                                           "; the tables of a pair must have the same");
    const ColumnTable above = mirrored(upper);
    for (const Axis i : axes)
        for (const Axis j : axes) {
            const double sign = sign_of(Axis::z, i, j);
            for (std::size_t at = lower.index(i, j, 0, 0, 0), end = at + lower.component_size(); at < end; ++at)
                lower.values[at] += sign * above.values[at];
        }
    return lower;
}

}  // namespace contactd
