// Declares the functions that create transforms, by instruction set.
#pragma once

#include <cstddef>
#include <memory>

#include "lane_fft.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define CONTACTD_FOUR_LANES
#endif

namespace contactd {

std::unique_ptr<const LaneFft> make_two_lanes(std::size_t nx, std::size_t ny);
/// Creates transforms for processors with AVX2 and FMA.
std::unique_ptr<const LaneFft> make_four_lanes(std::size_t nx, std::size_t ny);
/// Creates transforms by FFTW, if CMake's option CONTACTD_FFT selects it.
std::unique_ptr<const LaneFft> make_fftw_lanes(std::size_t nx, std::size_t ny);

}  // namespace contactd
