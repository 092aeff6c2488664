// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/convex_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "preprocessing/bearing.h"
#include "types/append_hit.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
constexpr int kBearings = 1440;         // of a turn
constexpr float kAboveKerbs = 0.3F;     // m: below are kerbs and grass
constexpr float kBelowMirrors = 1.2F;   // m: above are mirrors, branches and roofs
constexpr double kDent = 0.5;           // m: wheel houses are shallower
constexpr float kBehindNearest = 0.6F;  // m behind the nearest hit: of the same face
constexpr std::size_t kFewest = 3;      // places of an outline that is cut

struct OutlinePoint
{
    std::uint32_t sector;
    float range;
    Eigen::Vector2d place;
};

// Sectors are numbered from the first one that has hits.
struct Bearings
{
    std::vector<std::uint32_t> sector;
    std::vector<float> range;
    std::uint32_t sectors = 0;  // from the first to the last one
};

// First and last of some sectors.
struct Span
{
    std::uint32_t first = kBearings, last = 0;
};

Span spanOf(const std::vector<std::uint32_t>& sectors)
{
    Span span;
    inWideLanes([ s = sectors.data(), size = sectors.size(), &span ]()
                    __attribute__((always_inline)) {
                        Span all;
                        for (std::size_t i = 0; i < size; ++i)
                        {
                            all.first = s[i] < all.first ? s[i] : all.first;
                            all.last = s[i] > all.last ? s[i] : all.last;
                        }
                        span = all;
                    });
    return span;
}

// Hits on both sides of where turns begin anew are numbered from the opposite side.
void numberFromFirst(Bearings& bearings)
{
    constexpr std::uint32_t kHalf = kBearings / 2;
    if (bearings.sector.empty()) return;
    Span span = spanOf(bearings.sector);
    if (span.last - span.first > kHalf)
    {
        for (std::uint32_t& s : bearings.sector) s = s < kHalf ? s + kHalf : s - kHalf;
        span = spanOf(bearings.sector);
    }
    for (std::uint32_t& s : bearings.sector) s -= span.first;
    bearings.sectors = span.last - span.first + 1;
}

Bearings bearingsOf(const Cluster& cluster, const Eigen::Vector2f& sensor)
{
    Bearings b{std::vector<std::uint32_t>(cluster.size()), std::vector<float>(cluster.size())};
    inWideLanes([
        x = cluster.x.data(), y = cluster.y.data(), size = cluster.size(), sx = sensor.x(),
        sy = sensor.y(), sectors = b.sector.data(), ranges = b.range.data()
    ]() __attribute__((always_inline)) {
        VDAMF_INDEPENDENT_LANES
        for (std::size_t i = 0; i < size; ++i)
        {
            const float dx = x[i] - sx;
            const float dy = y[i] - sy;
            const int at =
                static_cast<int>(turns(dx, dy, FineArc()) * static_cast<float>(kBearings));
            sectors[i] = static_cast<std::uint32_t>(at < kBearings ? at : kBearings - 1);
            ranges[i] = std::sqrt(dx * dx + dy * dy);
        }
    });
    numberFromFirst(b);
    return b;
}

// Nearest hits, counter-clockwise, from behind the widest gap.
std::vector<OutlinePoint> outlineOf(const Cluster& cluster, const Bearings& bearings)
{
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> nearest(bearings.sectors, kNone);
    for (std::uint32_t i = 0; i < cluster.size(); ++i)
    {
        if (cluster.height[i] < kAboveKerbs || cluster.height[i] > kBelowMirrors) continue;
        std::uint32_t& best = nearest[bearings.sector[i]];
        if (best == kNone || bearings.range[i] < bearings.range[best]) best = i;
    }
    std::vector<OutlinePoint> outline;
    outline.reserve(nearest.size());
    std::size_t start = 0;
    std::uint32_t widest = 0;
    for (std::uint32_t s = 0; s < nearest.size(); ++s)
    {
        const std::uint32_t i = nearest[s];
        if (i == kNone) continue;
        if (!outline.empty() && s - outline.back().sector > widest)
        {
            widest = s - outline.back().sector;
            start = outline.size();
        }
        outline.push_back({s, bearings.range[i], Eigen::Vector2d(cluster.x[i], cluster.y[i])});
    }
    if (outline.empty()) return outline;
    if (static_cast<std::uint32_t>(kBearings) - outline.back().sector + outline.front().sector >=
        widest)
        start = 0;
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(start),
                outline.end());
    return outline;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Of the places from `first` to before `end` that one which is the farthest behind the outline's
// hull, or `end` where none is far.
std::size_t deepestDent(const std::vector<OutlinePoint>& outline, std::size_t first,
                        std::size_t end)
{
    std::vector<std::size_t> hull;
    for (std::size_t i = first; i < end; ++i)
    {
        const auto isDent = [&]
        {
            const Eigen::Vector2d& a = outline[hull[hull.size() - 2]].place;
            const Eigen::Vector2d& b = outline[hull.back()].place;
            return cross(b - a, outline[i].place - b) > 0.0;
        };
        while (hull.size() >= 2 && isDent()) hull.pop_back();
        hull.push_back(i);
    }
    std::size_t deepest = end;
    double most = kDent;
    for (std::size_t k = 0; k + 1 < hull.size(); ++k)
    {
        const Eigen::Vector2d& a = outline[hull[k]].place;
        const Eigen::Vector2d along = (outline[hull[k + 1]].place - a).normalized();
        for (std::size_t i = hull[k] + 1; i < hull[k + 1]; ++i)
        {
            const double depth = std::abs(cross(along, outline[i].place - a));
            if (depth <= most) continue;
            most = depth;
            deepest = i;
        }
    }
    return deepest;
}

// Where pieces begin, behind `first`.
void findCuts(const std::vector<OutlinePoint>& outline, std::size_t first, std::size_t end,
              std::vector<std::size_t>& cuts)
{
    if (end - first < kFewest) return;
    std::size_t dent = deepestDent(outline, first, end);
    if (dent == end) return;
    // It goes with the nearer one of its neighbours.
    const auto gap = [&](std::size_t i)
    { return (outline[i].place - outline[i - 1].place).squaredNorm(); };
    if (gap(dent) < gap(dent + 1)) ++dent;
    findCuts(outline, first, dent, cuts);
    cuts.push_back(dent);
    findCuts(outline, dent, end, cuts);
}
}  // namespace

std::vector<Cluster> convexPieces(const Cluster& cluster, const Eigen::Vector2d& sensor)
{
    const Bearings bearings = bearingsOf(cluster, sensor.cast<float>());
    const std::vector<OutlinePoint> outline = outlineOf(cluster, bearings);
    std::vector<std::size_t> cuts;
    findCuts(outline, 0, outline.size(), cuts);
    if (cuts.empty()) return {};
    struct Sector
    {
        std::size_t piece = 0;
        float farthest = 0.0F;
    };
    std::vector<Sector> sectors(bearings.sectors);
    std::size_t piece = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        if (piece < cuts.size() && i == cuts[piece]) ++piece;
        sectors[outline[i].sector] = {piece, outline[i].range + kBehindNearest};
    }
    std::vector<Cluster> pieces(cuts.size() + 1);
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const Sector& sector = sectors[bearings.sector[i]];
        if (bearings.range[i] <= sector.farthest) appendHit(pieces[sector.piece], cluster, i);
    }
    return pieces;
}

}  // namespace vdamf
