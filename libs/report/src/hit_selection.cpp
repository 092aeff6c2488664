// SPDX-License-Identifier: BSD-3-Clause
#include "hit_selection.h"

#include <cmath>
#include <cstring>
#include <unordered_set>

namespace vdamf
{
namespace
{
constexpr double kTrackMargin = 0.5;  // m around a track's box
constexpr float kCellGrowth = 1.4F;
constexpr float kLargestCell = 50.0F;  // m: a hit or a few of each cluster stay

/// A cell, or an exact position, as a number; collisions only cost a hit.
std::uint64_t keyOf(std::int64_t a, std::int64_t b, std::int64_t c)
{
    constexpr std::uint64_t kBits = 0x1FFFFF;
    const auto part = [](std::int64_t v) { return static_cast<std::uint64_t>(v) & kBits; };
    return part(a) << 42U | part(b) << 21U | part(c);
}

HitPositions onePerCell(const HitPositions& hits, float cell)
{
    std::unordered_set<std::uint64_t> taken;
    taken.reserve(hits.size());
    HitPositions kept;
    const auto index = [cell](float v) { return static_cast<std::int64_t>(std::floor(v / cell)); };
    for (const Eigen::Vector3f& p : hits)
        if (taken.insert(keyOf(index(p.x()), index(p.y()), index(p.z()))).second) kept.push_back(p);
    return kept;
}

HitPositions thinned(const HitPositions& hits, float cell, std::size_t limit)
{
    HitPositions kept = onePerCell(hits, cell);
    while (kept.size() > limit && cell < kLargestCell)
    {
        cell *= kCellGrowth;
        kept = onePerCell(hits, cell);
    }
    return kept;
}

std::size_t countOf(const std::vector<ShownCluster>& clusters)
{
    std::size_t count = 0;
    for (const ShownCluster& cluster : clusters) count += cluster.hits.size();
    return count;
}

/// Large clusters give way to small ones: the most hits that a cluster may keep falls until all of
/// them are few enough.
void thin(std::vector<ShownCluster>& clusters, float cell, std::size_t limit)
{
    constexpr std::size_t kMost = 800;
    for (std::size_t most = kMost;; most -= most / 5)
    {
        for (ShownCluster& cluster : clusters) cluster.hits = thinned(cluster.hits, cell, most);
        constexpr std::size_t kFewest = 5;
        if (countOf(clusters) <= limit || most <= kFewest) return;
    }
}

/// How many hits of a cluster lie in a box with some margin. All relative to the frame's origin.
std::size_t countIn(const OrientedBox& box, const Cluster& cluster)
{
    const Eigen::Matrix2f toBox = rotation(-box.heading).cast<float>();
    const Eigen::Vector2f centre = box.centre().cast<float>();
    const Eigen::Array2f half(0.5 * box.length + kTrackMargin, 0.5 * box.width + kTrackMargin);
    std::size_t count = 0;
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const Eigen::Array2f p = toBox * (Eigen::Vector2f(cluster.x[i], cluster.y[i]) - centre);
        count += (p.abs() < half).all() ? 1 : 0;
    }
    return count;
}

/// The published track whose box holds most of the hits, if it holds half of them.
std::uint64_t trackOf(const Cluster& cluster, const LadarFrame& frame, const FrameResult& result)
{
    const Eigen::Map<const Eigen::ArrayXf> x(cluster.x.data(),
                                             static_cast<Eigen::Index>(cluster.size()));
    const Eigen::Map<const Eigen::ArrayXf> y(cluster.y.data(), x.size());
    std::uint64_t best = 0;
    std::size_t most = cluster.size() / 2;
    for (const TrackReport& track : result.tracks)
    {
        if (!isPublished(track)) continue;
        OrientedBox box = track.measuredBox.value_or(track.box);
        box.x -= frame.origin.x();
        box.y -= frame.origin.y();
        const double reach = 0.5 * std::hypot(box.length, box.width) + 2.0 * kTrackMargin;
        if (x.minCoeff() > box.x + reach || x.maxCoeff() < box.x - reach ||
            y.minCoeff() > box.y + reach || y.maxCoeff() < box.y - reach)
            continue;
        const std::size_t inside = countIn(box, cluster);
        if (inside <= most) continue;
        most = inside;
        best = track.id;
    }
    return best;
}

/// The coordinates' bits: what is copied from the frame is found again by them.
std::uint64_t identityOf(float x, float y, float z)
{
    const auto bits = [](float v)
    {
        std::uint32_t b = 0;
        std::memcpy(&b, &v, sizeof(b));
        return static_cast<std::uint64_t>(b);
    };
    return bits(x) * 0x9E3779B97F4A7C15ULL ^ bits(y) * 0xC2B2AE3D27D4EB4FULL ^ bits(z);
}

// Adds the hits in reach that no cluster has.
ShownHits withOthers(ShownHits shown, const LadarFrame& frame, const AboveGround& above,
                     const std::unordered_set<std::uint64_t>& clustered, double maxRange)
{
    const Eigen::Vector3f sensor = (frame.sensor - frame.origin).cast<float>();
    std::size_t next = 0;
    for (std::size_t i = 0; i < frame.points.size(); ++i)
    {
        const Eigen::Vector3f p(frame.points.x[i], frame.points.y[i], frame.points.z[i]);
        const bool stands = next < above.index.size() && above.index[next] == i;
        if (stands) ++next;
        if (!((p - sensor).norm() < maxRange)) continue;
        if (stands && clustered.count(identityOf(p.x(), p.y(), p.z())) != 0) continue;
        (stands               ? shown.structure
         : p.z() > sensor.z() ? shown.overhead
                              : shown.ground)
            .push_back(p);
    }
    return shown;
}
}  // namespace

ShownHits selectHits(const LadarFrame& frame, const FrameResult& result,
                     const HitSelectionOptions& options)
{
    constexpr float kFine = 0.04F;
    constexpr float kCoarse = 0.15F;
    constexpr float kGround = 0.4F;
    const AboveGround above = removeGround(frame, options.ground);
    const std::vector<Cluster> clusters = clusterPoints(frame, above, options.clustering);
    ShownHits shown;
    shown.aboveGround = above.index.size();
    shown.clusterCount = clusters.size();

    std::unordered_set<std::uint64_t> clustered;
    std::vector<ShownCluster> loose;
    for (const Cluster& cluster : clusters)
    {
        ShownCluster s;
        s.track = trackOf(cluster, frame, result);
        for (std::size_t i = 0; i < cluster.size(); ++i)
        {
            clustered.insert(identityOf(cluster.x[i], cluster.y[i], cluster.z[i]));
            s.hits.emplace_back(cluster.x[i], cluster.y[i], cluster.z[i]);
        }
        (s.track != 0 ? shown.clusters : loose).push_back(std::move(s));
    }
    shown = withOthers(std::move(shown), frame, above, clustered, options.maxRange);
    std::size_t left = options.hitsPerFrame;
    thin(shown.clusters, kFine, left / 3 * 2);
    left -= countOf(shown.clusters);
    shown.ground = thinned(shown.ground, kGround, left / 4);
    shown.overhead = thinned(shown.overhead, kGround, left / 8);
    shown.structure = thinned(shown.structure, kCoarse, left / 4);
    thin(loose, kCoarse, left / 4);
    for (ShownCluster& cluster : loose) shown.clusters.push_back(std::move(cluster));
    return shown;
}

}  // namespace vdamf
