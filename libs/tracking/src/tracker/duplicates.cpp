// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/duplicates.h"

#include <cmath>

#include "association/plane_index.h"
#include "tracker/discriminate.h"

namespace vdamf
{
namespace
{
constexpr double kSameObject = 0.4;  // of the size, from the middle

// `a`, `b`: their extents.
bool sameObject(const OrientedBox& a, const OrientedBox& b)
{
    const auto inside = [](const Eigen::Vector2d& p, const OrientedBox& box) {
        return std::abs(p.x()) < kSameObject * box.length &&
               std::abs(p.y()) < kSameObject * box.width;
    };
    return inside(toBoxFrame(a, b.centre()), a) || inside(toBoxFrame(b, a.centre()), b);
}

// A hedge around a car is not the car.
bool isVehicleBesideClutter(const Track& a, const Track& b)
{
    return a.judgement.probability > kSurelyAVehicle &&
           b.judgement.probability < 1.0 - kSurelyAVehicle;
}
}  // namespace

std::vector<Track> withDuplicatesEnded(std::vector<Track> tracks,
                                       const std::vector<OrientedBox>& extents)
{
    std::vector<PlaneBounds> bounds;
    bounds.reserve(tracks.size());
    for (const OrientedBox& box : extents)
        bounds.push_back(
            PlaneBounds::around(box.centre(), kSameObject * std::hypot(box.length, box.width)));
    const PlaneIndex index(bounds);
    for (std::size_t j = 1; j < tracks.size(); ++j)
    {
        for (const std::size_t k : index.overlapping(bounds[j]))
        {
            if (k >= j || tracks[j].status == TrackStatus::Ended) break;
            if (tracks[k].status == TrackStatus::Ended || !sameObject(extents[k], extents[j]))
                continue;
            const bool keepOlder = isVehicleBesideClutter(tracks[k], tracks[j]) ||
                                   (tracks[k].misses <= tracks[j].misses &&
                                    !isVehicleBesideClutter(tracks[j], tracks[k]));
            (keepOlder ? tracks[j] : tracks[k]).status = TrackStatus::Ended;
        }
    }
    return tracks;
}

}  // namespace vdamf
