// FFTs along x of strips of elements, padded with zeros, and the order in which products take wavenumbers.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

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

/// Two strips before and after, transformed at once as the real and the imaginary part of one.
class StripPair {
   public:
    explicit StripPair(int period);

    std::vector<double> a, b;  ///< after the inverse: values of the whole period

   private:
    friend class StripFft;
    using Complex = std::complex<double>;
    std::vector<Complex> both_, transformed_;  // [period]
    std::vector<Complex> of_a_, of_b_;         // wavenumbers, zero beyond the last one
};

class StripFft {
   public:
    /// Transforms strips of nx elements, as if periodic with the length `period` >= nx.
    StripFft(int nx, int period);
    ~StripFft();
    StripFft(const StripFft&) = delete;
    StripFft& operator=(const StripFft&) = delete;

    /// Returns the number of groups of four wavenumbers.
    std::size_t groups() const;
    /// Two strips of nx elements into the entry `first`, `phase` being that of `a`, and the next one, which is plain.
    /// Null stands for zeros.
    void forward(const double* a, const double* b, WavePhase phase, Waves& waves, std::size_t first,
                 StripPair& work) const;
    /// And back: into `work`.
    void inverse(const Waves& waves, std::size_t first, WavePhase phase, StripPair& work) const;
    /// Transforms a kernel at the offsets 0..n-1, even or odd, n <= (period + 1)/2, to the factors of products, with
    /// that of the inverse transform. Lanes beyond the last wavenumber are zero. `transform` has 4 groups() values.
    void symbol(std::span<const double> kernel, bool even, const PeriodicJoint& joint, std::span<double> transform,
                StripPair& work) const;

   private:
    struct Plans;
    int nx_, period_;
    std::shared_ptr<const Plans> plans_;
};

}  // namespace contactd
