// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/body_profile.h"

#include <array>
#include <cstddef>

namespace vdamf
{
namespace
{
// How far a face lies beyond what is seen of it, with its standard deviation, where nothing but the
// tenth of a metre was seen that is 0.2, 0.3 ... 1.1 m above the ground.
struct Depth
{
    double mean;
    double sigma;
};
constexpr std::size_t kHeights = 10;
constexpr unsigned kLowestBand = 2;  // tenths of a metre
using Depths = std::array<Depth, kHeights>;
constexpr Depths kLowFront = {{{1.7, 0.42},
                               {0.83, 0.36},
                               {0, 0.14},
                               {0, 0.21},
                               {0.42, 0.42},
                               {1.8, 2},
                               {6, 4},
                               {9.2, 4.5},
                               {10, 4.9},
                               {12, 5.7}}};
constexpr Depths kTallFront = {{{0.75, 1},
                                {0.67, 0.75},
                                {0, 0.17},
                                {0.083, 0.2},
                                {0.25, 0.25},
                                {0.33, 0.33},
                                {0.5, 0.5},
                                {1, 0.83},
                                {1.3, 1},
                                {1.7, 1.3}}};
constexpr Depths kLowBack = {{{1.1, 0.27},
                              {0.58, 0.25},
                              {0, 0.13},
                              {0.083, 0.13},
                              {0.17, 0.25},
                              {0.83, 0.83},
                              {2, 2.5},
                              {3.3, 3.7},
                              {4.2, 4.2},
                              {5, 5}}};
constexpr Depths kTallBack = {{{0.17, 0.33},
                               {0, 0.33},
                               {0, 0.1},
                               {0, 0.17},
                               {0, 0.25},
                               {0, 0.33},
                               {0.17, 0.42},
                               {0.25, 0.5},
                               {0.33, 0.67},
                               {0.33, 0.67}}};
constexpr Depths kLowSide = {{{0.45, 0.16},
                              {0.28, 0.14},
                              {0, 0},
                              {0, 0},
                              {0, 0.054},
                              {0, 0.08},
                              {0.13, 0.2},
                              {0.33, 0.26},
                              {0.5, 0.4},
                              {0.67, 0.54}}};
constexpr Depths kTallSide = {{{0, 0.1},
                               {0, 0.083},
                               {0, 0},
                               {0, 0},
                               {0, 0},
                               {0, 0},
                               {0, 0.083},
                               {0, 0.1},
                               {0, 0.17},
                               {0, 0.25}}};

// Cars are lower, m / 10.
constexpr unsigned kTall = 18;

bool isTall(std::uint64_t heights)
{
    return (heights >> kTall) != 0;
}

// Nothing but zeros: of points without height.
bool areUnknown(std::uint64_t heights)
{
    return heights <= 1;
}

// Of all heights seen the one nearest to the hull.
Depth leastDepth(const Depths& depths, std::uint64_t heights)
{
    const Depth* least = nullptr;
    for (std::size_t k = 0; k < kHeights; ++k)
    {
        if (((heights >> (k + kLowestBand)) & 1U) == 0) continue;
        const Depth& depth = depths[k];
        const bool less = least == nullptr || depth.mean < least->mean ||
                          (depth.mean == least->mean && depth.sigma < least->sigma);
        if (less) least = &depth;
    }
    return least != nullptr ? *least : depths.back();
}

BodyProfile profileOf(Face face, bool tall, const HullParameters& hull)
{
    BodyProfile profile;
    switch (face)
    {
        case Face::Front:
            profile = {hull.front, 0.5, tall ? 0.25 : 0.4, 0.0, 0.0};
            break;
        case Face::Back:
            profile = {hull.back, 0.5, tall ? 0.075 : 0.25, 0.0, 0.0};
            break;
        case Face::Left:
        case Face::Right:
            profile = {hull.side, tall ? 0.3 : 0.35, tall ? 0.05 : 0.17, 0.0, 0.0};
            break;
    }
    profile.usualDeparture *= hull.usual;
    return profile;
}
}  // namespace

bool areOfCar(std::uint64_t heights)
{
    return !areUnknown(heights) && !isTall(heights);
}

bool isCarWithHeights(const Hits& hits)
{
    return areOfCar(hits.heights) && !hits.height.empty();
}

BodyProfile bodyProfile(Face face, std::uint64_t heights, const HullParameters& hull)
{
    BodyProfile profile = profileOf(face, isTall(heights), hull);
    if (areUnknown(heights)) return profile;
    const bool isSide = face == Face::Left || face == Face::Right;
    const Depths& low = isSide ? kLowSide : (face == Face::Front ? kLowFront : kLowBack);
    const Depths& tall = isSide ? kTallSide : (face == Face::Front ? kTallFront : kTallBack);
    const Depth beyond = leastDepth(isTall(heights) ? tall : low, heights);
    profile.beyond = hull.beyond * beyond.mean;
    profile.beyondError = hull.beyond * beyond.sigma;
    return profile;
}

}  // namespace vdamf
