// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/duplicates.h"

#include <cmath>

#include "association/plane_index.h"

namespace vdamf
{
namespace
{
constexpr double kSameObject = 0.4;  // of the size, from the middle

bool sameObject(const Track& a, const Track& b)
{
    const Eigen::Vector2d inA = toBoxFrame(a.box(), b.state.mean.head<2>());
    const Eigen::Vector2d inB = toBoxFrame(b.box(), a.state.mean.head<2>());
    const auto inside = [](const Eigen::Vector2d& p, const OrientedBox& box) {
        return std::abs(p.x()) < kSameObject * box.length &&
               std::abs(p.y()) < kSameObject * box.width;
    };
    return inside(inA, a.box()) || inside(inB, b.box());
}
}  // namespace

std::vector<Track> withDuplicatesEnded(std::vector<Track> tracks)
{
    std::vector<PlaneBounds> bounds;
    bounds.reserve(tracks.size());
    for (const Track& track : tracks)
        bounds.push_back(PlaneBounds::around(
            track.box().centre(), kSameObject * std::hypot(track.box().length, track.box().width)));
    const PlaneIndex index(bounds);
    for (std::size_t j = 1; j < tracks.size(); ++j)
    {
        for (const std::size_t k : index.overlapping(bounds[j]))
        {
            if (k >= j || tracks[j].status == TrackStatus::Ended) break;
            if (tracks[k].status == TrackStatus::Ended || !sameObject(tracks[k], tracks[j]))
                continue;
            const bool keepOlder = tracks[k].misses <= tracks[j].misses;
            (keepOlder ? tracks[j] : tracks[k]).status = TrackStatus::Ended;
        }
    }
    return tracks;
}

}  // namespace vdamf
