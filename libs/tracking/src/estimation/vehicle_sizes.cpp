// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/vehicle_sizes.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
// Share of vans to buses of what is as low as cars are, of what is higher, and between: rows of a
// LADAR lie half a metre apart where it is far, so that roofs seem lower. Trailers are low indeed.
constexpr double kLow = 1.7;   // m
constexpr double kHigh = 2.3;  // m
constexpr double kLargeIfLow = 0.15;
constexpr double kLargeIfSeenLow = 0.02;
constexpr double kLargeIfHigh = 0.7;

double shareOfLarge(double height, bool isHeightSeen)
{
    const double low = isHeightSeen ? kLargeIfSeenLow : kLargeIfLow;
    const double high = std::clamp((height - kLow) / (kHigh - kLow), 0.0, 1.0);
    return low + high * (kLargeIfHigh - low);
}

// Of faces of anything else, per metre.
constexpr double kOdd = 0.01;

// Sizes with what mirrors and round corners add or take, m.
struct Normal
{
    double mean;
    double sigma;

    double density(double x) const
    {
        const double z = (x - mean) / sigma;
        return 0.3989422804 / sigma * std::exp(-0.5 * z * z);
    }
    double above(double x) const { return 0.5 * std::erfc((x - mean) / (sigma * std::sqrt(2.0))); }
};
constexpr Normal kCarWidth{1.85, 0.25};
constexpr Normal kCarLength{4.3, 0.6};
constexpr Normal kLargeWidth{2.5, 0.35};

// Lengths of vans to buses: any beyond the shortest, the longer the rarer.
struct Long
{
    double least;
    double scale;
    double mean = least + scale;

    double above(double x) const { return x < least ? 1.0 : std::exp(-(x - least) / scale); }
    double density(double x) const { return x < least ? 0.0 : above(x) / scale; }
};
constexpr Long kLargeLength{4.8, 5.0};

// Density of what is seen of a face, 1/m: all of it, or a part, and then any part is as likely.
template <class Sizes>
double density(const FaceExtent& seen, const Sizes& sizes)
{
    const double part = sizes.above(seen.metres) / std::max(seen.metres, sizes.mean);
    return seen.whole * sizes.density(seen.metres) + (1.0 - seen.whole) * part;
}
}  // namespace

double endOverSide(const FaceExtent& face, double height, bool isHeightSeen)
{
    const double large = shareOfLarge(height, isHeightSeen);
    const double end =
        (1.0 - large) * density(face, kCarWidth) + large * density(face, kLargeWidth);
    const double side =
        (1.0 - large) * density(face, kCarLength) + large * density(face, kLargeLength);
    return std::log((end + kOdd) / (side + kOdd));
}

}  // namespace vdamf
