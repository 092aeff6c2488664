// SPDX-License-Identifier: BSD-3-Clause
// Bearings in the plane for loops that become vector instructions: no branches, no calls.
#pragma once

#include <cmath>

namespace vdamf
{
/// Angle from +x, counter-clockwise, as a share of a full turn in [0, 1]. `arc` gives the share of
/// a turn for a tangent in [0, 1].
template <class Arc>
[[gnu::always_inline]] inline float turns(float x, float y, const Arc& arc)
{
    const float ax = std::abs(x);
    const float ay = std::abs(y);
    const float difference = ax - ay;
    const float small = 0.5F * (ax + ay - std::abs(difference));
    const float big = 0.5F * (ax + ay + std::abs(difference));
    const float octant = arc(small / (big + 1e-9F));
    // Mirrored at the diagonal where |y| > |x|, then at the axes.
    const float quadrant = 0.125F - std::copysign(0.125F - octant, difference);
    const float half = 0.25F - std::copysign(0.25F - quadrant, x);
    return 0.5F - std::copysign(0.5F - half, y);
}

/// Within 0.004 rad.
struct RoughArc
{
    [[gnu::always_inline]] float operator()(float t) const
    {
        return t * (0.125F + 0.0434F * (1.0F - t));
    }
};

/// Within 0.00002 rad: the odd polynomial of degree 9 of Abramowitz and Stegun, 4.4.47.
struct FineArc
{
    [[gnu::always_inline]] float operator()(float t) const
    {
        constexpr float kTurn = 0.15915494F;
        const float s = t * t;
        return kTurn * t *
               (0.9998660F +
                s * (-0.3302995F + s * (0.1801410F + s * (-0.0851330F + s * 0.0208351F))));
    }
};

}  // namespace vdamf
