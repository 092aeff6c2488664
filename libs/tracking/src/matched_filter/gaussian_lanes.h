// SPDX-License-Identifier: BSD-3-Clause
// Eqs. (5)-(8) for several hits at once in single precision: what one hit's Gaussian puts on one
// side of an edge, with its derivatives.
#pragma once

#include <cstdint>

namespace vdamf
{
/// `kWidth` numbers in one or several registers (vector extension of GCC and clang).
template <int kWidth>
struct Lanes
{
    typedef float Real __attribute__((vector_size(kWidth * sizeof(float))));
    typedef std::uint32_t Bits __attribute__((vector_size(kWidth * sizeof(float))));
};

/// Where a Gaussian has fallen to one half, in units of its sigma: sqrt(2 ln 2). Measured in
/// sigma * kHalvingLength it is 2^(-s^2).
inline constexpr double kHalvingLength = 1.17741002251547469;

/// A step at an edge, smoothed by a Gaussian, with its derivatives by the distance s.
template <int kWidth>
struct EdgeLanes
{
    typename Lanes<kWidth>::Real step;     ///< Eq. (5) less 1/2, which differences of edges lose
    typename Lanes<kWidth>::Real density;  ///< its derivative by s
    typename Lanes<kWidth>::Real curve;    ///< and the second one
};

/// At distances s beyond the edge, in halving lengths. Absolute errors: step 2e-7, density 2e-7,
/// curve 3e-7. All of it from one power of two, one quotient and two polynomials.
template <int kWidth>
[[gnu::always_inline]] inline EdgeLanes<kWidth> edgeLanes(const typename Lanes<kWidth>::Real& s)
{
    using Real = typename Lanes<kWidth>::Real;
    using Bits = typename Lanes<kWidth>::Bits;
    // 2^(-s^2) = 2^n 2^r with |r| <= 1/2. Adding 1.5 * 2^23 rounds and leaves n in the low bits,
    // from where it goes into the exponent. The polynomial is the minimax one of degree 5.
    constexpr float kRounder = 12582912.0F;
    const Real power = -s * s;
    const Real shifted = power + kRounder;
    const Real r = power - (shifted - kRounder);
    const Real fraction =
        1.0F + r * (0.6931469776F +
                    r * (0.2402224208F +
                         r * (0.05550733744F + r * (0.009671512768F + r * 0.001326472727F))));
    // Below 2^-50 it is nothing; this also keeps products of two from becoming denormal, and
    // discards what overflowed for hits far away.
    const Bits bits = ((Bits)fraction + ((Bits)shifted << 23)) & (Bits)(power > -50.0F);
    const Real g = (Real)bits;

    // 1/2 erfc by Abramowitz and Stegun 7.1.26, with sqrt(ln 2) in its constant for our s.
    const Bits sign = (Bits)s & 0x80000000U;
    const Real distance = (Real)((Bits)s ^ sign);
    const Real t = 1.0F / (1.0F + (0.3275911F * 0.832554611F) * distance);
    const Real tail =
        g * t *
        (0.127414796F +
         t * (-0.142248368F + t * (0.7107068705F + t * (-0.7265760135F + t * 0.5307027145F))));
    const Real step = (Real)((Bits)(0.5F - tail) ^ sign);
    // d step / ds = sqrt(ln 2 / pi) 2^(-s^2); d 2^(-s^2) / ds = -2 ln 2 s 2^(-s^2).
    const Real density = 0.469718639F * g;
    return {step, density, -1.38629436F * s * density};
}

}  // namespace vdamf
