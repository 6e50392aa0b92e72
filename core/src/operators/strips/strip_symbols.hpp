// Defines symbols of strip tables: one real matrix for each wavenumber, and their products with waves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "strip_fft.hpp"
#include "strip_kernels.hpp"

namespace contactd {

/// Products spend most of their time reading these numbers.
struct SymbolNumbers {
    std::vector<double> exact;   // empty if they are rounded
    std::vector<float> rounded;  // empty if they are exact

    std::size_t size() const { return exact.size() + rounded.size(); }
    /// Returns whether single precision changes no coefficient by more than half of `left_out`; the other half is for
    /// omitted numbers. No coefficient is larger than `largest`.
    static bool may_be_rounded(double largest, double left_out);
};

/// Holds symmetric matrices, with each number once. Entries are an even number, like those of waves.
class SymmetricSymbol {
   public:
    SymmetricSymbol() = default;
    SymmetricSymbol(std::size_t groups, std::size_t entries);
    /// Creates a trimmed symbol: `begin` is as begin_ below. The numbers of the matrices are zeros, to be filled by
    /// fill().
    SymmetricSymbol(std::size_t groups, std::size_t entries, std::vector<std::size_t> begin, bool rounded);

    /// Calls each(group, begin of its pairs of rows, double* or float* of its numbers) for each group.
    template <class Each>
    void fill(const Each& each) {
        for (std::size_t group = 0; group < groups_; ++group) {
            const std::size_t* begin = begin_.data() + group * entries_ / 2;
            if (values_.rounded.empty())
                each(group, begin, values_.exact.data() + group_[group]);
            else
                each(group, begin, values_.rounded.data() + group_[group]);
        }
    }

    /// Sets an entry; `transform` is as in StripFft::symbol.
    void set(std::size_t row, std::size_t column, std::span<const double> transform);
    /// Omits large wavenumbers of entries far from the diagonal, and rounds the others to single precision, as far as
    /// no coefficient changes by more than `left_out`. Call it once, after the last set.
    void trim(double left_out);
    /// Computes out = M in.
    void multiply(const Waves& in, Waves& out) const;
    /// Returns the number of kept numbers, each counted once.
    std::size_t numbers() const { return values_.size(); }

   private:
    std::size_t groups_ = 0, entries_ = 0;
    SymbolNumbers values_;            // [group]; for two successive rows, the pairs of a strip are adjacent; [lane]
    std::vector<std::size_t> begin_;  // [group][pair of rows]: the first strip that is kept
    std::vector<std::size_t> group_;  // start of each group in values_
};

/// Holds a symbol of any shape with an even number of rows.
class RectangularSymbol {
   public:
    RectangularSymbol() = default;
    RectangularSymbol(std::size_t groups, std::size_t rows, std::size_t columns);
    /// Creates a trimmed symbol: `ranges` is as ranges_ below. The numbers of the matrices are zeros, to be filled by
    /// fill().
    RectangularSymbol(std::size_t groups, std::size_t rows, std::size_t columns, std::vector<EntryRange> ranges,
                      bool rounded);

    /// Calls each(group, ranges of its pairs of rows, double* or float* of its numbers) for each group.
    template <class Each>
    void fill(const Each& each) {
        for (std::size_t group = 0; group < groups_; ++group) {
            const EntryRange* ranges = ranges_.data() + group * rows_ / 2;
            if (values_.rounded.empty())
                each(group, ranges, values_.exact.data() + group_[group]);
            else
                each(group, ranges, values_.rounded.data() + group_[group]);
        }
    }

    void set(std::size_t row, std::size_t column, std::span<const double> transform);
    void trim(double left_out);
    /// Computes out = M in.
    void multiply(const Waves& in, Waves& out) const;
    /// Computes out = M' in.
    void multiply_transposed(const Waves& in, Waves& out) const;
    std::size_t numbers() const { return values_.size(); }

   private:
    std::size_t groups_ = 0, rows_ = 0, columns_ = 0;
    SymbolNumbers values_;            // [group][pair of rows][strip][row of the pair][lane]
    std::vector<EntryRange> ranges_;  // [group][pair of rows]
    std::vector<std::size_t> group_;  // start of each group in values_
};

}  // namespace contactd
