// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/ground_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "types/cholesky.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
constexpr float kSearchRange = 25.0F;   // m
constexpr int kSectorsAtOnce = 4;       // one low hit from these, for speed and robustness
constexpr float kLeastSupport = 12.0F;  // low hits in the plane, less half of those below it
constexpr float kSearchTop = 0.5F;      // planes up to this over the sensor compete, m
constexpr float kHeightBin = 0.1F;      // of the histogram over heights, m

// The second lowest hit of a cell, where it has one, is less likely to be an outlier.
CellHits lowHitsNearby(const PolarGrid& grid, const LowHits& lowHits)
{
    const int rings =
        std::min(grid.rings, static_cast<int>(PolarGrid::coordinate(kSearchRange)) + 1);
    CellHits nearby(0);
    for (int sector = 0; sector < PolarGrid::kSectors; sector += kSectorsAtOnce)
    {
        for (int ring = 0; ring < rings; ++ring)
        {
            LowHit lowest;
            for (int s = sector; s < sector + kSectorsAtOnce; ++s)
            {
                const auto cell = static_cast<std::size_t>(PolarGrid::cell(s, ring));
                const LowHit second = lowHits.second.at(cell);
                const LowHit hit = second.seen() ? second : lowHits.lowest.at(cell);
                if (hit.z < lowest.z) lowest = hit;
            }
            if (!lowest.seen()) continue;
            nearby.z.push_back(lowest.z);
            nearby.x.push_back(lowest.x);
            nearby.y.push_back(lowest.y);
        }
    }
    return nearby;
}

struct PlaneCandidate
{
    GroundPlane plane;
    float score = 0.0F;
};

constexpr int kMaxBins = 256;

// How many of the points lie in each bin over a plane through `bottom` with the slope.
std::array<int, kMaxBins> histogramOf(const CellHits& points, float slopeX, float slopeY,
                                      float bottom, float lastBin)
{
    const std::size_t size = points.z.size();
    std::vector<std::uint8_t> bins(size);
    inWideLanes([
        =, px = points.x.data(), py = points.y.data(), pz = points.z.data(), bin = bins.data()
    ]() __attribute__((always_inline)) {
        VDAMF_INDEPENDENT_LANES
        for (std::size_t i = 0; i < size; ++i)
        {
            const float z = pz[i] - slopeX * px[i] - slopeY * py[i];
            const float at = (z - bottom) * (1.0F / kHeightBin);
            const float above = at > 0.0F ? at : 0.0F;
            bin[i] = static_cast<std::uint8_t>(static_cast<int>(above < lastBin ? above : lastBin));
        }
    });
    // Four in turn: most points share a bin, and each would wait for the one before it.
    std::array<std::array<int, kMaxBins>, 4> parts{};
    for (std::size_t i = 0; i < size; ++i) ++parts[i % 4][bins[i]];
    std::array<int, kMaxBins> all{};
    for (std::size_t k = 0; k < kMaxBins; ++k)
        all[k] = parts[0][k] + parts[1][k] + parts[2][k] + parts[3][k];
    return all;
}

// The best height for the slope: many points in three bins, few below them (a LADAR does not see
// through the ground, but a mirror or the edge of a slope shows some).
PlaneCandidate bestHeight(const CellHits& points, float slopeX, float slopeY,
                          const GroundOptions& options)
{
    const auto bottom = static_cast<float>(-options.maxSensorHeight) - 2.0F * kHeightBin;
    const int bins =
        std::clamp(static_cast<int>((kSearchTop - bottom) / kHeightBin) + 2, 4, kMaxBins);
    const std::array<int, kMaxBins> histogram =
        histogramOf(points, slopeX, slopeY, bottom, static_cast<float>(bins - 1));
    PlaneCandidate best;
    int below = histogram[0];
    for (int bin = 1; bin + 3 < bins; ++bin)
    {
        const auto at = static_cast<std::size_t>(bin);
        const int inside = histogram[at] + histogram[at + 1] + histogram[at + 2];
        const float score = static_cast<float>(inside) - 0.5F * static_cast<float>(below);
        if (score > best.score)
        {
            const float height = bottom + (static_cast<float>(bin) + 1.5F) * kHeightBin;
            best = {{height, slopeX, slopeY}, score};
        }
        below += histogram[at];
    }
    return best;
}

// A slope has to be better than a flatter one by 2 %, so that few hits do not tilt the plane.
PlaneCandidate bestPlane(const CellHits& points, const GroundOptions& options)
{
    constexpr int kSteps = 3;
    constexpr float kStep = 0.05F;
    PlaneCandidate best;
    for (int level = 0; level <= kSteps; ++level)
    {
        for (int i = -level; i <= level; ++i)
        {
            for (int j = -level; j <= level; ++j)
            {
                if (std::max(std::abs(i), std::abs(j)) != level) continue;
                const PlaneCandidate c = bestHeight(points, static_cast<float>(i) * kStep,
                                                    static_cast<float>(j) * kStep, options);
                if (c.score > 1.02F * best.score) best = c;
            }
        }
    }
    return best;
}

// Of weight times products of x, y and the height e over a plane.
struct WeightedSums
{
    double w, x, y, xx, xy, yy, e, xe, ye;
};

// By a biweight: nothing from `width` (m) over or below the plane on.
WeightedSums sumsAbout(const CellHits& points, const GroundPlane& plane, float width)
{
    WeightedSums sums{};
    inWideLanes([
        =, px = points.x.data(), py = points.y.data(), pz = points.z.data(), size = points.z.size(),
        perWidth = 1.0F / width, result = &sums
    ]() __attribute__((always_inline)) {
        Floats w{}, wx{}, wy{}, wxx{}, wxy{}, wyy{}, we{}, wxe{}, wye{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats x, y, z;
            load(x, px + first, count);
            load(y, py + first, count);
            load(z, pz + first, count);
            const Floats e = z - plane.height - plane.slopeX * x - plane.slopeY * y;
            const Floats u = e * perWidth;
            const Floats off = 1.0F - u * u;
            const auto counts = (off > 0.0F) & (kLaneNumbers < static_cast<float>(count));
            const Floats weight = counts ? off * off : Floats{};
            w += weight;
            wx += weight * x;
            wy += weight * y;
            wxx += weight * x * x;
            wxy += weight * x * y;
            wyy += weight * y * y;
            we += weight * e;
            wxe += weight * x * e;
            wye += weight * y * e;
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        *result = {sumOf(w),   sumOf(wx), sumOf(wy),  sumOf(wxx), sumOf(wxy),
                   sumOf(wyy), sumOf(we), sumOf(wxe), sumOf(wye)};
    });
    return sums;
}

// Least squares, reweighted with a biweight whose width shrinks; a weak tie to the slope of the
// start keeps frames with one circle on the ground or a narrow view from turning over.
GroundPlane refine(const CellHits& points, const GroundPlane& start)
{
    GroundPlane plane = start;
    for (const float width : {0.6F, 0.45F, 0.3F, 0.25F, 0.25F})
    {
        const WeightedSums sums = sumsAbout(points, plane, width);
        Eigen::Matrix3d a = Eigen::Vector3d(1e-3, 50.0, 50.0).asDiagonal();
        Eigen::Vector3d b(0.0, 50.0 * (start.slopeX - plane.slopeX),
                          50.0 * (start.slopeY - plane.slopeY));
        a(0, 0) += sums.w;
        a(1, 0) += sums.x;
        a(2, 0) += sums.y;
        a(1, 1) += sums.xx;
        a(2, 1) += sums.xy;
        a(2, 2) += sums.yy;
        b += Eigen::Vector3d(sums.e, sums.xe, sums.ye);
        const Eigen::Vector3f step = Cholesky<3>(a).solve(b).cast<float>();
        plane = {plane.height + step[0], plane.slopeX + step[1], plane.slopeY + step[2]};
    }
    return plane;
}
}  // namespace

std::optional<GroundPlane> findGroundPlane(const PolarGrid& grid, const LowHits& lowHits,
                                           const GroundOptions& options)
{
    const CellHits points = lowHitsNearby(grid, lowHits);
    const PlaneCandidate best = bestPlane(points, options);
    if (best.score < kLeastSupport) return std::nullopt;
    // What a line scanner sees lies in a plane too: its own.
    if (best.plane.height > -static_cast<float>(options.minSensorHeight)) return std::nullopt;
    return refine(points, best.plane);
}

}  // namespace vdamf
