// SPDX-License-Identifier: BSD-3-Clause
// A number spread over knots: a linear function of the result is a piecewise linear one of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

namespace vdamf
{
/// Rising values at which a descriptor's weight is learned.
struct Knots
{
    const double* values = nullptr;
    std::size_t count = 0;
};

template <std::size_t N>
constexpr Knots knotsOf(const double (&values)[N])
{
    return {values, N};
}

/// The knot below a value and the share of the one above it; values outside are those of the ends.
struct KnotPlace
{
    std::size_t below = 0;
    double shareAbove = 0.0;
};

inline KnotPlace placeOf(const Knots& knots, double value)
{
    const double* const end = knots.values + knots.count;
    const auto above =
        static_cast<std::size_t>(std::upper_bound(knots.values, end, value) - knots.values);
    if (above == 0) return {0, 0.0};
    if (above == knots.count) return {knots.count - 2, 1.0};
    const double low = knots.values[above - 1];
    return {above - 1, (value - low) / (knots.values[above] - low)};
}

}  // namespace vdamf
