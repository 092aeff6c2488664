// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/duplicates.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

// The younger one is the older one in another box: what was known of it did not let it have its
// hits.
bool isSuccessor(const Track& younger, const Track& older)
{
    constexpr double kLikely = 0.5;  // probability, of a vehicle
    return older.status == TrackStatus::Coasting && younger.status == TrackStatus::Tentative &&
           std::min(older.judgement.probability, younger.judgement.probability) > kLikely;
}

// A hedge around a car is not the car.
bool isVehicleBesideClutter(const Track& a, const Track& b)
{
    return a.judgement.probability > kSurelyAVehicle &&
           b.judgement.probability < 1.0 - kSurelyAVehicle;
}
}  // namespace

std::vector<Track> withDuplicatesEnded(std::vector<Track> tracks, std::vector<OrientedBox> extents)
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
            if (!keepOlder && isSuccessor(tracks[j], tracks[k]))
            {
                std::swap(tracks[j], tracks[k]);
                std::swap(tracks[j].id, tracks[k].id);
                std::swap(tracks[j].wasPublished, tracks[k].wasPublished);
                std::swap(extents[j], extents[k]);
                tracks[j].status = TrackStatus::Ended;
                continue;
            }
            (keepOlder ? tracks[j] : tracks[k]).status = TrackStatus::Ended;
        }
    }
    return tracks;
}

}  // namespace vdamf
