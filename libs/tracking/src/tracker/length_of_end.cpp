// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/length_of_end.h"

#include <algorithm>
#include <cmath>

#include "tracker/discriminate.h"
#include "vdamf/tracking/estimation/assumed_size.h"
#include "vdamf/tracking/estimation/start_state.h"

namespace vdamf
{
namespace
{
constexpr double kTold = 0.3;  // m, of lengths: no part of one that passes for all of it

// Of what stands something else may go on behind what hides its end.
bool isSurelyDriving(const MotionHypotheses& hypotheses)
{
    constexpr double kStands = 0.02;  // probability
    constexpr double kSlow = 3.0;     // m/s
    constexpr double kSigmas = 5.0;
    const VehicleState& driving = hypotheses.driving.front();
    const double sigma = driving.speedSigma();
    return hypotheses.standingProbability < kStands &&
           std::abs(driving.mean(kSpeed)) > std::max(kSlow, kSigmas * sigma);
}

// Of a vehicle of which an end alone was ever seen.
std::optional<AssumedSize> lengthBehindEnd(const Track& track, const VisibilityOptions& options)
{
    constexpr int kAgree = 3;  // sightings
    if (!options.assumeVehicleSize || track.told.length) return std::nullopt;
    const double seems = track.hypotheses->standing.width;
    const std::optional<double> width =
        track.told.width ? std::optional(track.state.width) : std::nullopt;
    constexpr double kTallFace = 2.5;  // m: of trucks, buses and few vans
    constexpr AssumedSize kLengthOfTall{8.5, 2.5};
    const bool mayBeVehicle = track.judgement.probability > 0.5;
    if (!width && mayBeVehicle && track.tallest >= kTallFace) return kLengthOfTall;
    if (isCarsEnd(seems, track.highest)) return carLength(track.highest, width, options);
    // What is seen of it is as wide at the least; what stands may be a bush before a car.
    if (!width && !(mayBeVehicle && isSurelyDriving(*track.hypotheses))) return std::nullopt;
    return track.busRears >= kAgree ? kBusLength : lengthBehind(seems, track.highest, options);
}

// Of what reaches beyond the length foretold, and goes on there out of sight.
std::optional<AssumedSize> lengthGoingOn(const Track& track, const Sighting& sighting,
                                         const Measurement& m, const VehicleState& foretold,
                                         double sizeSigma)
{
    constexpr double kPart = 0.5;     // of it that is a row of hits: else something else lies ahead
    constexpr double kGuessed = 1.5;  // m: a truck's length, by its end
    constexpr double kMostSigmas = 3.0;  // beyond it
    const AssumedSize before{foretold.mean(kLength),
                             std::sqrt(foretold.covariance(kLength, kLength))};
    if (before.sigma < kTold) return std::nullopt;
    // An end that is known better than the other one was in view: it is where it is foretold.
    const int hidden = m.hiddenEnds.has(Face::Front) ? 1 : 0;
    if (foretold.faceSigma(0, hidden) < foretold.faceSigma(0, 1 - hidden)) return std::nullopt;
    const double least = before.metres + 2.0 * sizeSigma;
    const bool isGuessed = !track.told.length && before.sigma > kGuessed;
    const bool isTakenIn =
        track.hypotheses->driving.front().mean(kLength) > before.metres + sizeSigma;
    if (isGuessed && isTakenIn && m.box.length > least &&
        m.box.length < before.metres + kMostSigmas * before.sigma)
        return longerThan(m.box.length, before);
    const double seen = sighting.around.length;
    if (seen < least || sighting.side.metres < kPart * seen) return std::nullopt;
    return lengthOfMoreThan(seen, std::max(track.height, sighting.height));
}
}  // namespace

Track grownToAVehicle(Track track, const Measurement& m, double height,
                      const VisibilityOptions& options)
{
    track.hypotheses->forEach([&](VehicleState& state)
                              { state = grownToAVehicle(state, m, height, track.told, options); });
    if (track.judgement.probability > kSurelyAVehicle)
        track.hypotheses->forEach(
            [&](VehicleState& state)
            { state = grownAsJudged(state, m, height, track.told, options); });
    return track;
}

Track goingOnOutOfSight(Track track, const Sighting& sighting, const Measurement& m,
                        const VehicleState& foretold, const VisibilityOptions& options)
{
    if (!options.assumeVehicleSize || !isSurelyDriving(*track.hypotheses)) return track;
    const auto whole = lengthGoingOn(track, sighting, m, foretold, options.sizeSigma);
    if (!whole) return track;
    const double before = track.hypotheses->driving.front().mean(kLength);
    track.hypotheses->forEach([&](VehicleState& state)
                              { state = goingOnOutOfSight(state, m, *whole); });
    // That length is assumed no more.
    if (track.hypotheses->driving.front().mean(kLength) > before) track.assumedLength.reset();
    return track;
}

Track withEndFollowed(Track track, const Sighting& sighting, const Measurement& m,
                      const VisibilityOptions& options)
{
    const bool isRear = m.facesSeen.has(Face::Back) && track.front.forwardProbability() > 0.9;
    track.busRears += sighting.isBusEnd && isRear ? 1 : 0;
    const auto now = lengthBehindEnd(track, options);
    if (!now) track.assumedLength.reset();
    if (!now || !m.facesSeen.seesEnd()) return track;
    const double seen = m.facesSeen.has(Face::Front) ? 1.0 : -1.0;
    track.hypotheses->forEach(
        [&](VehicleState& state)
        {
            const AssumedSize its{state.mean(kLength),
                                  std::sqrt(state.covariance(kLength, kLength))};
            // Where nothing was assumed, what is clearly shorter has a part of it.
            const bool isPart = now->metres - its.metres > now->sigma;
            if (track.assumedLength || isPart)
                state = withLengthAssumed(state, track.assumedLength.value_or(its), *now, seen);
        });
    track.assumedLength = now;
    return track;
}

}  // namespace vdamf
