// SPDX-License-Identifier: BSD-3-Clause
// Some numbers at a time, in one or two registers (vector extension of GCC and clang): for sums,
// whose order a compiler may not change by itself. The same bits come out on every processor.
#pragma once

#include <cstddef>
#include <cstring>

namespace vdamf
{
typedef float Floats __attribute__((vector_size(32)));        // 8
typedef float HalfOfFloats __attribute__((vector_size(16)));  // 4
typedef double Doubles __attribute__((vector_size(32)));      // 4

template <class Lanes>
inline constexpr std::size_t kLanes = sizeof(Lanes) / sizeof(Lanes{}[0]);

/// Each lane's own: `kLaneNumbers < count` tells the first `count` from the others.
inline constexpr Floats kLaneNumbers = {0, 1, 2, 3, 4, 5, 6, 7};

/// Loads the first `count` numbers; the others become zero.
template <class Lanes, class Number>
[[gnu::always_inline]] inline void load(Lanes& lanes, const Number* from,
                                        std::size_t count = kLanes<Lanes>)
{
    static_assert(sizeof(Lanes{}[0]) == sizeof(Number));
    if (count < kLanes<Lanes>) lanes = Lanes{};
    std::memcpy(&lanes, from, count < kLanes<Lanes> ? count * sizeof(Number) : sizeof lanes);
}

/// The same; the others become the first number once more: for the least and the greatest.
template <class Lanes, class Number>
[[gnu::always_inline]] inline void loadRepeating(Lanes& lanes, const Number* from,
                                                 std::size_t count)
{
    load(lanes, from, count);
    for (std::size_t k = count; k < kLanes<Lanes>; ++k) lanes[k] = lanes[0];
}

/// Calls step(first, count) for each group of `size` numbers; the last one may have fewer.
template <std::size_t kCount, class Step>
[[gnu::always_inline]] inline void inGroupsOf(std::size_t size, Step step)
{
    std::size_t first = 0;
    for (; first + kCount <= size; first += kCount) step(first, kCount);
    if (first < size) step(first, size - first);
}

template <class Lanes>
[[gnu::always_inline]] inline double sumOf(const Lanes& v)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < kLanes<Lanes>; ++k) sum += static_cast<double>(v[k]);
    return sum;
}

}  // namespace vdamf
