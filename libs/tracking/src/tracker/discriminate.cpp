// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/discriminate.h"

#include <utility>

#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
Discriminator::Discriminator(const DiscriminatorOptions& options) : options_(options) {}

const DiscriminatorModel& Discriminator::model() const
{
    return options_.loaded ? *options_.loaded : defaultDiscriminatorModel();
}

Track Discriminator::judged(Track track, const SegmentedFrame& frame,
                            const std::vector<std::size_t>& clusters) const
{
    if (options_.isOff() || !track.measurement) return track;
    ObjectView view;
    view.box = track.measurement->box;
    view.sensor = frame.sensor;
    view.match = track.measurement->match;
    view.frameHits = frame.points;
    view.planar = frame.planar;
    std::size_t hits = 0;
    for (const std::size_t k : clusters)
    {
        view.clusters.push_back(&frame.clusters[k]);
        hits += frame.clusters[k].size();
    }
    const double score = objectScore(view, model());
    track.evidence = withFrame(track.evidence, frameLogOdds(model().frame, score, hits),
                               model().track, model().frame.prior);
    if (options_.keepFeatures) track.features = objectFeatures(view, model().grid);
    return track;
}

double Discriminator::vehicleProbability(const Track& track) const
{
    if (options_.isOff()) return 0.5;
    return toProbability(trackLogOdds(track.evidence, model().track));
}

bool Discriminator::rulesOut(const Track& track) const
{
    constexpr int kSightings = 3;
    constexpr double kHardly = 0.1;  // probability
    return !options_.isOff() && track.sightings >= kSightings &&
           vehicleProbability(track) < kHardly;
}

TrackReport Discriminator::withProbability(TrackReport report, const Track& track) const
{
    if (options_.isOff()) return report;
    const double probability = vehicleProbability(track);
    report.vehicleProbability = probability;
    report.isVehicle = probability >= options_.minProbability;
    return report;
}

}  // namespace vdamf
