// SIMD: loops over arrays in the widest vector registers that the processor has.
#pragma once

/// Functions marked with it are compiled twice, the second time for processors with AVX2 and FMA, and the fitting one
/// is chosen when the program starts. Their loops should be free of branches. Sanitizers run before that choice can be
/// made, and Windows has none: there the files that have them are compiled for AVX2 and FMA alone.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(_WIN32) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CONTACTD_SIMD [[gnu::target_clones("arch=x86-64-v3", "default")]]
#else
#define CONTACTD_SIMD
#endif

/// Functions that such functions call must become part of them, or they would be compiled once.
#define CONTACTD_INLINE [[gnu::always_inline]] inline

namespace contactd {

/// Four doubles side by side, wherever they lie.
using Four [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

inline const Four& four(const double* values) {
    return *reinterpret_cast<const Four*>(values);
}
inline Four& four(double* values) {
    return *reinterpret_cast<Four*>(values);
}

}  // namespace contactd
