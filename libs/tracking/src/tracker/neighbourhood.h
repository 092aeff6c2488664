// SPDX-License-Identifier: BSD-3-Clause
// Vehicles side by side or in line stand alike: what those around tell of one's axes.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "association/plane_index.h"
#include "tracker/discriminate.h"
#include "tracker/track.h"

namespace vdamf
{
/// The published tracks of a frame, as neighbours of others.
class Neighbourhood
{
public:
    Neighbourhood(const std::vector<Track>& tracks, const Discriminator& discriminator);

    /// Log odds that length and width of a box are as they are held rather than exchanged, by the
    /// vehicles around it but for the track `self`. Neighbours count by what they themselves showed
    /// of their axes, never by what their own neighbours tell.
    double axesEvidence(const OrientedBox& box, std::uint64_t self) const;

private:
    struct Neighbour
    {
        std::uint64_t id = 0;
        Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // m
        double heading = 0.0;                              // rad
        double logOdds = 0.0;  // that another's length lies along its heading
    };

    std::vector<Neighbour> neighbours_;
    PlaneIndex index_;
};

}  // namespace vdamf
