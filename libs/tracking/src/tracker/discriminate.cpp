// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/discriminate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tracker/one_time.h"
#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
namespace
{
// Walls and hedges do not drive. What seems to is thin across its way, as guard rails are, or jumps
// as ever other parts of it come into view.
bool drives(const Track& track)
{
    constexpr double kThinnest = 1.6;  // m, across its way
    constexpr double kWidest = 3.5;    // m
    constexpr double kLowest = 2.0;    // m: the shape of what is lower tells enough
    constexpr double kFar = 6.0;       // m, in the last seconds
    constexpr std::size_t kSome = 4;   // sightings
    constexpr double kLong = 1.05;     // s
    constexpr double kFast = 2.0;      // m/s, for sure
    constexpr double kSigmas = 3.0;
    constexpr double kUneven = 0.2;  // of the way
    if (track.stood() || track.path.size() < kSome || track.height < kLowest ||
        track.around.width < kThinnest || track.around.width > kWidest)
        return false;
    const double speed = std::abs(track.state.mean(kSpeed));
    if (speed - kSigmas * track.state.speedSigma() < kFast) return false;
    const PathPoint& first = track.path.front();
    const PathPoint& middle = track.path[track.path.size() / 2];
    const PathPoint& last = track.path.back();
    const Eigen::Vector2d way = last.box.centre() - first.box.centre();
    const double time = last.time - first.time;
    if (time < kLong) return false;
    const Eigen::Vector2d evenly =
        first.box.centre() + (middle.time - first.time) / time * way - middle.box.centre();
    return way.norm() > kFar && evenly.norm() < kUneven * way.norm() &&
           std::abs(way.norm() - speed * time) < kUneven * speed * time &&
           std::abs(last.box.length - first.box.length) < kUneven * way.norm();
}

// Whether a box lies so much across another one that what was seen in that was seen wrongly.
bool isTurned(const OrientedBox& box, const OrientedBox& before)
{
    constexpr double kTurn = 0.77;  // sine of the angle between their axes: 50 degrees
    return std::abs(std::sin(box.heading - before.heading)) > kTurn;
}

// What is left of the evidence of a box that has turned.
VehicleEvidence mostlyForgotten(const VehicleEvidence& evidence)
{
    constexpr double kLeft = 0.35;
    return {kLeft * evidence.sum, kLeft * evidence.frames};
}

// Whether it may be a piece of a vehicle that lies as those around it do, seen at its end.
bool liesAsOthers(const Track& track, const OrientedBox& extent)
{
    constexpr double kWidestEnd = 2.6;  // m
    constexpr double kTold = 1.0;       // log odds
    return extent.width < kWidestEnd && track.front.axesByNeighbours() > kTold;
}
}  // namespace

bool isSurelyNone(const Track& track)
{
    constexpr double kSurely = 0.01;  // probability of a vehicle
    return track.judgement.probability < kSurely;
}

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
    constexpr int kFirst = 3;             // sightings: by these it may be ruled out
    constexpr int kFirstIfOpen = 5;       // of one that is not certain
    constexpr double kCertain = 2.2;      // log odds
    constexpr double kMostCertain = 3.3;  // log odds
    constexpr double kAlike = 1.5;        // ratio of numbers of hits
    const Judgement& last = track.judgement;
    const double certainty = std::abs(trackLogOdds(last.evidence, model().track));
    const bool isCertain = certainty > kCertain;
    if (track.sightings <= (isCertain ? kFirst : kFirstIfOpen)) return true;
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
        ObjectView view = viewOf(*track.measurement, frame, clusters);
        HitsAtOneTime together;
        if (track.areParts)
        {
            // What moves has a step there.
            together = hitsAtOneTime(frame, clusters, motionOf(track.state), 0.0);
            view.clusters = {&*together.each};
        }
        std::size_t hits = 0;
        for (const std::size_t k : clusters) hits += frame.clusters[k].size();
        const OrientedBox& box = track.measurement->box;
        const bool turned = next.hits > 0 && isTurned(box, next.box);
        if (turned) next.evidence = mostlyForgotten(next.evidence);
        if (turned || mayTellMore(track, hits))
        {
            next.logOdds = frameLogOdds(model().frame, objectScore(view, model()), hits);
            next.hits = hits;
            next.box = box;
        }
        if (options_.keepFeatures) next.features = objectFeatures(view, model().grid);
    }
    // What was not looked at is taken to say the same again.
    next.evidence = withFrame(next.evidence, next.logOdds, model().track, model().frame.prior);
    constexpr double kByDriving = 6.0;  // log odds
    next.hasDriven = next.hasDriven || drives(track);
    next.probability = toProbability(trackLogOdds(next.evidence, model().track) +
                                     (next.hasDriven ? kByDriving : 0.0));
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
    const bool liesAcross = track.stood() && !track.isFaceless && extent.width > extent.length &&
                            !liesAsOthers(track, extent);
    if (!liesAcross) return extent;
    return {extent.x, extent.y, wrapAngle(extent.heading + 0.5 * kPi), extent.width, extent.length};
}

std::vector<OrientedBox> Discriminator::extentsOf(const std::vector<Track>& tracks) const
{
    std::vector<OrientedBox> all;
    all.reserve(tracks.size());
    for (const Track& track : tracks) all.push_back(extentOf(track));
    return all;
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
