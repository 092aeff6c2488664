// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/faceless.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "types/box_extent.h"

namespace vdamf
{
namespace
{
constexpr double kMiddleSigma = 0.15;  // m, of the middle of the hits

// Where the middle of the hits goes.
struct Way
{
    double direction = 0.0;  // rad
    double distance = 0.0;   // m
    double duration = 0.0;   // s

    double speed() const { return distance / duration; }
};

// Of late, to where it is at a time; nothing where it goes nowhere, or not straight on.
std::optional<Way> wayTo(const Eigen::Vector2d& last, double time,
                         const std::vector<PathPoint>& path)
{
    constexpr double kOfLate = 0.75;     // s
    constexpr double kLeastTime = 0.25;  // s
    constexpr double kFar = 0.6;         // m
    constexpr double kUneven = 0.2;      // of the way
    const auto first = std::find_if(path.begin(), path.end(),
                                    [&](const PathPoint& p) { return p.time >= time - kOfLate; });
    if (path.end() - first < 3 || time - first->time < kLeastTime) return std::nullopt;
    const Eigen::Vector2d move = last - first->hits;
    const Way way{std::atan2(move.y(), move.x()), move.norm(), time - first->time};
    const auto isOff = [&](const PathPoint& point)
    {
        const double share = (point.time - first->time) / way.duration;
        return (point.hits - first->hits - share * move).norm() > kUneven * way.distance;
    };
    if (way.distance < kFar || std::any_of(first, path.end(), isOff)) return std::nullopt;
    return way;
}

// Length and width of a rectangle along and across a heading.
Eigen::Vector2d sizeAlong(const OrientedBox& box, double heading)
{
    return 2.0 * Eigen::Vector2d(halfAlong(box, heading), halfAlong(box, heading + 0.5 * kPi));
}

VehicleState stateOn(const Way& way, const OrientedBox& around, const MotionOptions& motion)
{
    constexpr double kCurvatureSigma = 0.1;  // 1/m
    constexpr double kAcrossSigma = 2.0;     // m/s^2: who is fast hardly turns
    const double curvatureSigma =
        std::min(kCurvatureSigma, kAcrossSigma / (way.speed() * way.speed()));
    const double waySigma = std::sqrt(2.0) * kMiddleSigma;
    const Eigen::Vector2d size = sizeAlong(around, way.direction);
    VehicleState state;
    state.mean << around.centre(), way.direction, way.speed(), 0.0, motion.axisFraction * size.x(),
        size.x();
    StateVector sigma;
    sigma << kMiddleSigma, kMiddleSigma, waySigma / way.distance, waySigma / way.duration,
        curvatureSigma, motion.axisFractionSigma * size.x(), kMiddleSigma;
    state.covariance.diagonal() = sigma.cwiseAbs2();
    state.width = size.y();
    state.widthVariance = kMiddleSigma * kMiddleSigma;
    return state;
}

HeadingBelief withWay(const HeadingBelief& front, const std::optional<Way>& way, double heading,
                      double dt)
{
    HeadingCues cues;
    cues.dt = dt;
    if (way) cues.course = {wrapAngle(way->direction - heading), way->speed()};
    return front.after(cues);
}

Track startedOn(const Way& way, Track track, const Sighting& sighting, const MotionOptions& motion)
{
    constexpr double kStands = 0.05;  // probability
    constexpr double kTelling = 0.2;  // s, of the way
    track.state = stateAt(stateOn(way, sighting.around, motion), -sighting.lag, motion);
    *track.hypotheses = hypothesesFrom(track.state, motion);
    track.hypotheses->standingProbability = kStands;
    track.front = withWay({}, way, way.direction, kTelling);
    track.jitter = {};
    track.told = {};
    track.errors = {};
    track.assumedLength.reset();
    track.isFaceless = true;
    return track;
}

double sizeOf(const Sighting& sighting)
{
    return std::hypot(sighting.around.length, sighting.around.width);
}

bool mayBeFaceless(const Track& track, const Sighting& sighting)
{
    constexpr int kSightings = 3;     // that it takes to rule a vehicle out
    constexpr double kHardly = 0.1;   // probability
    constexpr double kLargest = 2.6;  // m, of a rider's hits
    constexpr double kHighest = 2.1;  // m
    return track.sightings >= kSightings && track.judgement.probability < kHardly &&
           sizeOf(sighting) < kLargest && sighting.height < kHighest;
}

bool hasFacesAfterAll(const Track& track, const Sighting& sighting)
{
    constexpr double kMayBe = 0.3;  // probability
    constexpr double kLarge = 3.0;  // m
    return track.judgement.probability > kMayBe || sizeOf(sighting) > kLarge;
}
}  // namespace

Track withFacesChecked(Track track, const Sighting& sighting, const MotionOptions& motion)
{
    constexpr double kAcross = 0.8;  // rad, that nothing on wheels turns in a second
    if (track.isFaceless && hasFacesAfterAll(track, sighting)) track.isFaceless = false;
    if (!mayBeFaceless(track, sighting)) return track;
    const auto way = wayTo(sighting.around.centre(), sighting.time + sighting.lag, track.path);
    if (!way) return track;
    const double turned = std::abs(wrapAngle(way->direction - track.state.mean(kHeading)));
    if (track.isFaceless && turned < kAcross) return track;
    return startedOn(*way, std::move(track), sighting, motion);
}

OrientedBox bodyAround(const OrientedBox& hits, const Eigen::Vector2d& sensor)
{
    constexpr double kThinnest = 0.5;  // m
    const Eigen::Matrix2d axes = rotation(hits.heading);
    const Eigen::Vector2d away = axes.transpose() * (hits.centre() - sensor).normalized();
    const Eigen::Vector2d size(hits.length, hits.width);
    const Eigen::Vector2d missing = (kThinnest - size.array()).max(0.0);
    const Eigen::Vector2d centre = hits.centre() + axes * (0.5 * missing.cwiseProduct(away));
    return {centre.x(), centre.y(), hits.heading, size.x() + missing.x(), size.y() + missing.y()};
}

BoxMeasurement boxOfHits(const Sighting& sighting, const VehicleState& foretold)
{
    constexpr double kHeadingSigma = 1.0;  // rad: not told
    constexpr double kSizeSigma = 0.3;     // m
    const double heading = foretold.mean(kHeading);
    BoxMeasurement m;
    m.box << sighting.around.centre(), heading, sizeAlong(sighting.around, heading);
    Vector5d sigma;
    sigma << kMiddleSigma, kMiddleSigma, kHeadingSigma, kSizeSigma, kSizeSigma;
    m.covariance.diagonal() = sigma.cwiseAbs2();
    m.lag = sighting.lag;
    return m;
}

HeadingBelief frontByWay(const Track& track)
{
    const PathPoint& last = track.path.back();
    const double dt = track.path.size() < 2 ? 0.0 : last.time - track.path.rbegin()[1].time;
    return withWay(track.front, wayTo(last.hits, last.time, track.path), track.state.mean(kHeading),
                   dt);
}

}  // namespace vdamf
