// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/alignment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
namespace
{
std::optional<StandingPoint> pointOf(const Track& track, const Sighting& sighting,
                                     const VisibilityOptions& options)
{
    constexpr int kKnown = 3;  // sightings
    if (!track.stood() || track.sightings < kKnown) return std::nullopt;
    const VehicleState& standing = track.hypotheses->standing;
    const Measurement m = alignedWith(sighting.measurement, standing.mean(kHeading));
    const BoxMeasurement box = withJitterAlone(
        boxThrough(m, faceErrors(m, standing, options), standing.size(), sighting.sensor, options),
        track.jitter);
    return StandingPoint{measuredPoint(box).value.head<2>(), innovationOf(standing, box)};
}

Eigen::Vector2d nearestCorner(const OrientedBox& box, const Eigen::Vector2d& sensor)
{
    const auto all = corners(box);
    return *std::min_element(all.begin(), all.end(),
                             [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
                             { return (a - sensor).squaredNorm() < (b - sensor).squaredNorm(); });
}

// Where what stands was seen first, at a time, from where the tracks have it now.
std::vector<StandingPoint> pointsSince(double first, const std::vector<Track>& tracks)
{
    constexpr double kScan = 0.1;    // s: hits of a scan are seen up to so much later
    constexpr double kPlace = 0.06;  // m, of a box in a frame
    constexpr double kHeading = 3.0 * kDegree;
    std::vector<StandingPoint> points;
    for (const Track& track : tracks)
    {
        if (!track.stood() || track.path.empty() || track.path.front().time > first + kScan)
            continue;
        StandingPoint point;
        const OrientedBox then = track.path.front().box;
        point.at = nearestCorner(track.box(), track.seenFrom);
        point.innovation.value.head<2>() = nearestCorner(then, track.seenFrom) - point.at;
        point.innovation.value(2) = std::remainder(then.heading - track.box().heading, 0.5 * kPi);
        point.innovation.covariance =
            Eigen::Vector3d(kPlace * kPlace, kPlace * kPlace, kHeading * kHeading).asDiagonal();
        points.push_back(point);
    }
    return points;
}
}  // namespace

std::vector<StandingPoint> standingPoints(const std::vector<Track>& tracks,
                                          const std::vector<std::optional<Sighting>>& sightings,
                                          const VisibilityOptions& options)
{
    constexpr std::size_t kEnough = 24;
    std::vector<StandingPoint> points;
    for (std::size_t j = 0; j < tracks.size() && points.size() < kEnough; ++j)
    {
        if (!sightings[j]) continue;
        if (auto point = pointOf(tracks[j], *sightings[j], options))
            points.push_back(std::move(*point));
    }
    return points;
}

void Alignment::goOn(const Eigen::Vector2d& by, double time)
{
    if (!firstTime_) firstTime_ = time_ = time;
    dt_ = time - time_;
    time_ = time;
    const double kept = std::exp(-dt_ / options_.returnTime);
    motion_ = motion_.about(by);
    motion_.turn *= kept;
    motion_.shift *= kept;
    const Eigen::Matrix3d j = byMotion(by);
    covariance_ = kept * kept * (j * covariance_ * j.transpose());
}

std::optional<EstimatedMotion> Alignment::motionOf(
    const std::vector<Track>& tracks, const std::vector<std::optional<Sighting>>& sightings,
    const VisibilityOptions& options)
{
    constexpr double kInView = 2.0;  // s: then others tell
    if (!options_.enabled) return std::nullopt;
    const auto change = errors_.after(standingPoints(tracks, sightings, options), dt_);
    if (!change) return std::nullopt;
    if (!begun_)
    {
        // Until now tracks have taken the errors in: their world is where they were seen first.
        const std::vector<StandingPoint> first = pointsSince(*firstTime_, tracks);
        const EstimatedMotion since = commonMotion(first, errors_.variances());
        motion_ = since.motion;
        if (!first.empty()) covariance_ = since.covariance;
        begun_ = true;
    }
    // What stands keeps its place: errors grow as other things come to stand for it, and by what
    // nothing tells.
    const Eigen::Matrix3d untold =
        change->covariance * errors_.variances().cwiseInverse().asDiagonal() * change->covariance;
    covariance_ += untold + dt_ / kInView * change->covariance;
    motion_ = motion_ * change->motion.inverse();
    return change;
}

TrackReport Alignment::aligned(TrackReport report, const Eigen::Vector2d& origin) const
{
    if (!begun_) return report;
    const PlaneMotion toTracks = inWorld(origin);
    const Eigen::Matrix3d j = byMotion(report.box.centre() - origin);
    report.covariance.topLeftCorner<3, 3>() += j * covariance_ * j.transpose();
    report.box = toTracks.of(report.box);
    if (report.measuredBox) report.measuredBox = toTracks.of(*report.measuredBox);
    return report;
}

}  // namespace vdamf
