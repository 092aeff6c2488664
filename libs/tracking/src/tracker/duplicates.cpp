// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/duplicates.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "association/plane_index.h"

namespace vdamf
{
namespace
{
bool onOneObject(const Track& a, const Track& b)
{
    const Eigen::Vector2d inA = toBoxFrame(a.box(), b.state.mean.head<2>());
    const Eigen::Vector2d inB = toBoxFrame(b.box(), a.state.mean.head<2>());
    const auto inside = [](const Eigen::Vector2d& p, const OrientedBox& box)
    { return std::abs(p.x()) < 0.4 * box.length && std::abs(p.y()) < 0.4 * box.width; };
    return inside(inA, a.box()) || inside(inB, b.box());
}

double speedSigma(const Track& track)
{
    return std::sqrt(track.state.covariance(kSpeed, kSpeed));
}

bool moveAlike(const Track& a, const Track& b)
{
    constexpr double kAlike = 1.0;   // m/s
    constexpr double kSigmas = 2.0;  // of both speeds
    const double sigma = std::hypot(speedSigma(a), speedSigma(b));
    return (a.velocity() - b.velocity()).norm() < kAlike + kSigmas * sigma;
}

// The newer track of an object that the older one has lost, under its identity.
Track goingOn(const Track& older, Track newer)
{
    newer.id = older.id;
    newer.sightings += older.sightings;
    newer.existence = std::max(older.existence, newer.existence);
    return newer;
}

void settle(Track& older, Track& newer)
{
    const bool isPublished = older.status == TrackStatus::Coasting;
    const bool isLost = older.misses > newer.misses;
    if (isLost && isPublished && newer.status == TrackStatus::Tentative) return;
    if (isLost && isPublished && moveAlike(older, newer)) older = goingOn(older, newer);
    (older.misses > newer.misses ? older : newer).status = TrackStatus::Ended;
}
}  // namespace

std::vector<Track> withoutDuplicates(std::vector<Track> tracks)
{
    std::vector<PlaneBounds> bounds;
    bounds.reserve(tracks.size());
    for (const Track& track : tracks)
        bounds.push_back(PlaneBounds::around(track.box().centre(),
                                             std::max(track.box().length, track.box().width)));
    const PlaneIndex index(bounds);
    for (std::size_t j = 1; j < tracks.size(); ++j)
    {
        for (const std::size_t k : index.overlapping(bounds[j]))
        {
            if (k >= j || tracks[j].status == TrackStatus::Ended) break;
            if (tracks[k].status != TrackStatus::Ended && onOneObject(tracks[k], tracks[j]))
                settle(tracks[k], tracks[j]);
        }
    }
    return tracks;
}

}  // namespace vdamf
