// SPDX-License-Identifier: BSD-3-Clause
// The discriminator at work on tracks.
#pragma once

#include <cstddef>
#include <vector>

#include "tracker/track.h"
#include "vdamf/tracking/discrimination/canonical_frame.h"

namespace vdamf
{
/// Probability from which on something is surely a vehicle.
constexpr double kSurelyAVehicle = 0.8;
/// Height from which on a vehicle may be a truck, m.
constexpr double kLowestTruck = 2.2;

/// Whether the track is surely no vehicle.
bool isSurelyNone(const Track& track);

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
    /// no vehicle is not as large as one either, and lies along its longer side where it stands.
    OrientedBox extentOf(const Track& track) const;
    std::vector<OrientedBox> extentsOf(const std::vector<Track>& tracks) const;

    /// By all frames of the track; 0.5 where nothing discriminates.
    double vehicleProbability(const Track& track) const;

    /// Of hits measured as that, by this frame alone; 0.5 where nothing discriminates.
    double vehicleProbability(const Measurement& measurement, const SegmentedFrame& frame,
                              const std::vector<std::size_t>& clusters) const;

    /// The report with the track's probability.
    TrackReport withProbability(TrackReport report, const Track& track) const;

private:
    ObjectView viewOf(const Measurement& measurement, const SegmentedFrame& frame,
                      const std::vector<std::size_t>& clusters) const;
    bool mayTellMore(const Track& track, std::size_t hits) const;
    const DiscriminatorModel& model() const;

    DiscriminatorOptions options_;
};

}  // namespace vdamf
