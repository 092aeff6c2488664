// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/discriminate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
Discriminator::Discriminator(const DiscriminatorOptions& options) : options_(options) {}

const DiscriminatorModel& Discriminator::model() const
{
    return options_.loaded ? *options_.loaded : defaultDiscriminatorModel();
}

// Frames in a row show nearly the same. After the first ones every other frame is enough, of a
// track that is certain either way every fourth, of one that is most certain every eighth, and
// those that show more of it or less.
bool Discriminator::mayTellMore(const Track& track, std::size_t hits) const
{
    constexpr int kFirst = 5;             // sightings
    constexpr double kCertain = 2.2;      // log odds
    constexpr double kMostCertain = 3.3;  // log odds
    constexpr double kAlike = 1.5;        // ratio of numbers of hits
    const Judgement& last = track.judgement;
    const double certainty = std::abs(trackLogOdds(last.evidence, model().track));
    const bool isCertain = certainty > kCertain;
    if (!isCertain && track.sightings <= kFirst) return true;
    const std::uint64_t turns = certainty > kMostCertain ? 8 : (isCertain ? 4 : 2);
    if ((static_cast<std::uint64_t>(track.sightings) + track.id) % turns == 0) return true;
    const double ratio = static_cast<double>(hits) / static_cast<double>(last.hits);
    return ratio > kAlike || ratio * kAlike < 1.0;
}

ObjectView Discriminator::viewOf(const Measurement& measurement, const SegmentedFrame& frame,
                                 const std::vector<std::size_t>& clusters) const
{
    ObjectView view;
    view.box = measurement.box;
    view.sensor = frame.sensor;
    view.match = measurement.match;
    view.frameHits = frame.points;
    view.planar = frame.planar;
    for (const std::size_t k : clusters) view.clusters.push_back(&frame.clusters[k]);
    return view;
}

double Discriminator::vehicleProbability(const Measurement& measurement,
                                         const SegmentedFrame& frame,
                                         const std::vector<std::size_t>& clusters) const
{
    if (options_.isOff()) return 0.5;
    std::size_t hits = 0;
    for (const std::size_t k : clusters) hits += frame.clusters[k].size();
    const double score = objectScore(viewOf(measurement, frame, clusters), model());
    return toProbability(frameLogOdds(model().frame, score, hits));
}

Judgement Discriminator::judged(const Track& track, const SegmentedFrame& frame,
                                const std::vector<std::size_t>& clusters) const
{
    Judgement next = track.judgement;
    if (options_.isOff() || track.hits == 0) return next;
    if (track.measurement)
    {
        const ObjectView view = viewOf(*track.measurement, frame, clusters);
        std::size_t hits = 0;
        for (const std::size_t k : clusters) hits += frame.clusters[k].size();
        if (mayTellMore(track, hits))
        {
            next.logOdds = frameLogOdds(model().frame, objectScore(view, model()), hits);
            next.hits = hits;
        }
        if (options_.keepFeatures) next.features = objectFeatures(view, model().grid);
    }
    // What was not looked at is taken to say the same again.
    next.evidence = withFrame(next.evidence, next.logOdds, model().track, model().frame.prior);
    next.probability = toProbability(trackLogOdds(next.evidence, model().track));
    return next;
}

double Discriminator::vehicleProbability(const Track& track) const
{
    return track.judgement.probability;
}

bool Discriminator::rulesOut(const Track& track) const
{
    constexpr int kSightings = 3;
    constexpr double kHardly = 0.1;  // probability
    return !options_.isOff() && track.sightings >= kSightings &&
           vehicleProbability(track) < kHardly;
}

OrientedBox Discriminator::extentOf(const Track& track) const
{
    if (!rulesOut(track)) return track.box();
    constexpr double kThinnest = 0.1;  // m
    OrientedBox extent = track.boxOfHits();
    extent.length = std::max(extent.length, kThinnest);
    extent.width = std::max(extent.width, kThinnest);
    return extent;
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
