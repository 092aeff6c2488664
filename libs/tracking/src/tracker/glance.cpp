// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/glance.h"

#include <cmath>
#include <utility>

#include "tracker/attention.h"
#include "tracker/existence.h"

namespace vdamf
{
namespace
{
// Of rectangles of the same heading.
bool haveSameEnds(const OrientedBox& a, const OrientedBox& b)
{
    constexpr double kSame = 0.3;  // m
    const Eigen::Vector2d moved = toBoxFrame(a, b.centre()).cwiseAbs();
    const Eigen::Vector2d grown(std::abs(b.length - a.length), std::abs(b.width - a.width));
    return (moved + 0.5 * grown).maxCoeff() < kSame;
}
}  // namespace

bool isWhereItWas(const Track& track, const SegmentedFrame& frame,
                  const std::vector<std::size_t>& clusters)
{
    if (track.misses > 0 || !track.stood()) return false;
    const OrientedBox before = track.boxOfHits();
    return haveSameEnds(before, rectangleAround(*hitsOf(frame, clusters), before.heading));
}

bool isGlanceEnough(const Track& track, const SegmentedFrame& frame,
                    const std::vector<std::size_t>& clusters, const Discriminator& discriminator,
                    const DiscriminatorOptions& options)
{
    // Features are asked for to learn from: all of them.
    return !options.keepFeatures && isPassedOver(track, discriminator) &&
           isWhereItWas(track, frame, clusters);
}

Track glancedTrack(Track track, const SegmentedFrame& frame,
                   const std::vector<std::size_t>& clusters, const LifecycleOptions& options)
{
    track.hypotheses->standingProbability = track.stoodProbability;
    track.hypotheses->sinceMeasured = 0.0;
    double weight = 0.0;
    for (const std::size_t k : clusters) weight += frame.hits[k].totalWeight;
    track.hits = static_cast<int>(std::lround(weight));
    return withHit(std::move(track), frame.time, options);
}

}  // namespace vdamf
