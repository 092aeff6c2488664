// SPDX-License-Identifier: BSD-3-Clause
// How tracks take sightings in: the first one, and those that follow.
#include "tracker/track.h"

#include <algorithm>
#include <cmath>

#include "tracker/attention.h"
#include "tracker/end_above_bumper.h"
#include "tracker/ends_in_view.h"
#include "tracker/existence.h"
#include "tracker/faceless.h"
#include "tracker/last_glimpse.h"
#include "tracker/length_of_end.h"
#include "tracker/unlikely_turn.h"

namespace vdamf
{
namespace
{
void appendToPath(Track& track, const PathPoint& point)
{
    constexpr double kPathTime = 3.0;  // s
    track.path.push_back(point);
    const auto first =
        std::find_if(track.path.begin(), track.path.end(),
                     [&](const PathPoint& p) { return p.time >= point.time - kPathTime; });
    track.path.erase(track.path.begin(), first);
}

// The measurement as it would have been `lag` seconds before, at the time of the state.
Measurement broughtTo(const VehicleState& state, const Measurement& measurement, double lag,
                      const MotionOptions& options)
{
    if (lag == 0.0) return measurement;
    const StateVector move =
        modelOf(state.steering, options)->predicted(state.mean, lag) - state.mean;
    Measurement m = measurement;
    m.box.x -= move(kX);
    m.box.y -= move(kY);
    m.box.heading = wrapAngle(m.box.heading - move(kHeading));
    return m;
}

// With the heading that it showed since it came to stand.
Track withShownHeading(Track track, const Measurement& m, const Eigen::Vector2d& sensor)
{
    if (!track.stands())
        track.shownHeading.reset();
    else
        track.shownHeading =
            track.shownHeading.value_or(ShownHeading()).after(m, viewOf(track.state.box(), sensor));
    return track;
}

// The ends of what stands that are where they were seen.
FaceSet endsKnown(const Track& track, const VehicleState& foretold)
{
    constexpr double kKnown = 0.3;  // m
    FaceSet known;
    if (!track.stands()) return known;
    for (int end = 0; end < 2; ++end)
        if (foretold.faceSigma(0, end) < kKnown) known.add(kFaceAt[0][end]);
    return known;
}

// The whole box by a sighting, at the time of its hits; `then`: what was foretold for that time.
BoxMeasurement boxOf(const Sighting& sighting, const Measurement& m, const Track& track,
                     const VehicleState& then, const VisibilityOptions& options)
{
    FaceErrors errors = faceErrors(m, then, options);
    if (track.told.length && (track.stands() || isInside(m, then)))
        errors = withShortRows(errors, m, then);
    BoxMeasurement box = boxThrough(m, errors, then.size(), sighting.sensor, options);
    box.lag = sighting.lag;
    return box;
}

// Probability that frames show the same hits as those before: that it stands, and that the sensor
// has not turned around it by more than 0.05 rad, which at 20 m moves the hits on half of a car's
// length by as much as lies between them.
double repeatedHits(const Track& track)
{
    constexpr double kOtherHits = 0.1;  // of changeOfView()
    return track.hypotheses->standingProbability * std::exp(-track.viewChanged / kOtherHits);
}

// With hypotheses that are less certain of their sizes where the measurement shows more.
Track openToGrowth(Track track, const Measurement& m, double lag, const TrackerOptions& options)
{
    // What was only assumed of what stands is no reason to take in what it stands beside.
    const bool mayBeLonger = track.told.length || !track.stands();
    track.hypotheses->forEach(
        [&](VehicleState& state)
        {
            state = openToGrowth(state, broughtTo(state, m, lag, options.motion), mayBeLonger,
                                 options.visibility);
        });
    return track;
}

// From the sighting that started the track to a box measured at a time. Nothing where the speed
// was known before: then an update takes the turn in itself. `then`: what was foretold.
std::optional<TurnShown> turnSinceStart(const Track& track, const BoxMeasurement& box,
                                        const VehicleState& then, double time)
{
    constexpr double kMost = 0.3;      // rad: other faces, or others' hits
    constexpr double kUnknown = 0.01;  // m/s
    if (std::abs(then.mean(kSpeed)) > kUnknown) return std::nullopt;
    const PathPoint& start = track.path.back();
    const double angle = std::remainder(box.box(2) - start.box.heading, kPi);
    if (std::abs(angle) > kMost) return std::nullopt;
    return TurnShown{angle, start.headingVariance + box.covariance(2, 2), time - start.time};
}

// The hypotheses, and how they err, after a box measured `dt` seconds after the one before.
Track updatedBy(const BoxMeasurement& box, Track track, const VehicleState& then, double dt,
                VehicleKalmanFilter& filter, const TrackerOptions& options)
{
    MotionHypotheses& hypotheses = *track.hypotheses;
    const JitterShares jitter = track.jitter;  // before this sighting
    track.nis = innovationOf(then, withJitterAlone(box, jitter)).nis();
    track.jitter = jitter.after(then, box, dt);
    hypotheses = updated(hypotheses, box, jitter, filter, options.lifecycle.nisGate);
    if (*track.nis > options.lifecycle.nisGate) track.surprisedAt = track.sightings + 1;
    if (track.sightings == track.startedAt)
    {
        const auto turn = turnSinceStart(track, box, then, track.lastSeen + dt + box.lag);
        hypotheses.forEach(
            [&](VehicleState& state)
            {
                state = withUsualCurvature(state);
                if (turn) state = withTurnShown(state, *turn);
            });
    }
    track.lastingError = lastingError(box, jitter);
    track.errors = toldErrors(box, track.jitter, repeatedHits(track), track.errors);
    return track;
}

VehicleState foretoldAt(double lag, const Track& track, const MotionOptions& options)
{
    return stateAt(track.hypotheses->combined(options), lag, options);
}

// What follows from the hypotheses, and the history, after a sighting by which they were updated.
Track takenIn(Track track, const Sighting& sighting, const BoxMeasurement& box,
              const TrackerOptions& options)
{
    constexpr double kHeightMemory = 1.95;  // s
    const Measurement& m = *track.measurement;
    const Vector5d& b = box.box;
    track.state = track.hypotheses->combined(options.motion);
    track.around =
        inFrameOf(stateAt(track.state, sighting.lag, options.motion).box(), sighting.around);
    track.lastMatch = m.match;
    track.groundZ = sighting.groundZ;
    const double kept = std::exp((track.lastSeen - sighting.time) / kHeightMemory);
    track.height = std::max(sighting.height, kept * track.height + (1.0 - kept) * sighting.height);
    track = withHit(std::move(track), sighting.time, options.lifecycle);
    appendToPath(track, {sighting.time + sighting.lag,
                         {b(0), b(1), b(2), b(3), b(4)},
                         locatedFaces(m),
                         sighting.around.centre(),
                         box.covariance(2, 2)});
    return track;
}

Track sightedByHits(Track track, const Sighting& sighting, VehicleKalmanFilter& filter,
                    const TrackerOptions& options)
{
    // The same side of it is seen for long.
    constexpr double kLastingMiddle = 0.1;  // m
    const VehicleState then = foretoldAt(sighting.lag, track, options.motion);
    const BoxMeasurement box = boxOfHits(sighting, then);
    track = updatedBy(box, std::move(track), then, sighting.time - track.lastSeen, filter, options);
    track.errors.lasting.topLeftCorner<2, 2>().diagonal().array() +=
        kLastingMiddle * kLastingMiddle;
    track = takenIn(std::move(track), sighting, box, options);
    track.front = frontByWay(track);
    return track;
}
}  // namespace

Track startedTrack(std::uint64_t id, const Sighting& sighting, const StartSpeed& speed,
                   const TrackerOptions& options)
{
    constexpr double kNotKnown = 0.5;
    const Measurement m = withoutUpperFront(sighting.measurement, sighting.height, kNotKnown);
    Track track;
    track.id = id;
    const VehicleState seen =
        startState(m, sighting.height, sighting.sensor, speed, options.visibility, options.motion);
    track.state = stateAt(seen, -sighting.lag, options.motion);
    *track.hypotheses = hypothesesFrom(track.state, options.motion);
    track.groundZ = sighting.groundZ;
    track.height = sighting.height;
    track.highest = sighting.height + sighting.overHits;
    track.faceHeight = sighting.faceHeight;
    track.sightings = 1;
    track.firstSeen = track.lastSeen = sighting.time;
    track.seenFrom = sighting.sensor;
    track.told = SizesTold().with(m);
    if (!track.told.length)
        track.assumedLength = assumedSizes(m, track.height, options.visibility).length;
    track.around = inFrameOf(seen.box(), sighting.around);
    HeadingCues cues = sizeCues(sighting, m, track.height);
    cues.shape = track.judgement.probability * sighting.front;
    track.front = HeadingBelief(cues);
    track.measurement = m;
    track.hits = m.hits;
    track.areParts = sighting.areParts;
    track.lastMatch = m.match;
    if (options.lifecycle.confirmHits <= 1) track.status = TrackStatus::Confirmed;
    appendToPath(track, {sighting.time + sighting.lag, seen.box(), locatedFaces(m),
                         sighting.around.centre(), m.covariance(2, 2)});
    return track;
}

Track sightedTrack(Track track, const Sighting& seen, const Neighbourhood& around,
                   VehicleKalmanFilter& filter, const TrackerOptions& options)
{
    const VisibilityOptions& visibility = options.visibility;
    const VehicleState foretold = stateAt(track.state, seen.lag, options.motion);
    constexpr double kHardly = 0.1;  // probability: what is no vehicle has no axes to be known
    std::optional<Sighting> turned;
    if (track.judgement.probability > kHardly)
        turned = turnedToKnownAxes(seen, foretold, track.front.axesProbability());
    const Sighting& sighting = turned ? *turned : seen;
    if (isLastGlimpse(track, sighting, foretold, options.association.surfaceSigma))
    {
        track.hits = sighting.measurement.hits;
        return withHit(std::move(track), sighting.time, options.lifecycle);
    }
    Measurement m = alignedWith(sighting.measurement, foretold.mean(kHeading));
    track = withShownHeading(std::move(track), m, sighting.sensor);
    if (track.shownHeading)
        m = turnedBack(turnedTowards(*track.shownHeading, m, sighting.around.centre()), track.state,
                       sighting.around.centre());
    else
        m = withoutShortUpperEnds(m, foretold.box());
    m = withoutUpperFront(m, std::max(track.height, sighting.height),
                          track.front.forwardProbability(), endsKnown(track, foretold));
    m = withoutShadowEdges(m, foretold, sighting.around.centre());
    m = withEndAsForetold(m, sighting, foretold);
    track.measurement = m;
    track.hits = m.hits;
    track.areParts = sighting.areParts;
    track = withFacesChecked(std::move(track), sighting, options.motion);
    if (track.isFaceless) return sightedByHits(std::move(track), sighting, filter, options);
    track =
        grownToAVehicle(std::move(track), m, std::max(track.height, sighting.height), visibility);
    const VehicleState then = foretoldAt(sighting.lag, track, options.motion);
    const BoxMeasurement box = boxOf(sighting, withUnlikelyTurn(m, then, sighting.around.centre()),
                                     track, then, visibility);
    track = openToGrowth(std::move(track), m, sighting.lag, options);
    track = updatedBy(box, std::move(track), then, sighting.time - track.lastSeen, filter, options);
    track = goingOnOutOfSight(std::move(track), sighting, m, then, visibility);
    track.told = track.told.with(m);
    track.highest =
        std::max(track.highest, std::min(track.height, sighting.height) + sighting.overHits);
    track.tallest = std::max(track.tallest, std::min(track.faceHeight, sighting.faceHeight));
    track.faceHeight = sighting.faceHeight;
    track = withEndFollowed(std::move(track), sighting, m, visibility);
    track = takenIn(std::move(track), sighting, box, options);
    if (isPlaceEnough(track)) return track;
    return withCheckedHeading(std::move(track), sighting, around, options);
}

}  // namespace vdamf
