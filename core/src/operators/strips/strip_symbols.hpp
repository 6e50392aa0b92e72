// Symbols of strip tables: one real matrix a wavenumber, and their products with waves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "strip_fft.hpp"
#include "strip_kernels.hpp"

namespace contactd {

/// Reading them is what products take most of their time for.
struct SymbolNumbers {
    std::vector<double> exact;   // empty when they are rounded
    std::vector<float> rounded;  // empty when they are exact

    std::size_t size() const { return exact.size() + rounded.size(); }
};

/// Symmetric matrices, each number once. Entries are an even number, as those of waves.
class SymmetricSymbol {
   public:
    SymmetricSymbol() = default;
    SymmetricSymbol(std::size_t groups, std::size_t entries);

    /// `transform` as of StripFft::symbol.
    void set(std::size_t row, std::size_t column, std::span<const double> transform);
    /// The numbers of a group's matrix, to be filled in their order before trim: of two rows after each other, the
    /// pairs of a column side by side, up to the diagonal; four wavenumbers each.
    double* matrix(std::size_t group) { return values_.exact.data() + group_[group]; }
    /// Leaves out large wavenumbers of entries far from the diagonal, and rounds the others to single precision, as far
    /// as no coefficient changes by more than `left_out`. Call it once, after the last set.
    void trim(double left_out);
    /// out = M in
    void multiply(const Waves& in, Waves& out) const;
    /// That are kept, each once.
    std::size_t numbers() const { return values_.size(); }

   private:
    std::size_t groups_ = 0, entries_ = 0;
    SymbolNumbers values_;  // [group]; of two rows after each other, the pairs of a strip side by side; [lane]
    std::vector<std::size_t> begin_;  // [group][pair of rows]: the first strip that is kept
    std::vector<std::size_t> group_;  // where in values_ a group begins
};

/// A symbol of any shape with an even number of rows.
class RectangularSymbol {
   public:
    RectangularSymbol() = default;
    RectangularSymbol(std::size_t groups, std::size_t rows, std::size_t columns);

    void set(std::size_t row, std::size_t column, std::span<const double> transform);
    /// The numbers of a group's matrix, to be filled before trim: [pair of rows][column][row of the pair][lane].
    double* matrix(std::size_t group) { return values_.exact.data() + group_[group]; }
    void trim(double left_out);
    /// out = M in
    void multiply(const Waves& in, Waves& out) const;
    /// out = M' in
    void multiply_transposed(const Waves& in, Waves& out) const;
    std::size_t numbers() const { return values_.size(); }

   private:
    std::size_t groups_ = 0, rows_ = 0, columns_ = 0;
    SymbolNumbers values_;            // [group][pair of rows][strip][row of the pair][lane]
    std::vector<EntryRange> ranges_;  // [group][pair of rows]
    std::vector<std::size_t> group_;  // where in values_ a group begins
};

}  // namespace contactd
