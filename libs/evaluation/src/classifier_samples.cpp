// SPDX-License-Identifier: BSD-3-Clause
#include "overlaps.h"
#include "vdamf/evaluation/roc.h"

namespace vdamf
{
namespace
{
enum class Ground
{
    Clutter,
    Vehicle,
    UncountedVehicle
};

Ground groundOf(const ScoredFrame& frame, const std::vector<std::vector<double>>& overlaps,
                std::size_t track, double minOverlap)
{
    Ground ground = Ground::Clutter;
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        const TruthRow& object = frame.truth[i];
        const bool on =
            isOn(object.box, frame.tracks[track].report.box, overlaps[i][track], minOverlap);
        if (!on || !isVehicleClass(object.objectClass)) continue;
        if (frame.counts[i]) return Ground::Vehicle;
        ground = Ground::UncountedVehicle;
    }
    return ground;
}
}  // namespace

std::vector<ClassifierSample> classifierSamples(const Sequence& sequence, double minOverlap)
{
    std::vector<ClassifierSample> samples;
    for (const ScoredFrame& frame : sequence.frames)
    {
        const auto overlaps = overlapsOf(frame);
        for (std::size_t j = 0; j < frame.tracks.size(); ++j)
        {
            const TrackReport& track = frame.tracks[j].report;
            if (!track.vehicleProbability) continue;
            const Ground ground = groundOf(frame, overlaps, j, minOverlap);
            if (ground == Ground::UncountedVehicle) continue;
            samples.push_back({track.id, *track.vehicleProbability, ground == Ground::Vehicle});
        }
    }
    return samples;
}

}  // namespace vdamf
