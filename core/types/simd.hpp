// Compiles loops over arrays for the widest vector registers of the processor.
#pragma once

/// Marked functions are compiled twice, the second time for processors with AVX2 and FMA, and the suitable one is
/// chosen when the program starts. Their loops should be free of branches. Sanitizers run before that choice can be
/// made. Windows does not support it; there, files with such functions are compiled for AVX2 and FMA only.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(_WIN32) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CONTACTD_SIMD [[gnu::target_clones("arch=x86-64-v3", "default")]]
#else
#define CONTACTD_SIMD
#endif

/// Functions that marked functions call must be inlined, or they would be compiled only once.
#define CONTACTD_INLINE [[gnu::always_inline]] inline

namespace contactd {

/// Represents four adjacent doubles at any address.
using Four [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

inline const Four& four(const double* values) {
    return *reinterpret_cast<const Four*>(values);
}
inline Four& four(double* values) {
    return *reinterpret_cast<Four*>(values);
}

}  // namespace contactd
