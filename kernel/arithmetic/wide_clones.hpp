// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// CREST_WIDE_CLONES before a function: compiled for several instruction sets too, of which the
// program takes the best there is when it starts, all that it calls inlined. Without contraction
// (-ffp-contract=off) every one gives the same bits.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__)
#define CREST_WIDE_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "avx2", "default"), flatten))
#else
#define CREST_WIDE_CLONES
#endif
