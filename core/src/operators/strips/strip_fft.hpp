// Computes FFTs along x of strips of elements, padded with zeros, and defines the order of wavenumbers in products.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "fft/lane_buffer.hpp"
#include "fft/lane_fft.hpp"
#include "operators/fft/periodic_joint.hpp"

namespace contactd {

/// Holds wavenumbers in groups of four, as in vector registers: [group][entry][lane]. Entries are strips of one or two
/// components, an even number of them. Real and imaginary parts are separate.
struct Waves {
    std::size_t entries = 0;
    std::vector<double> re, im;

    Waves(std::size_t groups, std::size_t entries_);
    static constexpr std::size_t lanes = 4;
};

/// Even components of a strip table have real transforms, odd ones imaginary. If the transforms of fields along x are
/// multiplied by -i, both are real, and reciprocity makes the matrix symmetric.
enum class WavePhase { plain, along_x };

class StripFft;

/// Holds work arrays for transforms of a number of strips.
class StripWork {
   public:
    StripWork(const StripFft& fft, std::size_t strips);

    std::vector<double> rows;  ///< after the inverse: its strips, in sequence

   private:
    friend class StripFft;
    std::size_t height_;  // of the spectrum
    LaneBuffer spectrum_, work_;
};

class StripFft {
   public:
    /// Transforms strips of nx elements, as if periodic with the length `period` >= nx.
    StripFft(int nx, int period);
    /// Uses a given number of possible_lanes(), for comparison.
    StripFft(int nx, int period, std::size_t lanes);
    ~StripFft();
    StripFft(const StripFft&) = delete;
    StripFft& operator=(const StripFft&) = delete;

    /// Returns the number of groups of four wavenumbers.
    std::size_t groups() const;
    /// Transforms strips of nx elements, as many as `work` was made for, to every `step`-th entry from `first` on.
    void forward(std::span<const double> strips, WavePhase phase, Waves& waves, std::size_t first, std::size_t step,
                 StripWork& work) const;
    /// Transforms back to work.rows: the first `length` <= period elements of each.
    void inverse(const Waves& waves, std::size_t first, std::size_t step, WavePhase phase, std::size_t length,
                 StripWork& work) const;
    /// Transforms a kernel at the offsets 0..n-1, even or odd, n <= (period + 1)/2, to the factors of products,
    /// including that of the inverse transform. Lanes beyond the last wavenumber are zero. `transform` has 4 groups()
    /// values.
    void symbol(std::span<const double> kernel, bool even, const PeriodicJoint& joint, std::span<double> transform,
                StripWork& work) const;

    /// Transforms even or odd rows of a whole period each, by the same rules; shape [groups, rows, lanes].
    std::vector<double> transform(std::span<const double> rows, bool even) const;

   private:
    friend class StripWork;
    template <class Visit>
    void by_lanes(const Visit& visit) const;

    int nx_, period_;
    std::shared_ptr<const LaneFft> fft_;
};

}  // namespace contactd
