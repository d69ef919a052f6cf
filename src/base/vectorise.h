#pragma once

/// KNITMECH_VECTORISE before a function compiles it for AVX-512, AVX2 and the baseline processor; the program takes the
/// best one when it starts. Helpers that such a function calls must be KNITMECH_INLINE, or they stay at the baseline.
/// Sanitizers cannot start a program that chooses functions this way, so under them only the baseline is compiled.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define KNITMECH_VECTORISE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define KNITMECH_VECTORISE
#endif
#define KNITMECH_INLINE inline __attribute__((always_inline))
