// Loops over arrays in the widest registers that the processor has.
#pragma once

/// Functions marked with it are compiled twice, the second time for processors with AVX2 and FMA, and the fitting one
/// is chosen when the program starts. Their loops should be free of branches. Sanitizers run before that choice can be
/// made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define CONTACTD_WIDE [[gnu::target_clones("arch=x86-64-v3", "default")]]
#else
#define CONTACTD_WIDE
#endif
