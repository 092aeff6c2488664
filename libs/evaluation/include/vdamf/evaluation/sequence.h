// SPDX-License-Identifier: BSD-3-Clause
// Truth and tracks side by side, frame by frame, cut to what is scored.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vdamf/evaluation/tables.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
/// What counts. Truth that does not count is "don't care": it is neither found nor missed, and a
/// track on it is no false alarm.
struct ScoringOptions
{
    std::vector<std::string> classes = vehicleClasses();  ///< of the objects that count
    double overlap = 0.5;         ///< bird's-eye IoU from which a track has found an object
    int minPoints = 1;            ///< objects with fewer hits are don't care; unknown counts count
    double maxRange = 0.0;        ///< region: centres this near to the sensor, m; 0: all
    double regionFov = 0.0;       ///< region: labelled sector ahead, rad; 0: all around
    bool onlyVehicles = false;    ///< drop tracks that the discriminator takes for clutter
    bool withTentative = false;   ///< score tentative tracks too
    double timeTolerance = 1e-3;  ///< between rows of one frame, s
};

/// One frame as it is scored.
struct ScoredFrame
{
    double time = 0.0;  ///< s
    std::optional<PlanePose> sensor;
    std::vector<TruthRow> truth;   ///< by objectId
    std::vector<bool> counts;      ///< for each of `truth`; false: don't care
    std::vector<TrackRow> tracks;  ///< by id
};

/// All frames of the truth and of the tracks, by time. A frame of the truth without tracks is a
/// frame of misses; rows of tracks at times between the first and last frame of the truth that no
/// object has are false alarms, those outside of it are not scored.
struct Sequence
{
    std::vector<ScoredFrame> frames;
};

/// Objects of the classes asked for (Car, Van, Truck, Tram, Bus) with their centre in the region
/// and with enough hits count; all other truth is don't care. Unpublished tracks (tentative, ended)
/// are left out, and those with their centre outside of the region, unless they overlap an object
/// that counts by `overlap`: at the border truth and track may stand on different sides of it, and
/// that is neither a miss nor a false alarm. The sensor's pose at frames whose rows have none is
/// interpolated between those that have one. Throws std::runtime_error where the region needs the
/// sensor's pose and the truth has none (it names the missing columns), where an object or a track
/// stands twice in a frame, where the truth is empty, and where no frame of the two tables has a
/// time in common. No tracks at all: every object is missed.
Sequence makeSequence(const std::vector<TruthRow>& truth, const std::vector<TrackRow>& tracks,
                      const ScoringOptions& options);

}  // namespace vdamf
