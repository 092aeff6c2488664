// SPDX-License-Identifier: BSD-3-Clause
// The discriminator at work on tracks.
#pragma once

#include <cstddef>
#include <vector>

#include "tracker/track.h"

namespace vdamf
{
/// Evidence of tracks that have hits in a frame.
class Discriminator
{
public:
    explicit Discriminator(const DiscriminatorOptions& options);

    /// With what the clusters of the track's measurement say.
    Judgement judged(const Track& track, const SegmentedFrame& frame,
                     const std::vector<std::size_t>& clusters) const;

    /// Whether the track is hardly a vehicle, by several frames.
    bool rulesOut(const Track& track) const;

    /// What the track covers: its box, or, of what is ruled out, the rectangle of its hits: what is
    /// no vehicle is not as large as one either.
    OrientedBox extentOf(const Track& track) const;

    /// By all frames of the track; 0.5 where nothing discriminates.
    double vehicleProbability(const Track& track) const;

    /// The report with the track's probability.
    TrackReport withProbability(TrackReport report, const Track& track) const;

private:
    bool mayTellMore(const Track& track, std::size_t hits) const;
    const DiscriminatorModel& model() const;

    DiscriminatorOptions options_;
};

}  // namespace vdamf
