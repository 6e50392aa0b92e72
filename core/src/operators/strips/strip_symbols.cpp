#include "strip_symbols.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace contactd {
namespace {

constexpr std::size_t lanes = Waves::lanes;

void write_lanes(std::span<const double> transform, std::size_t step, double* to) {
    for (std::size_t at = 0; at < transform.size(); at += lanes, to += step) std::copy_n(&transform[at], lanes, to);
}

// Calls product(group, matrix, in_re, in_im, out_re, out_im) for each group, whose matrix begins at first[group].
template <class Product>
void for_groups(const std::vector<std::size_t>& first, const SymbolNumbers& values, const Waves& in, Waves& out,
                const Product& product) {
    const std::size_t from = in.entries * lanes, to = out.entries * lanes;
    const auto each = [&](const auto* numbers) {
        for (std::size_t group = 0; group < first.size(); ++group)
            product(group, numbers + first[group], &in.re[group * from], &in.im[group * from], &out.re[group * to],
                    &out.im[group * to]);
    };
    if (values.rounded.empty())
        each(values.exact.data());
    else
        each(values.rounded.data());
}

// Returns the largest sum of moduli over the wavenumbers of both signs, which bounds every coefficient.
double largest_coefficient(const std::vector<double>& values, std::size_t groups) {
    const std::size_t matrix = values.size() / groups;
    std::vector<double> sums(matrix);
    for (std::size_t group = 0; group < groups; ++group)
        for (std::size_t at = 0; at < matrix; ++at) sums[at] += 2 * std::abs(values[group * matrix + at]);
    double largest = 0;
    for (std::size_t at = 0; at < matrix; at += lanes)
        largest = std::max(largest, sums[at] + sums[at + 1] + sums[at + 2] + sums[at + 3]);
    return largest;
}

// Returns the number of groups, from the smallest wavenumbers on, that two adjacent entries from `at` on need in each
// group, so that the moduli of the others sum to at most `left_out` for each. Wavenumbers represent those of both
// signs.
std::size_t groups_needed(const std::vector<double>& values, std::size_t groups, std::size_t at, double left_out) {
    const std::size_t matrix = values.size() / groups;
    double a = 0, b = 0;
    for (std::size_t group = groups; group > 0; --group) {
        const double* entries = &values[(group - 1) * matrix + at];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            a += 2 * std::abs(entries[lane]);
            b += 2 * std::abs(entries[lanes + lane]);
        }
        if (std::max(a, b) > left_out) return group;
    }
    return 0;
}

std::size_t numbers_before(std::size_t row) {
    return row * (row + 1) / 2;
}

// Moves kept numbers to the front, and rounds them at the end if that changes coefficients by at most half of
// `left_out`. The other half is for omitted numbers.
class Packing {
   public:
    Packing(SymbolNumbers& values, std::size_t groups, double left_out)
        : values_(values),
          rounds_(SymbolNumbers::may_be_rounded(largest_coefficient(values.exact, groups), left_out)) {}
    Packing(const Packing&) = delete;
    Packing& operator=(const Packing&) = delete;

    std::size_t size() const { return size_; }
    void keep(std::size_t at, std::size_t numbers) {
        double* values = values_.exact.data();
        std::copy_n(values + at, numbers, values + size_);
        size_ += numbers;
    }
    void finish() {
        values_.exact.resize(size_);
        if (rounds_) {
            values_.rounded.assign(values_.exact.begin(), values_.exact.end());
            values_.exact.clear();
        }
        values_.exact.shrink_to_fit();
    }

   private:
    SymbolNumbers& values_;
    const bool rounds_;
    std::size_t size_ = 0;
};

SymbolNumbers zeros(std::size_t size, bool rounded) {
    if (rounded) return {{}, std::vector<float>(size)};
    return {std::vector<double>(size), {}};
}

}  // namespace

bool SymbolNumbers::may_be_rounded(double largest, double left_out) {
    constexpr double unit_roundoff = 0.5 * std::numeric_limits<float>::epsilon();
    return largest * unit_roundoff <= 0.5 * left_out;
}

SymmetricSymbol::SymmetricSymbol(std::size_t groups, std::size_t entries, std::vector<std::size_t> begin, bool rounded)
    : groups_(groups), entries_(entries), begin_(std::move(begin)), group_(groups) {
    const std::size_t pairs = entries / 2;
    std::size_t size = 0;
    for (std::size_t group = 0; group < groups; ++group) {
        group_[group] = size;
        for (std::size_t pair = 0; pair < pairs; ++pair)
            size += (4 * pair + 3 - 2 * begin_[group * pairs + pair]) * lanes;
    }
    values_ = zeros(size, rounded);
}

SymmetricSymbol::SymmetricSymbol(std::size_t groups, std::size_t entries)
    : groups_(groups),
      entries_(entries),
      values_{std::vector<double>(groups * numbers_before(entries) * lanes), {}},
      begin_(groups * entries / 2),
      group_(groups) {
    for (std::size_t group = 0; group < groups; ++group) group_[group] = group * numbers_before(entries) * lanes;
}

void SymmetricSymbol::set(std::size_t row, std::size_t column, std::span<const double> transform) {
    const std::size_t a = std::max(row, column), b = std::min(row, column), first = a - a % 2;
    const std::size_t within = b < first ? 2 * b + a % 2 : 2 * first + a % 2 + b % 2;
    write_lanes(transform, numbers_before(entries_) * lanes, &values_.exact[(numbers_before(first) + within) * lanes]);
}

void SymmetricSymbol::trim(double left_out) {
    const std::size_t pairs = entries_ / 2, matrix = numbers_before(entries_) * lanes;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        std::size_t needed = 0;  // groups needed by any strip up to this one
        for (std::size_t column = 0; column < 2 * pair && needed < groups_; ++column) {
            const std::size_t at = (numbers_before(2 * pair) + 2 * column) * lanes;
            const std::size_t more = std::max(needed, groups_needed(values_.exact, groups_, at, 0.5 * left_out));
            for (; needed < more; ++needed) begin_[needed * pairs + pair] = column;
        }
        for (; needed < groups_; ++needed) begin_[needed * pairs + pair] = 2 * pair;
    }
    Packing packing(values_, groups_, left_out);
    for (std::size_t group = 0; group < groups_; ++group) {
        group_[group] = packing.size();
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            const std::size_t left = 2 * begin_[group * pairs + pair] * lanes;
            packing.keep(group * matrix + numbers_before(2 * pair) * lanes + left, (4 * pair + 3) * lanes - left);
        }
    }
    packing.finish();
}

void SymmetricSymbol::multiply(const Waves& in, Waves& out) const {
    for_groups(group_, values_, in, out, [this](std::size_t group, auto... arrays) {
        multiply_symmetric(entries_, &begin_[group * entries_ / 2], arrays...);
    });
}

RectangularSymbol::RectangularSymbol(std::size_t groups, std::size_t rows, std::size_t columns)
    : groups_(groups),
      rows_(rows),
      columns_(columns),
      values_{std::vector<double>(groups * rows * columns * lanes), {}},
      ranges_(groups * rows / 2, {0, columns}),
      group_(groups) {
    for (std::size_t group = 0; group < groups; ++group) group_[group] = group * rows * columns * lanes;
}

RectangularSymbol::RectangularSymbol(std::size_t groups, std::size_t rows, std::size_t columns,
                                     std::vector<EntryRange> ranges, bool rounded)
    : groups_(groups), rows_(rows), columns_(columns), ranges_(std::move(ranges)), group_(groups) {
    const std::size_t pairs = rows / 2;
    std::size_t size = 0;
    for (std::size_t group = 0; group < groups; ++group) {
        group_[group] = size;
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            const EntryRange& kept = ranges_[group * pairs + pair];
            size += 2 * (kept.end - kept.begin) * lanes;
        }
    }
    values_ = zeros(size, rounded);
}

void RectangularSymbol::set(std::size_t row, std::size_t column, std::span<const double> transform) {
    const std::size_t at = ((row - row % 2) * columns_ + 2 * column + row % 2) * lanes;
    write_lanes(transform, rows_ * columns_ * lanes, &values_.exact[at]);
}

void RectangularSymbol::trim(double left_out) {
    const std::size_t pairs = rows_ / 2, matrix = rows_ * columns_ * lanes;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        for (std::size_t group = 0; group < groups_; ++group) ranges_[group * pairs + pair] = {columns_, columns_};
        for (std::size_t column = 0; column < columns_; ++column) {
            const std::size_t at = 2 * (pair * columns_ + column) * lanes;
            const std::size_t needed = groups_needed(values_.exact, groups_, at, 0.5 * left_out);
            for (std::size_t group = 0; group < needed; ++group) {
                EntryRange& kept = ranges_[group * pairs + pair];
                kept = {std::min(kept.begin, column), column + 1};
            }
        }
    }
    Packing packing(values_, groups_, left_out);
    for (std::size_t group = 0; group < groups_; ++group) {
        group_[group] = packing.size();
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            EntryRange& kept = ranges_[group * pairs + pair];
            kept.end = std::max(kept.begin, kept.end);
            packing.keep(group * matrix + 2 * (pair * columns_ + kept.begin) * lanes,
                         2 * (kept.end - kept.begin) * lanes);
        }
    }
    packing.finish();
}

void RectangularSymbol::multiply(const Waves& in, Waves& out) const {
    for_groups(group_, values_, in, out, [this](std::size_t group, auto... arrays) {
        multiply_rows(rows_, &ranges_[group * rows_ / 2], arrays...);
    });
}

void RectangularSymbol::multiply_transposed(const Waves& in, Waves& out) const {
    for_groups(group_, values_, in, out, [this](std::size_t group, auto... arrays) {
        multiply_columns(rows_, columns_, &ranges_[group * rows_ / 2], arrays...);
    });
}

}  // namespace contactd
