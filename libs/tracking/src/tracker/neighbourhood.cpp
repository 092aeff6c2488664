// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/neighbourhood.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kReach = 8.0;        // m between centres
constexpr double kAlike = 0.97;       // of the labelled vehicles with another one in reach
constexpr double kMostLogOdds = 3.0;  // log odds: what makes them stand otherwise holds for all
constexpr double kSame = 20.0 * kPi / 180.0;  // rad

bool isPublished(const Track& track)
{
    return track.status == TrackStatus::Confirmed || track.status == TrackStatus::Coasting;
}

std::vector<PlaneBounds> boundsOf(const std::vector<Track>& tracks)
{
    std::vector<PlaneBounds> bounds;
    for (const Track& track : tracks)
        if (isPublished(track)) bounds.push_back(PlaneBounds::around(track.box().centre(), 0.0));
    return bounds;
}
}  // namespace

Neighbourhood::Neighbourhood(const std::vector<Track>& tracks, const Discriminator& discriminator)
    : index_(boundsOf(tracks))
{
    for (const Track& track : tracks)
    {
        if (!isPublished(track)) continue;
        const double right = track.front.ownAxesProbability();
        const double alike = right * kAlike + (1.0 - right) * (1.0 - kAlike);
        const double vehicle = discriminator.vehicleProbability(track);
        const double p = vehicle * alike + (1.0 - vehicle) * 0.5;
        neighbours_.push_back(
            {track.id, track.box().centre(), track.state.mean(kHeading), std::log(p / (1.0 - p))});
    }
}

double Neighbourhood::axesEvidence(const OrientedBox& box, std::uint64_t self) const
{
    double sum = 0.0;
    for (const std::size_t k : index_.overlapping(PlaneBounds::around(box.centre(), kReach)))
    {
        const Neighbour& other = neighbours_[k];
        if (other.id == self || (other.centre - box.centre()).norm() > kReach) continue;
        const double turn = std::abs(std::remainder(other.heading - box.heading, kPi));
        if (turn < kSame)
            sum += other.logOdds;
        else if (turn > 0.5 * kPi - kSame)
            sum -= other.logOdds;
    }
    return std::clamp(sum, -kMostLogOdds, kMostLogOdds);
}

}  // namespace vdamf
