// Holds the common data of transforms of one size.
#pragma once

#include <cstddef>
#include <memory>

#include "fft/lane_buffer.hpp"
#include "fft/lane_fft.hpp"
#include "padded_fft.hpp"

namespace contactd {

struct PaddedFft::Plans {
    int nx, ny, padded_nx, padded_ny;
    std::unique_ptr<const LaneFft> fft;
    std::size_t groups;  // of columns

    Plans(int nx_, int ny_, int padded_nx_, int padded_ny_, std::size_t lanes);

    /// Return ny, or the padded height, filled up to whole groups of rows.
    std::size_t rows() const { return filled_up(static_cast<std::size_t>(ny)); }
    std::size_t padded_rows() const { return filled_up(static_cast<std::size_t>(padded_ny)); }
    /// Returns the size of a group of columns in a spectrum.
    std::size_t group_size(std::size_t height) const { return 2 * height * fft->lanes(); }
    /// Returns the size of a group of columns in a symbol, of shape [padded_ny, lanes].
    std::size_t symbol_size() const { return static_cast<std::size_t>(padded_ny) * fft->lanes(); }

    /// Returns the plans of a size, which are created once and shared. Unused ones are kept up to a bound.
    static std::shared_ptr<const Plans> of_size(int nx, int ny, int padded_nx, int padded_ny, std::size_t lanes);

   private:
    std::size_t filled_up(std::size_t height) const {
        return (height + fft->lanes() - 1) / fft->lanes() * fft->lanes();
    }
};

}  // namespace contactd
