// SPDX-License-Identifier: BSD-3-Clause
// Cosine and sine of one angle, which rotations ask for all the time.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace vdamf
{
/// A unit vector in the plane.
struct Direction
{
    double cos = 1.0;
    double sin = 0.0;
};

namespace detail
{
/// Of an angle from -pi / 4 to pi / 4: the polynomials of FreeBSD's msun, which are right to the
/// last bit or the one before it.
inline Direction directionNearZero(double x)
{
    const double z = x * x;
    const double z2 = z * z;
    const double sine = (8.33333333332248946124e-03 - 1.98412698298579493134e-04 * z) +
                        z2 * ((2.75573137070700676789e-06 - 2.50507602534068634195e-08 * z) +
                              1.58969099521155010221e-10 * z2);
    const double cosine = (4.16666666666666019037e-02 - 1.38888888888741095749e-03 * z) +
                          z2 * ((2.48015872894767294178e-05 - 2.75573143513906633035e-07 * z) +
                                z2 * (2.08757232129817482790e-09 - 1.13596475577881948265e-11 * z));
    return {1.0 - (0.5 * z - z2 * cosine), x + x * (z * (-1.66666666666666324348e-01 + z * sine))};
}
}  // namespace detail

/// Of an angle counter-clockwise from +x, within 3e-16. The library's functions take the rounding
/// mode of the processor aside at each call, and several times as long.
inline Direction directionOf(double angle)
{
    constexpr double kMost = 1e5;  // rad, up to which the remainder below is exact
    if (!(std::abs(angle) < kMost)) return {std::cos(angle), std::sin(angle)};
    // Adding 1.5 * 2^52 rounds and leaves the number of quarter turns in the low bits.
    constexpr double kRounder = 6755399441055744.0;
    const double shifted = angle * 6.36619772367581382433e-01 + kRounder;
    const double quarters = shifted - kRounder;
    std::uint64_t quarter = 0;
    std::memcpy(&quarter, &shifted, sizeof quarter);
    // pi / 2 in two parts, the first of 33 bits.
    const double rest =
        (angle - quarters * 1.57079632673412561417e+00) - quarters * 6.07710050650619224932e-11;
    const Direction d = detail::directionNearZero(rest);
    // Selections by arithmetic: headings lie in all quadrants, and a branch would guess.
    std::uint64_t c = 0;
    std::uint64_t s = 0;
    std::memcpy(&c, &d.cos, sizeof c);
    std::memcpy(&s, &d.sin, sizeof s);
    const std::uint64_t exchange = (c ^ s) & (std::uint64_t{0} - (quarter & 1U));
    c ^= exchange ^ ((quarter + 1) & 2U) << 62;
    s ^= exchange ^ (quarter & 2U) << 62;
    Direction turned;
    std::memcpy(&turned.cos, &c, sizeof c);
    std::memcpy(&turned.sin, &s, sizeof s);
    return turned;
}

}  // namespace vdamf
