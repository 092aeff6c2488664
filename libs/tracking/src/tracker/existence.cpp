// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/existence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracker/discriminate.h"
#include "vdamf/tracking/estimation/assumed_size.h"

namespace vdamf
{
namespace
{
constexpr double kFalseHits = 0.35;  // probability that something else has hits there
constexpr double kSurest = 0.99;     // no row of hits is more: vehicles do leave
constexpr double kSlack = 0.5;       // m before and behind a box that count as in it
constexpr double kVaguest = 4.5;     // m, of its position: a lane and a half

double oddsOf(double probability)
{
    return probability / (1.0 - probability);
}

double probabilityOf(double odds)
{
    return odds / (1.0 + odds);
}

// Farthest range at which a ray of unit length is in the box, or nothing where it passes by.
double farthestIn(const OrientedBox& box, const Eigen::Vector2d& sensor, const Eigen::Vector2d& ray)
{
    const Eigen::Vector2d from = toBoxFrame(box, sensor);
    const Eigen::Vector2d along = rotation(box.heading).transpose() * ray;
    const Eigen::Vector2d half(0.5 * box.length, 0.5 * box.width);
    double last = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis)
    {
        if (std::abs(along(axis)) < 1e-9) continue;
        const double leaves = std::copysign(half(axis), along(axis));
        last = std::min(last, (leaves - from(axis)) / along(axis));
    }
    return last;
}

// What fewer hits tell may be of one parked car after the other.
bool isHardlySeen(const Track& track)
{
    return track.hits < 25;
}

// Whether it may be a vehicle, and is no longer than a piece of one, as far as was told.
bool isPiece(const Track& track)
{
    constexpr double kMayBe = 0.1;  // probability
    constexpr double kTold = 0.1;   // m
    const bool isTold = track.told.length && track.lengthSigma() < kTold;
    return !track.isFaceless && track.judgement.probability > kMayBe && !isTold &&
           track.box().length < kShortestCar;
}

// In full view. A vehicle of few hits may have none for some frames: rays pass over it, through its
// windows, and so low that they seem to be on the ground.
double hitProbability(const Track& track, const LifecycleOptions& options)
{
    constexpr double kFew = 5.0;     // hits, with which it is half as likely to have some
    constexpr double kSurely = 0.9;  // probability of a vehicle
    if (track.judgement.probability < kSurely) return options.hitProbability;
    return options.hitProbability * track.lastHits / (track.lastHits + kFew);
}

// Whether it likely stands, or its speed is known well. A second sighting that shows more of what
// stands looks like one of what drives, but not as sure.
bool isSpeedSure(const Track& track)
{
    constexpr double kSure = 0.8;  // m/s
    return track.stands() || track.state.speedSigma() < kSure;
}

bool isVehicleOfKnownSpeed(const Track& track)
{
    return track.judgement.probability > kSurelyAVehicle && isSpeedSure(track);
}

// Probability that it drives forward, by the way it moves or by all that is known, whichever says
// less.
double forwardProbability(const Track& track)
{
    return std::min(track.front.forwardProbability(), track.front.forwardProbabilityByCourse());
}

// Whether what surely moves may as well drive backward: its shape and its way tell different
// fronts.
bool isFrontDisputed(const Track& track, const LifecycleOptions& options)
{
    return track.moves() && forwardProbability(track) < options.confirmAxes;
}

// Whether the speed is not known yet, nor which way what may be moving drives.
bool isSpeedVague(const Track& track, const LifecycleOptions& options)
{
    // Of few hits, what drives seems to stand at first: as fast as it may be if it does not.
    const bool isFew = isHardlySeen(track);
    const VehicleState& told = isFew ? track.hypotheses->driving.front() : track.state;
    const double speed = std::abs(told.mean(kSpeed));
    const double error = 2.0 * told.speedSigma();
    const bool mayBeEither =
        isFew && (speed - error < Track::kStill || !isVehicleOfKnownSpeed(track));
    return track.state.speedSigma() > options.confirmSpeedSigma ||
           (speed + error > Track::kStill &&
            (mayBeEither || forwardProbability(track) < options.confirmAxes));
}

// Sightings more that it takes to confirm a track. What may still be across is not where its box
// is, and even less so is the vehicle of which only a piece was seen; but neither may ever tell.
int patienceWith(const Track& track, const LifecycleOptions& options)
{
    constexpr int kForSpeed = 4;
    constexpr int kForAxes = 10;  // or the front
    constexpr int kForMoreHits = 30;
    constexpr double kAsLikely = 0.5;  // probability
    const double axes = track.front.axesProbability();
    const bool mayBeAcross = axes < options.confirmAxes;
    if (isPiece(track) || axes < kAsLikely || (mayBeAcross && isHardlySeen(track)))
        return kForMoreHits;
    if (mayBeAcross || isFrontDisputed(track, options)) return kForAxes;
    return isSpeedVague(track, options) ? kForSpeed : 0;
}
}  // namespace

double shareSeenThrough(const OrientedBox& box, const OpenView& view)
{
    constexpr int kRays = 9;
    const Eigen::Vector2d away = box.centre() - view.sensor;
    const double middle = std::atan2(away.y(), away.x());
    double right = 0.0;
    double left = 0.0;
    for (const Eigen::Vector2d& corner : corners(box))
    {
        const Eigen::Vector2d p = corner - view.sensor;
        const double turn = wrapAngle(std::atan2(p.y(), p.x()) - middle);
        right = std::min(right, turn);
        left = std::max(left, turn);
    }
    int through = 0;
    for (int k = 0; k < kRays; ++k)
    {
        const double bearing = middle + right + (left - right) * (k + 0.5) / kRays;
        const Eigen::Vector2d ray = rotation(bearing).col(0);
        const double behind = farthestIn(box, view.sensor, ray) + kSlack;
        if (view.field.has(bearing) && view.profile.at(bearing) > behind) ++through;
    }
    return static_cast<double>(through) / kRays;
}

// Of a frame, `dt` seconds after the one before: those that follow each other fast see the same.
double newsOf(double dt)
{
    constexpr double kNews = 0.1;  // s
    return std::min(1.0, dt / kNews);
}

// One sigma along the longer axis of the ellipse.
Eigen::Vector2d longestSigma(const Eigen::Matrix2d& covariance)
{
    const double mean = 0.5 * covariance.trace();
    const double halfDifference = 0.5 * (covariance(0, 0) - covariance(1, 1));
    const double longer = mean + std::hypot(halfDifference, covariance(0, 1));
    const double direction = 0.5 * std::atan2(covariance(0, 1), halfDifference);
    return std::sqrt(std::max(0.0, longer)) * rotation(direction).col(0);
}

double shareSeenThrough(const Track& track, const OpenView& view)
{
    constexpr double kSigmas[3] = {-2.0, 0.0, 2.0};
    const Eigen::Vector2d sigma = longestSigma(track.state.covariance.topLeftCorner<2, 2>());
    double least = 1.0;
    for (const double sigmas : kSigmas)
    {
        OrientedBox box = track.box();
        box.x += sigmas * sigma.x();
        box.y += sigmas * sigma.y();
        least = std::min(least, shareSeenThrough(box, view));
    }
    return least;
}

Track withHit(Track track, double time, const LifecycleOptions& options)
{
    const double hit = std::max(1.0, options.hitProbability / kFalseHits);
    const double odds = oddsOf(track.existence) * std::pow(hit, newsOf(track.interval));
    track.existence = std::min(kSurest, probabilityOf(odds));
    ++track.sightings;
    track.misses = 0;
    track.lastSeen = time;
    return track;
}

Track withConfirmation(Track track, const LifecycleOptions& options)
{
    constexpr int kForCalm = 15;
    const int patience = patienceWith(track, options);
    // Nothing is left that one more sighting would tell.
    const int hits = options.confirmHits - (patience == 0 && isVehicleOfKnownSpeed(track) ? 1 : 0);
    const int enough = hits + patience;
    const int seen = track.sightingsOfState();
    // One that hops on to something else comes to rest there.
    const bool isCalm = track.sightings - track.surprisedAt >= hits || seen >= enough + kForCalm;
    if (track.status == TrackStatus::Coasting || (seen >= enough && isCalm))
        track.status = TrackStatus::Confirmed;
    return track;
}

Track withMiss(Track track, const OpenView& view, const Unseen& unseen,
               const LifecycleOptions& options)
{
    ++track.misses;
    // What was hardly seen yet is not worth waiting for, and pieces of bushes are new ones anyway.
    const bool wasHardlySeen = track.status == TrackStatus::Tentative && !track.wasPublished;
    const bool isWaitedFor = unseen.mayBeVehicle && !wasHardlySeen;
    double inView = 1.0;
    if (isWaitedFor) inView = unseen.showsHits ? 0.0 : shareSeenThrough(track, view);
    const double missed = 1.0 - hitProbability(track, options) * inView;
    track.existence =
        probabilityOf(oddsOf(track.existence) * std::pow(missed, newsOf(track.interval)));
    const double variance = 0.5 * track.state.covariance.topLeftCorner<2, 2>().trace();
    const bool isLost = track.existence < options.endProbability ||
                        view.time - track.lastSeen > options.maxCoast ||
                        variance > kVaguest * kVaguest;
    if (track.status == TrackStatus::Confirmed) track.status = TrackStatus::Coasting;
    if (isLost) track.status = TrackStatus::Ended;
    return track;
}

std::vector<Track> withoutEnded(std::vector<Track> tracks)
{
    const auto isEnded = [](const Track& t) { return t.status == TrackStatus::Ended; };
    tracks.erase(std::remove_if(tracks.begin(), tracks.end(), isEnded), tracks.end());
    return tracks;
}

}  // namespace vdamf
