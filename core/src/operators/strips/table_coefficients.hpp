// Implements coefficients between strips by a table.
#pragma once

#include "contactd/strip_table.hpp"
#include "strip_coefficients.hpp"

namespace contactd {

/// Uses the symmetric part of the table (see symmetrised), or with the opposite parity the antisymmetric one.
class TableCoefficients final : public StripCoefficients {
   public:
    explicit TableCoefficients(StripTable table);

    const StripTable& table() const { return table_; }
    int strips() const override { return table_.strips; }
    int offsets() const override { return table_.nx; }
    bool coupled() const override { return coupled_; }
    double self(Axis i, int strip) const override { return table_(i, i, strip, strip, 0); }
    std::size_t bytes() const override { return bytes_of(table_.nx, table_.strips); }
    /// Returns the approximate memory of table, symbols, and those of some boxes.
    static std::size_t bytes_of(int nx, int strips);

    SymmetricSymbol normal(const SymbolExtent& extent, const StripFft& fft) const override;
    SymmetricSymbol tangential(const SymbolExtent& extent, const StripFft& fft) const override;
    RectangularSymbol coupling(const SymbolExtent& extent, const StripFft& fft) const override;
    std::shared_ptr<const StripCoefficients> coarse(const ElementBox& box, int along_x, int along_y) const override;

   private:
    template <class Set>
    void for_pairs(const SymbolExtent& extent, const StripFft& fft, Axis i, Axis j, const Set& set) const;

    const StripTable table_;
    const bool coupled_;
};

}  // namespace contactd
