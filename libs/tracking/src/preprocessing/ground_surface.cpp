// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/ground_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "types/lane_bounds.h"
#include "types/wide_lanes.h"
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
constexpr std::size_t kSurfaceSectors = PolarGrid::kSectors;

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

// Those of all sectors, as arrays: sectors side by side fill the lanes of vector registers.
struct Profiles
{
    using Row = std::array<float, kSurfaceSectors>;
    Row height, slope, hh, hs, ss, blind;

    explicit Profiles(const Profile& all)
    {
        for (std::size_t s = 0; s < kSurfaceSectors; ++s) set(s, all);
    }

    [[gnu::always_inline]] Profile at(std::size_t s) const
    {
        return {height.data()[s], slope.data()[s], hh.data()[s],
                hs.data()[s],     ss.data()[s],    blind.data()[s]};
    }

    [[gnu::always_inline]] void set(std::size_t s, const Profile& p)
    {
        height.data()[s] = p.height;
        slope.data()[s] = p.slope;
        hh.data()[s] = p.hh;
        hs.data()[s] = p.hs;
        ss.data()[s] = p.ss;
        blind.data()[s] = p.blind;
    }
};

// To a place `d` metres on; inwards d is negative.
[[gnu::always_inline]] inline Profile advanced(Profile p, float d)
{
    const float way = std::abs(d);
    p.height += p.slope * d;
    p.hh += d * (2.0F * p.hs + d * p.ss) + way * kHeightNoise;
    p.hs += d * p.ss;
    p.ss += way * kSlopeNoise;
    p.blind += way;
    return p;
}

[[gnu::always_inline]] inline Profile observed(Profile p, float height)
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
    return p;
}

// A low hit: its range and height over the plane. No comparison with one that is not seen holds.
struct GroundHit
{
    float range = 0.0F;
    float height = kUnseen;
};

[[gnu::always_inline]] inline GroundHit groundHit(float x, float y, float z,
                                                  const GroundPlane& plane)
{
    const float height = z - plane.at(x, y);
    return {std::sqrt(x * x + y * y), z < LowHit::kNoHit ? height : kUnseen};
}

[[gnu::always_inline]] inline bool insideGate(const Profile& p, const GroundHit& hit)
{
    const float gate = kGate * std::sqrt(p.hh + kHitVariance);
    const float error = hit.height - p.height;
    const float most = kMaxGateUp + kGateGrowth * p.blind;
    return (error > -(gate < kMaxGateDown ? gate : kMaxGateDown)) &
           (error < (gate < most ? gate : most));
}

// Edges of a ring, m.
struct Ring
{
    float inner;
    float outer;
};

// Heights over the plane and their variances at the edges (as in GroundSurface), and the low hit
// that was taken for ground in each cell.
struct OutwardPass
{
    std::vector<float> height;     // m
    std::vector<float> variance;   // m^2
    std::vector<float> hitRange;   // m
    std::vector<float> hitHeight;  // m; kUnseen where none was

    explicit OutwardPass(const PolarGrid& grid)
        : height(static_cast<std::size_t>(grid.cells()) + kSurfaceSectors),
          variance(height.size()),
          hitRange(static_cast<std::size_t>(grid.cells())),
          hitHeight(hitRange.size())
    {
    }
};

// Moves all profiles from a ring's inner edge to its outer edge, each over the first of its cell's
// low hits that fits. They are tried from the lowest one on, unless that lies too far below the
// other. No branches: so the loop becomes vector instructions.
void crossRing(Profiles& profiles, const LowHits& low, std::size_t firstCell, const Ring& ring,
               const GroundPlane& plane, OutwardPass& pass)
{
    inWideLanes([
        p = &profiles, plane, ring, az = &low.lowest.z[firstCell], ax = &low.lowest.x[firstCell],
        ay = &low.lowest.y[firstCell], bz = &low.second.z[firstCell], bx = &low.second.x[firstCell],
        by = &low.second.y[firstCell], hitRange = &pass.hitRange[firstCell],
        hitHeight = &pass.hitHeight[firstCell]
    ]() __attribute__((always_inline)) {
        VDAMF_INDEPENDENT_LANES
        for (std::size_t s = 0; s < kSurfaceSectors; ++s)
        {
            const Profile before = p->at(s);
            const GroundHit lowest = groundHit(ax[s], ay[s], az[s], plane);
            const GroundHit second = groundHit(bx[s], by[s], bz[s], plane);
            const bool exchanged = second.height - lowest.height > kAlone;
            const GroundHit first{exchanged ? second.range : lowest.range,
                                  exchanged ? second.height : lowest.height};
            const GroundHit other{exchanged ? lowest.range : second.range,
                                  exchanged ? lowest.height : second.height};
            const Profile atFirst = advanced(before, first.range - ring.inner);
            const Profile atOther = advanced(before, other.range - ring.inner);
            const bool takeFirst = insideGate(atFirst, first);
            const bool takeOther = insideGate(atOther, other);
            const bool seen = takeFirst | takeOther;
            const GroundHit hit{takeFirst ? first.range : other.range,
                                takeFirst ? first.height : other.height};
            const Profile there{takeFirst ? atFirst.height : atOther.height,
                                takeFirst ? atFirst.slope : atOther.slope,
                                takeFirst ? atFirst.hh : atOther.hh,
                                takeFirst ? atFirst.hs : atOther.hs,
                                takeFirst ? atFirst.ss : atOther.ss,
                                takeFirst ? atFirst.blind : atOther.blind};
            const Profile over = advanced(observed(there, hit.height), ring.outer - hit.range);
            const Profile past = advanced(before, ring.outer - ring.inner);
            p->set(s, {seen ? over.height : past.height, seen ? over.slope : past.slope,
                       seen ? over.hh : past.hh, seen ? over.hs : past.hs, seen ? over.ss : past.ss,
                       seen ? over.blind : past.blind});
            hitRange[s] = hit.range;
            hitHeight[s] = seen ? hit.height : kUnseen;
        }
    });
}

inline void learnFrom(Profiles& p, std::size_t to, std::size_t from, float arcVariance)
{
    const float variance = p.hh[from] + arcVariance;
    if (variance >= p.hh[to]) return;
    const float w = p.hh[to] / (p.hh[to] + variance);
    p.height[to] += w * (p.height[from] - p.height[to]);
    p.slope[to] += w * (p.slope[from] - p.slope[to]);
    p.hh[to] += w * (variance - p.hh[to]);
    p.hs[to] += w * (p.hs[from] - p.hs[to]);
    p.ss[to] += w * (p.ss[from] - p.ss[to]);
}

// Sectors that see the ground teach those that do not: once around the circle both ways, from the
// one that knows best.
void exchangeAcross(Profiles& p, float range)
{
    const float arc = range * static_cast<float>(2.0 * kPi) / static_cast<float>(kSurfaceSectors);
    const float arcVariance = arc * kLateralNoise;
    const auto best = std::find(p.hh.begin(), p.hh.end(), leastOf(p.hh.data(), p.hh.size()));
    const auto start = static_cast<std::size_t>(best - p.hh.begin());
    for (std::size_t i = start + 1; i < start + kSurfaceSectors; ++i)
        learnFrom(p, i % kSurfaceSectors, (i - 1) % kSurfaceSectors, arcVariance);
    for (std::size_t i = start + kSurfaceSectors; i > start + 1; --i)
        learnFrom(p, (i - 1) % kSurfaceSectors, i % kSurfaceSectors, arcVariance);
}

OutwardPass passOutwards(const PolarGrid& grid, const LowHits& lowHits, const GroundPlane& plane)
{
    OutwardPass pass(grid);
    Profiles profiles{Profile()};
    for (int n = 0; n <= grid.rings; ++n)
    {
        const auto first = static_cast<std::size_t>(PolarGrid::cell(0, n));
        std::copy(profiles.height.begin(), profiles.height.end(), &pass.height[first]);
        std::copy(profiles.hh.begin(), profiles.hh.end(), &pass.variance[first]);
        if (n == grid.rings) break;
        const Ring ring{PolarGrid::range(static_cast<float>(n)),
                        PolarGrid::range(static_cast<float>(n + 1))};
        crossRing(profiles, lowHits, first, ring, plane, pass);
        exchangeAcross(profiles, ring.outer);
    }
    return pass;
}

// Blends the heights at the edges with what the ground hits farther out say.
std::vector<float> passInwards(const PolarGrid& grid, OutwardPass pass)
{
    Profile ignorant;
    ignorant.hh = 100.0F;
    Profiles profiles(ignorant);
    for (int n = grid.rings; n-- > 0;)
    {
        const auto first = static_cast<std::size_t>(PolarGrid::cell(0, n));
        inWideLanes([
            p = &profiles, inner = PolarGrid::range(static_cast<float>(n)),
            outer = PolarGrid::range(static_cast<float>(n + 1)), height = &pass.height[first],
            variance = &pass.variance[first], hitRange = &pass.hitRange[first],
            hitHeight = &pass.hitHeight[first]
        ]() __attribute__((always_inline)) {
            VDAMF_INDEPENDENT_LANES
            for (std::size_t s = 0; s < kSurfaceSectors; ++s)
            {
                const Profile before = p->at(s);
                const bool seen = hitHeight[s] == hitHeight[s];
                const Profile over =
                    advanced(observed(advanced(before, hitRange[s] - outer), hitHeight[s]),
                             inner - hitRange[s]);
                const Profile past = advanced(before, inner - outer);
                const Profile there{
                    seen ? over.height : past.height, seen ? over.slope : past.slope,
                    seen ? over.hh : past.hh,         seen ? over.hs : past.hs,
                    seen ? over.ss : past.ss,         seen ? over.blind : past.blind};
                const float w = variance[s] / (variance[s] + there.hh);
                height[s] += w * (there.height - height[s]);
                p->set(s, there);
            }
        });
    }
    return std::move(pass.height);
}
}  // namespace

GroundSurface followGround(const PolarGrid& grid, const LowHits& lowHits, const GroundPlane& plane)
{
    return {plane, passInwards(grid, passOutwards(grid, lowHits, plane))};
}

}  // namespace vdamf
