#include "contactd/strip_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "contactd/error.hpp"

namespace contactd {
namespace {

constexpr std::array<Axis, 3> axes = {Axis::x, Axis::y, Axis::z};

// Returns -1 if exactly one of displacement and load is along `axis`, otherwise 1.
double sign_of(Axis axis, Axis i, Axis j) {
    return (i == axis) != (j == axis) ? -1 : 1;
}

std::string extent(const StripTable& table) {
    return std::to_string(table.strips) + " strips and " + std::to_string(table.nx) + " offsets along x";
}

}  // namespace

double StripTable::at(Axis i, Axis j, int I, int J, int k) const {
    const double value = (*this)(i, j, I, J, std::abs(k));
    return k < 0 ? parity(i, j).along_x * value : value;
}

StripTable cropped(const StripTable& table, int first, int strips, int nx, double factor, const Observer& observer) {
    if (first < 0 || strips > table.strips - first || nx > table.nx)
        throw InvalidArgument("grid", "needs " + std::to_string(strips) + " strips, starting at strip " +
                                          std::to_string(first) + ", and " + std::to_string(nx) +
                                          " offsets along x; the table contains " + extent(table));
    StripTable result;  // Its values are set below, so that large ones are written once.
    result.nx = nx;
    result.strips = strips;
    result.values = UnsetArray(9 * result.component_size());
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int I = 0; I < strips; ++I) {
                observer.throw_if_cancelled();
                for (int J = 0; J < strips; ++J) {
                    const double* from = &table.values[table.index(i, j, first + I, first + J, 0)];
                    std::transform(from, from + nx, &result.values[result.index(i, j, I, J, 0)],
                                   [factor](double value) { return value * factor; });
                }
            }
    return result;
}

StripTable strip_table_of(const IcTable& flat) {
    StripTable result(flat.nx, flat.ny);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int I = 0; I < flat.ny; ++I)
                for (int J = 0; J < flat.ny; ++J)
                    for (int k = 0; k < flat.nx; ++k) result(i, j, I, J, k) = flat.at(i, j, k, I - J);
    return result;
}

double reciprocity_defect(const StripTable& table) {
    double defect = 0, self = 0;
    for (int I = 0; I < table.strips; ++I) {
        self += table(Axis::z, Axis::z, I, I, 0) / table.strips;
        for (int J = 0; J <= I; ++J)
            for (const Axis i : axes)
                for (const Axis j : axes)
                    for (int k = 0; k < table.nx; ++k)
                        defect = std::max(defect, std::abs(table(i, j, I, J, k) - table.at(j, i, J, I, -k)));
    }
    return defect / self;
}

StripTable symmetrised(StripTable table) {
    for (const Axis i : axes)
        for (const Axis j : axes) {
            const double sign = parity(i, j).along_x;
            for (int I = 0; I < table.strips; ++I)
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

StripTable mirrored(const StripTable& table, const Observer& observer) {
    StripTable result(table.nx, table.strips);
    const int last = table.strips - 1;
    for (const Axis i : axes)
        for (const Axis j : axes) {
            const double sign = sign_of(Axis::y, i, j);
            for (int I = 0; I <= last; ++I) {
                observer.throw_if_cancelled();
                for (int J = 0; J <= last; ++J)
                    for (int k = 0; k < table.nx; ++k)
                        result(i, j, I, J, k) = sign * table(i, j, last - I, last - J, k);
            }
        }
    return result;
}

StripTable pair_of(const StripTable& upper, StripTable lower, const Observer& observer) {
    if (upper.nx != lower.nx || upper.strips != lower.strips)
        throw InvalidArgument("lower", "has " + extent(lower) + ", and upper has " + extent(upper) +
                                           "; both tables of a pair must have the same extent");
    const StripTable above = mirrored(upper, observer);
    for (const Axis i : axes)
        for (const Axis j : axes) {
            observer.throw_if_cancelled();
            const double sign = sign_of(Axis::z, i, j);
            for (std::size_t at = lower.index(i, j, 0, 0, 0), end = at + lower.component_size(); at < end; ++at)
                lower.values[at] += sign * above.values[at];
        }
    return lower;
}

}  // namespace contactd
