// SPDX-License-Identifier: BSD-3-Clause
// Loops in the widest registers that the processor has, chosen at run time.
#pragma once

/// Before a loop: its arrays do not overlap, which GCC would check in vain for many of them.
#if defined(__clang__)
#define VDAMF_INDEPENDENT_LANES
#else
#define VDAMF_INDEPENDENT_LANES _Pragma("GCC ivdep")
#endif

namespace vdamf
{
#if defined(__x86_64__)
template <class Loop>
[[gnu::target("avx2")]] void runWithAvx2(Loop loop)
{
    loop();
}

inline bool processorHasAvx2()
{
    static const bool has = __builtin_cpu_supports("avx2") != 0;
    return has;
}
#endif

/// Runs a loop: a callable that is inlined always (`[=]() __attribute__((always_inline))`), with
/// its arrays as plain pointers by value, so that the compiler makes vector instructions of it.
/// Passed by value, for what a loop stores might otherwise be its own captures. The same bits come
/// out on every processor: lanes alone differ, no operations are fused.
template <class Loop>
void inWideLanes(Loop loop)
{
#if defined(__x86_64__)
    if (processorHasAvx2()) return runWithAvx2(loop);
#endif
    loop();
}

}  // namespace vdamf
