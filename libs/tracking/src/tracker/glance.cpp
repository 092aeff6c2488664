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
// By how much rectangles of the same heading differ along each axis at one of their ends, and at
// the other, m.
struct EndChanges
{
    Eigen::Vector2d least, most;
};

EndChanges changesOfEnds(const OrientedBox& a, const OrientedBox& b)
{
    const Eigen::Vector2d moved = toBoxFrame(a, b.centre()).cwiseAbs();
    const Eigen::Vector2d grown =
        0.5 * Eigen::Vector2d(b.length - a.length, b.width - a.width).cwiseAbs();
    return {(moved - grown).cwiseAbs(), moved + grown};
}
}  // namespace

bool isWhereItWas(const Track& track, const SegmentedFrame& frame,
                  const std::vector<std::size_t>& clusters, bool mayGrow)
{
    constexpr double kSame = 0.3;        // m
    constexpr double kSpeedSigma = 0.8;  // m/s
    if (track.misses > 0 || !track.stood() || track.state.speedSigma() > kSpeedSigma) return false;
    const OrientedBox before = track.boxOfHits();
    const EndChanges changes =
        changesOfEnds(before, rectangleAround(*hitsOf(frame, clusters), before.heading));
    return (mayGrow ? changes.least : changes.most).maxCoeff() < kSame;
}

bool isGlanceEnough(const Track& track, const SegmentedFrame& frame,
                    const std::vector<std::size_t>& clusters, const Discriminator& discriminator,
                    const DiscriminatorOptions& options)
{
    // Features are asked for to learn from: all of them.
    return !options.keepFeatures && isPassedOver(track, discriminator) &&
           isWhereItWas(track, frame, clusters, isSurelyNone(track));
}

Track glancedTrack(Track track, const SegmentedFrame& frame,
                   const std::vector<std::size_t>& clusters, const LifecycleOptions& options)
{
    track.hypotheses->standingProbability = track.stoodProbability;
    track.hypotheses->sinceMeasured = 0.0;
    const double heading = track.boxOfHits().heading;
    track.around = inFrameOf(track.box(), rectangleAround(*hitsOf(frame, clusters), heading));
    double weight = 0.0;
    for (const std::size_t k : clusters) weight += frame.hits[k].totalWeight;
    track.hits = static_cast<int>(std::lround(weight));
    return withHit(std::move(track), frame.time, options);
}

}  // namespace vdamf
