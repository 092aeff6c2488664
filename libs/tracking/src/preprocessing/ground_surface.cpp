// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/ground_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
// Tuned on KITTI drives: whole, with every fourth beam, and with mirror images added.
// Change of the ground over the plane, per metre of way:
constexpr float kHeightNoise = 0.04F * 0.04F;   // kerbs and unevenness, m^2 / m
constexpr float kSlopeNoise = 0.008F * 0.008F;  // of the slope outwards, 1 / m
constexpr float kLateralNoise = 0.05F * 0.05F;  // across the sectors, m^2 / m
// Of a low hit, m^2; and the share of its squared distance from the prediction that adds to it: a
// hit at the edge of the gate is either, ground or the foot of something.
constexpr float kHitVariance = 0.04F * 0.04F;
constexpr float kDoubt = 0.2F;
constexpr float kGate = 3.0F;          // standard deviations, but not more than
constexpr float kMaxGateUp = 0.2F;     // where the side of an object may begin, m
constexpr float kGateGrowth = 0.005F;  // the same, for each metre without ground
constexpr float kMaxGateDown = 0.5F;   // a step down, m
constexpr float kAlone = 0.05F;        // a lowest hit that is below the next by more is noise, m
constexpr float kStartVariance = 0.1F * 0.1F;  // of the plane, m^2
constexpr float kStartSlope = 0.03F * 0.03F;
constexpr float kUnseen = std::numeric_limits<float>::quiet_NaN();

// Height and slope over the range of one sector, with their covariance.
struct Profile
{
    float height = 0.0F;
    float slope = 0.0F;
    float hh = kStartVariance;
    float hs = 0.0F;
    float ss = kStartSlope;
    float blind = 0.0F;  // way since the last ground hit, m
};

// To a place `d` metres on; inwards d is negative.
inline void advance(Profile& p, float d)
{
    const float way = std::abs(d);
    p.height += p.slope * d;
    p.hh += d * (2.0F * p.hs + d * p.ss) + way * kHeightNoise;
    p.hs += d * p.ss;
    p.ss += way * kSlopeNoise;
    p.blind += way;
}

inline void observe(Profile& p, float height)
{
    const float error = height - p.height;
    const float gain = 1.0F / (p.hh + kHitVariance + kDoubt * error * error);
    const float kh = p.hh * gain;
    const float ks = p.hs * gain;
    p.height += kh * error;
    p.slope += ks * error;
    p.ss -= ks * p.hs;
    p.hs -= kh * p.hs;
    p.hh -= kh * p.hh;
    p.blind = 0.0F;
}

// A low hit that was taken for ground: its range and height over the plane.
struct GroundHit
{
    float range = 0.0F;
    float height = kUnseen;

    bool seen() const { return height == height; }
};

GroundHit groundHitAt(const LowHit& hit, const GroundPlane& plane)
{
    if (!hit.seen()) return {};
    return {std::sqrt(hit.x * hit.x + hit.y * hit.y), hit.z - plane.at(hit.x, hit.y)};
}

bool insideGate(const Profile& p, const GroundHit& hit)
{
    const float gate = kGate * std::sqrt(p.hh + kHitVariance);
    const float error = hit.height - p.height;
    return error > -std::min(gate, kMaxGateDown) &&
           error < std::min(gate, kMaxGateUp + kGateGrowth * p.blind);
}

// The cell's low hits in the order in which they are tried.
std::array<GroundHit, 2> candidates(const LowHits& low, const GroundPlane& plane)
{
    GroundHit first = groundHitAt(low[0], plane);
    GroundHit second = groundHitAt(low[1], plane);
    if (second.height - first.height > kAlone) std::swap(first, second);
    return {first, second};
}

// Moves the profile from a cell's inner edge to its outer edge, over the first of the cell's low
// hits that fits. Returns that hit.
GroundHit crossCell(Profile& p, const std::array<GroundHit, 2>& low, float inner, float outer)
{
    for (const GroundHit& hit : low)
    {
        if (!hit.seen()) break;
        Profile there = p;
        advance(there, hit.range - inner);
        if (!insideGate(there, hit)) continue;
        observe(there, hit.height);
        advance(there, outer - hit.range);
        p = there;
        return hit;
    }
    advance(p, outer - inner);
    return {};
}

inline void learnFrom(Profile& p, const Profile& neighbour, float arc)
{
    const float variance = neighbour.hh + arc * kLateralNoise;
    if (variance >= p.hh) return;
    const float w = p.hh / (p.hh + variance);
    p.height += w * (neighbour.height - p.height);
    p.slope += w * (neighbour.slope - p.slope);
    p.hh += w * (variance - p.hh);
    p.hs += w * (neighbour.hs - p.hs);
    p.ss += w * (neighbour.ss - p.ss);
}

// Sectors that see the ground teach those that do not: once around the circle both ways, from the
// one that knows best.
void exchangeAcross(std::vector<Profile>& profiles, float range)
{
    const std::size_t n = profiles.size();
    const float arc = range * static_cast<float>(2.0 * kPi) / static_cast<float>(n);
    const auto best =
        std::min_element(profiles.begin(), profiles.end(),
                         [](const Profile& a, const Profile& b) { return a.hh < b.hh; });
    const auto start = static_cast<std::size_t>(best - profiles.begin());
    for (std::size_t i = start + 1; i < start + n; ++i)
        learnFrom(profiles[i % n], profiles[(i - 1) % n], arc);
    for (std::size_t i = start + n; i > start + 1; --i)
        learnFrom(profiles[(i - 1) % n], profiles[i % n], arc);
}

std::vector<float> edgeRanges(const PolarGrid& grid)
{
    std::vector<float> ranges;
    for (int n = 0; n <= grid.rings; ++n) ranges.push_back(PolarGrid::range(static_cast<float>(n)));
    return ranges;
}

// What the pass outwards finds, by edge (as in GroundSurface) and by cell.
struct OutwardPass
{
    std::vector<float> height;      // over the plane at the edge, m
    std::vector<float> variance;    // of that, m^2
    std::vector<GroundHit> ground;  // in the cell
};

OutwardPass passOutwards(const PolarGrid& grid, const std::vector<LowHits>& lowHits,
                         const GroundPlane& plane, const std::vector<float>& ranges)
{
    OutwardPass pass;
    const std::size_t edges = ranges.size();
    pass.height.resize(PolarGrid::kSectors * edges);
    pass.variance.resize(pass.height.size());
    pass.ground.resize(lowHits.size());
    std::vector<Profile> profiles(PolarGrid::kSectors);
    for (std::size_t ring = 0; ring < edges; ++ring)
    {
        for (std::size_t sector = 0; sector < profiles.size(); ++sector)
        {
            Profile& p = profiles[sector];
            pass.height[sector * edges + ring] = p.height;
            pass.variance[sector * edges + ring] = p.hh;
            if (ring + 1 == edges) continue;
            const auto cell = static_cast<std::size_t>(
                grid.cell(static_cast<int>(sector), static_cast<int>(ring)));
            pass.ground[cell] =
                crossCell(p, candidates(lowHits[cell], plane), ranges[ring], ranges[ring + 1]);
        }
        if (ring + 1 < edges) exchangeAcross(profiles, ranges[ring + 1]);
    }
    return pass;
}

// Blends the heights at one sector's edges with what the ground hits farther out say.
void passInwards(OutwardPass& pass, std::size_t sector, const std::vector<float>& ranges)
{
    const std::size_t rings = ranges.size() - 1;
    Profile p;
    p.hh = 100.0F;  // knows nothing yet
    for (std::size_t ring = rings; ring-- > 0;)
    {
        float at = ranges[ring + 1];
        const GroundHit& hit = pass.ground[sector * rings + ring];
        if (hit.seen())
        {
            advance(p, hit.range - at);
            observe(p, hit.height);
            at = hit.range;
        }
        advance(p, ranges[ring] - at);
        const std::size_t edge = sector * (rings + 1) + ring;
        const float w = pass.variance[edge] / (pass.variance[edge] + p.hh);
        pass.height[edge] += w * (p.height - pass.height[edge]);
    }
}
}  // namespace

GroundSurface followGround(const PolarGrid& grid, const std::vector<LowHits>& lowHits,
                           const GroundPlane& plane)
{
    const std::vector<float> ranges = edgeRanges(grid);
    OutwardPass pass = passOutwards(grid, lowHits, plane, ranges);
    for (std::size_t sector = 0; sector < PolarGrid::kSectors; ++sector)
        passInwards(pass, sector, ranges);
    return {plane, std::move(pass.height)};
}

}  // namespace vdamf
