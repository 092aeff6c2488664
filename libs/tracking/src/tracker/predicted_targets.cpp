// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/predicted_targets.h"

#include <algorithm>

#include "association/vehicle_surface.h"
#include "vdamf/tracking/estimation/assumed_size.h"

namespace vdamf
{
namespace
{
bool isCar(const Track& track)
{
    return track.height < kLowestTruck && track.box().width < widestCar(track.height);
}

// What is as low as a car by its faces, and no truck's cab either: those are less sure.
bool isCarUnderATree(const Track& track)
{
    constexpr double kBeyondDoubt = 0.95;  // probability
    return track.judgement.probability > kBeyondDoubt && track.tallest > 0.0 &&
           track.tallest < kLowestTruck && track.box().width < widestCar(track.tallest);
}

// One that stands: of one that drives no more than the width is certain.
bool isTruckOfKnownSize(const Track& track)
{
    return track.stood() && track.told.length && track.told.width &&
           track.box().width < kWidestTruck &&
           std::max(track.lengthSigma(), track.widthSigma()) < kSureSize;
}

// Of what was lost from sight, and not surely no vehicle, the last hits.
bool mayHaveBeenAPart(const Track& track)
{
    return track.misses > 0 && !isSurelyNone(track);
}
}  // namespace

std::vector<PredictedTarget> predictedTargets(const std::vector<Track>& tracks,
                                              const Discriminator& discriminator, double interval,
                                              const LifecycleOptions& options)
{
    constexpr double kMayStand = 0.05;      // probability
    constexpr double kGreatestSigma = 2.0;  // m
    // Between the frames of a slow sensor what is new goes farther than from one lane to another.
    const double greatestSigma = std::max(kGreatestSigma, interval * options.startSpeedSigma);
    std::vector<PredictedTarget> all;
    all.reserve(tracks.size());
    for (const Track& track : tracks)
    {
        const double probability = discriminator.vehicleProbability(track);
        // What is no vehicle is not as large as one either.
        const bool isAsLarge = !discriminator.rulesOut(track) || mayHaveBeenAPart(track);
        PredictedTarget target;
        target.box = isAsLarge ? track.box() : track.boxOfHits();
        target.positionSigma = track.boxSigma();
        target.greatestSigma = greatestSigma;
        target.lengthSigma = isAsLarge ? track.lengthSigma() : 0.0;
        target.widthSigma = isAsLarge ? track.widthSigma() : 0.0;
        target.velocity = track.velocity();
        target.endSigma = track.endSigma();
        target.speedSigma = track.state.speedSigma();
        target.speedCovariance = track.speedCovariance();
        target.isBounded = probability > kSurelyAVehicle &&
                           (isCar(track) || isCarUnderATree(track) || isTruckOfKnownSize(track));
        target.isDrivingTruck = probability > kSurelyAVehicle && !target.isBounded &&
                                track.told.width && track.box().width < kWidestTruck &&
                                track.stoodProbability < kMayStand;
        target.isClutter = probability < 1.0 - kSurelyAVehicle;
        target.hits = track.lastHits;
        all.push_back(target);
    }
    return all;
}

}  // namespace vdamf
