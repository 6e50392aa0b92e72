// FFTs along x of strips of elements, padded with zeros, and the order in which products take wavenumbers.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "fft/lane_buffer.hpp"
#include "fft/lane_fft.hpp"
#include "operators/fft/periodic_joint.hpp"

namespace contactd {

/// Wavenumbers by fours, as vector registers hold them: [group][entry][lane], entries being strips of one or two
/// components, an even number of them. Real and imaginary parts are apart.
struct Waves {
    std::size_t entries = 0;
    std::vector<double> re, im;

    Waves(std::size_t groups, std::size_t entries_);
    static constexpr std::size_t lanes = 4;
};

/// Even components of a strip table have real transforms, odd ones imaginary. With the transforms of fields along x
/// times -i, both have real ones, and reciprocity makes of them a symmetric matrix.
enum class WavePhase { plain, along_x };

class StripFft;

/// Work arrays of transforms of so many strips.
class StripWork {
   public:
    StripWork(const StripFft& fft, std::size_t strips);

    std::vector<double> rows;  ///< after the inverse: its strips, one after the other

   private:
    friend class StripFft;
    std::size_t height_;  // of the spectrum
    LaneBuffer spectrum_, work_;
};

class StripFft {
   public:
    /// Transforms strips of nx elements, as if periodic with the length `period` >= nx.
    StripFft(int nx, int period);
    /// With a number of possible_lanes() of its own, for comparison.
    StripFft(int nx, int period, std::size_t lanes);
    ~StripFft();
    StripFft(const StripFft&) = delete;
    StripFft& operator=(const StripFft&) = delete;

    /// Returns the number of groups of four wavenumbers.
    std::size_t groups() const;
    /// Transforms strips of nx elements, as many as `work` was made for, to every `step`-th entry from `first` on.
    void forward(std::span<const double> strips, WavePhase phase, Waves& waves, std::size_t first, std::size_t step,
                 StripWork& work) const;
    /// And back, to work.rows: the first `length` <= period elements of each.
    void inverse(const Waves& waves, std::size_t first, std::size_t step, WavePhase phase, std::size_t length,
                 StripWork& work) const;
    /// Transforms a kernel at the offsets 0..n-1, even or odd, n <= (period + 1)/2, to the factors of products, with
    /// that of the inverse transform. Lanes beyond the last wavenumber are zero. `transform` has 4 groups() values.
    void symbol(std::span<const double> kernel, bool even, const PeriodicJoint& joint, std::span<double> transform,
                StripWork& work) const;

    /// Transforms rows of a whole period each, even or odd, by the same rules; shape [groups, rows, lanes].
    std::vector<double> transform(std::span<const double> rows, bool even) const;

   private:
    friend class StripWork;
    template <class Visit>
    void by_lanes(const Visit& visit) const;

    int nx_, period_;
    std::shared_ptr<const LaneFft> fft_;
};

}  // namespace contactd
