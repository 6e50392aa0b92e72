// Symbols of column tables: one real matrix a wavenumber, and their products with waves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "column_fft.hpp"

namespace contactd {

/// Symmetric matrices, each number once. Entries are an even number, as those of waves.
class SymmetricSymbol {
   public:
    SymmetricSymbol() = default;
    SymmetricSymbol(std::size_t groups, std::size_t entries);

    /// `transform` as of ColumnFft::symbol.
    void set(std::size_t row, std::size_t column, std::span<const double> transform);
    /// out = M in
    void multiply(const Waves& in, Waves& out) const;

   private:
    std::size_t groups_ = 0, entries_ = 0;
    std::vector<double> values_;  // [group]; of two rows after each other, the pairs of a column side by side; [lane]
};

/// Of any shape.
class RectangularSymbol {
   public:
    RectangularSymbol() = default;
    RectangularSymbol(std::size_t groups, std::size_t rows, std::size_t columns);

    void set(std::size_t row, std::size_t column, std::span<const double> transform);
    /// out = M in
    void multiply(const Waves& in, Waves& out) const;
    /// out = M' in
    void multiply_transposed(const Waves& in, Waves& out) const;

   private:
    std::size_t groups_ = 0, rows_ = 0, columns_ = 0;
    std::vector<double> values_;  // [group][row][column][lane]
};

}  // namespace contactd
