// Real FFTs along x of columns of elements, padded with zeros, and the order in which products take wavenumbers.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace contactd {

/// Wavenumbers by fours, as vector registers hold them: [group][entry][lane], entries being columns of one or two
/// components, an even number of them. Real and imaginary parts are apart.
struct Waves {
    std::size_t entries = 0;
    std::vector<double> re, im;

    Waves(std::size_t groups, std::size_t entries_);
    static constexpr std::size_t lanes = 4;
};

/// Even components of a column table have real transforms, odd ones imaginary. With the transforms of fields along x
/// times -i, both have real ones, and reciprocity makes of them a symmetric matrix.
enum class WavePhase { plain, along_x };

class ColumnFft {
   public:
    /// Of columns of nx elements, as if periodic with the length `period` >= nx.
    ColumnFft(int nx, int period);
    ~ColumnFft();
    ColumnFft(const ColumnFft&) = delete;
    ColumnFft& operator=(const ColumnFft&) = delete;

    /// Of wavenumbers, by fours.
    std::size_t groups() const;
    /// `field` of shape [columns, nx] into the entries from `first` on.
    void forward(std::span<const double> field, WavePhase phase, Waves& waves, std::size_t first) const;
    /// And back: calls take(column, values), values of the whole period.
    template <class Take>
    void inverse(const Waves& waves, std::size_t first, std::size_t columns, WavePhase phase, const Take& take) const {
        Row row(period_);
        for (std::size_t column = 0; column < columns; ++column) {
            inverse(waves, first + column, phase, row);
            take(column, row.values.data());
        }
    }
    /// Of a kernel at the offsets 0..n-1, even or odd, n <= (period + 1)/2: what products with it multiply by, with the
    /// factor of the inverse transform. Lanes beyond the last wavenumber are zero. `transform` has 4 groups() values.
    void symbol(std::span<const double> kernel, bool even, std::span<double> transform) const;

   private:
    struct Plans;
    /// A column before and after, its parts apart as far as those that the plans were made with. Lanes beyond the last
    /// wavenumber are zero.
    struct Row {
        explicit Row(int period);
        double* re() { return parts.data(); }
        double* im() { return parts.data() + stride; }

        std::vector<double> values;
        std::size_t stride;
        std::vector<double> parts;
    };
    void inverse(const Waves& waves, std::size_t entry, WavePhase phase, Row& row) const;

    int nx_, period_;
    std::shared_ptr<const Plans> plans_;
};

}  // namespace contactd
