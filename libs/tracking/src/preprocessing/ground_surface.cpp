// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/ground_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <cstdlib>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
float env(const char*n,float d){const char*v=getenv(n);return v?float(atof(v)):d;}
// Of the ground over the plane, per metre of way: kerbs and unevenness, and the change of slope.
static const float kHeightNoise = env("HN",0.04F)*env("HN",0.04F);     // m^2 / m
static const float kSlopeNoise = env("SN",0.008F)*env("SN",0.008F);    // 1 / m
static const float kLateralNoise = env("LN",0.05F)*env("LN",0.05F);    // m^2 / m, across the sectors
static const float kHitVariance = env("HV",0.04F)*env("HV",0.04F);     // of a low hit, m^2
static const float kGate=env("GA",3);                     // standard deviations
static const float kMaxGateUp=env("GU",0.4F);static const float kDn=env("DN",0),kNear=env("NC",0),kGD=env("GD",9);static const float kUp=env("UP",0);                // an object's side begins here, m
static const float kStartVariance = env("SV",0.1F)*env("SV",0.1F);     // of the plane, m^2
static const float kStartSlope = env("SS",0.03F)*env("SS",0.03F);
constexpr float kUnseen = std::numeric_limits<float>::quiet_NaN();

// Height and slope over the range of one sector, with their covariance.
struct Profile
{
    float height = 0.0F;
    float slope = 0.0F;
    float hh = kStartVariance;
    float hs = 0.0F;
    float ss = kStartSlope;
};

// To a place `d` metres on; inwards d is negative.
inline void advance(Profile& p, float d)
{
    const float way = std::abs(d);
    p.height += p.slope * d;
    p.hh += d * (2.0F * p.hs + d * p.ss) + way * kHeightNoise;
    p.hs += d * p.ss;
    p.ss += way * kSlopeNoise;
}

inline void observe(Profile& p, float height)
{
    const float error = height - p.height;
    const float e2 = std::max(0.0F, error);
    const float gain = 1.0F / (p.hh + kHitVariance+kUp*e2*e2+kDn*std::min(0.F,error)*std::min(0.F,error));
    const float kh = p.hh * gain;
    const float ks = p.hs * gain;
    p.height += kh * error;
    p.slope += ks * error;
    p.ss -= ks * p.hs;
    p.hs -= kh * p.hs;
    p.hh -= kh * p.hh;
}

// A low hit that was taken for ground: its range and height over the plane.
struct GroundHit
{
    float range = 0.0F;
    float height = kUnseen;

    bool seen() const { return height == height; }
};

GroundHit groundHitAt(const PolarHits& hits, const GroundPlane& plane, std::int32_t index)
{
    if (index < 0) return {};
    const auto i = static_cast<std::size_t>(index);
    return {PolarGrid::range(hits.ring[i]), hits.z[i] - plane.at(hits.x[i], hits.y[i])};
}

bool insideGate(const Profile& p, const GroundHit& hit)
{
    if (!hit.seen()) return false;
    const float gate = kGate * std::sqrt(p.hh + kHitVariance);
    const float error = hit.height - p.height;
    return error > -std::min(gate,kGD) && error < std::min(gate, kMaxGateUp);
}

// Moves the profile of one cell's inner edge to its outer edge, over the lowest of the cell's low
// hits that fits. Returns that hit.
GroundHit crossCell(Profile& p, const LowHits& low, const PolarHits& hits,
                    const GroundPlane& plane, float innerRange, float outerRange)
{
    float at = innerRange;
    if (kNear>0 && low.secondIndex>=0){
     const GroundHit a=groundHitAt(hits,plane,low.index),b=groundHitAt(hits,plane,low.secondIndex);
     const bool in = b.height-a.height>kNear; 
        const GroundHit hit = in?b:a;
        Profile q=p;
        advance(q, hit.range - at);
        if (insideGate(q, hit)) {
        observe(q, hit.height);
        advance(q, outerRange - hit.range);p=q;
        return hit;}
    }
    for (const std::int32_t index : {low.index, low.secondIndex})
    {
        const GroundHit hit = groundHitAt(hits, plane, index);
        if (!hit.seen()) break;
        advance(p, hit.range - at);
        at = hit.range;
        if (!insideGate(p, hit)) continue;
        observe(p, hit.height);
        advance(p, outerRange - at);
        return hit;
    }
    advance(p, outerRange - at);
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

// Sectors that see the ground teach those that do not, around the circle both ways. More than one
// turn is never needed: what is known worst is next to something better within half of one.
void exchangeAcross(std::vector<Profile>& profiles, float range)
{
    constexpr int kSectors = PolarGrid::kSectors;
    const float arc = range * static_cast<float>(2.0 * kPi) / kSectors;
    for (int i = 1; i < kSectors + kSectors / 2; ++i)
        learnFrom(profiles[static_cast<std::size_t>(i % kSectors)],
                  profiles[static_cast<std::size_t>((i - 1) % kSectors)], arc);
    for (int i = kSectors + kSectors / 2; i > 0; --i)
        learnFrom(profiles[static_cast<std::size_t>((i - 1) % kSectors)],
                  profiles[static_cast<std::size_t>(i % kSectors)], arc);
}
}  // namespace

GroundSurface followGround(const PolarHits& hits, const PolarGrid& grid,
                           const std::vector<LowHits>& lowHits, const GroundPlane& plane)
{
    constexpr int kSectors = PolarGrid::kSectors;
    const int edges = grid.rings + 1;
    GroundSurface surface{plane, std::vector<float>(static_cast<std::size_t>(kSectors * edges))};
    std::vector<GroundHit> ground(lowHits.size());
    std::vector<float> variance(surface.height.size());
    std::vector<float> rangeOfEdge(static_cast<std::size_t>(edges));
    for (int n = 0; n < edges; ++n)
        rangeOfEdge[static_cast<std::size_t>(n)] = PolarGrid::range(static_cast<float>(n));

    std::vector<Profile> profiles(kSectors);
    for (int ring = 0; ring < grid.rings; ++ring)
    {
        const float inner = rangeOfEdge[static_cast<std::size_t>(ring)];
        const float outer = rangeOfEdge[static_cast<std::size_t>(ring) + 1];
        for (int s = 0; s < kSectors; ++s)
        {
            const auto cell = static_cast<std::size_t>(grid.cell(s, ring));
            Profile& p = profiles[static_cast<std::size_t>(s)];
            const auto edge = static_cast<std::size_t>(s * edges + ring);
            surface.height[edge] = p.height;
            variance[edge] = p.hh;
            ground[cell] = crossCell(p, lowHits[cell], hits, plane, inner, outer);
        }
        exchangeAcross(profiles, outer);
    }
    for (int s = 0; s < kSectors; ++s)
    {
        Profile p;
        p.hh = 100.0F;
        p.ss = 0.05F * 0.05F;
        surface.height[static_cast<std::size_t>(s * edges + grid.rings)] =
            profiles[static_cast<std::size_t>(s)].height;
        for (int ring = grid.rings - 1; ring >= 0; --ring)
        {
            const float inner = rangeOfEdge[static_cast<std::size_t>(ring)];
            float at = rangeOfEdge[static_cast<std::size_t>(ring) + 1];
            const GroundHit& hit = ground[static_cast<std::size_t>(grid.cell(s, ring))];
            if (hit.seen())
            {
                advance(p, hit.range - at);
                observe(p, hit.height);
                at = hit.range;
            }
            advance(p, inner - at);
            const auto edge = static_cast<std::size_t>(s * edges + ring);
            const float w = variance[edge] / (variance[edge] + p.hh);
            surface.height[edge] += w * (p.height - surface.height[edge]);
        }
    }
    return surface;
}

}  // namespace vdamf
