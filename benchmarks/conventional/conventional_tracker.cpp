// SPDX-License-Identifier: BSD-3-Clause
#include "conventional/conventional_tracker.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "conventional/car_size.h"
#include "measurement/baselines.h"
#include "vdamf/evaluation/box_overlap.h"
#include "vdamf/evaluation/matching.h"

namespace vdamf
{
namespace
{
constexpr int kConfirm = 3;                       // measurements
constexpr double kLifetime = 1.0;                 // s without one
constexpr double kLongest = 20.0, kWidest = 5.0;  // m

PlanePoints planePoints(const Cluster& cluster)
{
    PlanePoints points(2, static_cast<Eigen::Index>(cluster.size()));
    for (std::size_t i = 0; i < cluster.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) << cluster.x[i], cluster.y[i];
    return points;
}

// Greater is better; 0: outside of a gate.
double score(const OrientedBox& tracked, const Eigen::Matrix2d& covariance,
             const OrientedBox& detected)
{
    constexpr double kFarthest = 5.0;               // m
    constexpr double kMostTurn = 60.0 / 180 * kPi;  // rad
    constexpr double kGate = 3.035;                 // 99 %
    constexpr double kLeastOverlap = 0.1;
    const Eigen::Vector2d apart = detected.centre() - tracked.centre();
    if (apart.norm() >= kFarthest) return 0.0;
    if (std::abs(std::remainder(detected.heading - tracked.heading, kPi)) > kMostTurn) return 0.0;
    if (apart.dot(covariance.inverse() * apart) >= kGate * kGate) return 0.0;
    if (birdsEyeIou(tracked, detected) < kLeastOverlap) return 0.0;
    return (kFarthest - apart.norm()) / kFarthest;
}

// Which way, from the centre, the corner or the face nearest to the sensor lies: -1, 0 or 1 along
// the heading and across it.
Eigen::Vector2d anchorOf(const OrientedBox& box, const Eigen::Vector2d& sensor)
{
    const Eigen::Vector2d there = toBoxFrame(box, sensor);
    const Eigen::Vector2d half(0.5 * box.length, 0.5 * box.width);
    Eigen::Vector2d anchor = Eigen::Vector2d::Zero();
    for (const int axis : {0, 1})
        if (std::abs(there(axis)) > half(axis)) anchor(axis) = std::copysign(1.0, there(axis));
    return anchor;
}

double withinSizes(double size, double most)
{
    constexpr double kLeast = 1.0;  // m
    return std::clamp(size, kLeast, most);
}
}  // namespace

OrientedBox ConventionalTracker::Track::box() const
{
    const BicycleFilter::State& s = filter.state();
    return {s(0), s(1), s(2), length, width};
}

std::vector<ConventionalTracker::Detection> ConventionalTracker::detectionsIn(
    const LadarFrame& frame, FrameResult& result) const
{
    const AboveGround above = removeGround(frame, options_.ground);
    const std::vector<Cluster> clusters = clusterPoints(frame, above, options_.clustering);
    result.points = frame.points.size();
    result.pointsAboveGround = above.index.size();
    result.clusters = clusters.size();
    const Eigen::Vector2d sensor = (frame.sensor - frame.origin).head<2>();
    std::vector<Detection> all;
    for (const Cluster& cluster : clusters)
    {
        Detection d;
        const OrientedBox fitted = lShapeByCloseness(planePoints(cluster));
        d.box = completedToACar(fitted, sensor);
        d.box.x += frame.origin.x();
        d.box.y += frame.origin.y();
        d.points = static_cast<int>(cluster.size());
        d.height = *std::max_element(cluster.height.begin(), cluster.height.end());
        d.groundZ = frame.origin.z() + static_cast<double>(cluster.z[0] - cluster.height[0]);
        d.mayStart = d.points >= options_.lifecycle.minHits &&
                     d.height >= options_.lifecycle.minHeight &&
                     std::hypot(fitted.length, fitted.width) <= options_.lifecycle.maxExtent;
        all.push_back(d);
    }
    return all;
}

std::vector<int> ConventionalTracker::assigned(const std::vector<Detection>& detections) const
{
    std::vector<std::vector<double>> scores(tracks_.size(),
                                            std::vector<double>(detections.size(), 0.0));
    for (std::size_t j = 0; j < tracks_.size(); ++j)
        for (std::size_t i = 0; i < detections.size(); ++i)
            scores[j][i] =
                score(tracks_[j].box(), tracks_[j].filter.covariance().topLeftCorner<2, 2>(),
                      detections[i].box);
    return bestAssignment(scores);
}

void ConventionalTracker::endOldAndDouble(double time)
{
    constexpr double kNear = 5.0;  // m
    constexpr double kMostOverlap = 0.1;
    for (Track& track : tracks_) track.ended = time - track.lastSeen >= kLifetime;
    for (std::size_t older = 0; older < tracks_.size(); ++older)
    {
        for (std::size_t younger = older + 1; younger < tracks_.size(); ++younger)
        {
            if (tracks_[older].ended || tracks_[younger].ended) continue;
            const OrientedBox a = tracks_[older].box();
            const OrientedBox b = tracks_[younger].box();
            if ((a.centre() - b.centre()).norm() < kNear && birdsEyeIou(a, b) > kMostOverlap)
                tracks_[younger].ended = true;
        }
    }
}

TrackReport ConventionalTracker::reportOf(const Track& track) const
{
    constexpr double kSizeSigma = 0.5;  // m: sizes have no covariance there
    const bool isSeen = track.lastSeen == time_;
    TrackReport report;
    report.id = track.id;
    report.status = isSeen ? TrackStatus::Confirmed : TrackStatus::Coasting;
    if (track.sightings < kConfirm) report.status = TrackStatus::Tentative;
    if (track.ended) report.status = TrackStatus::Ended;
    report.box = track.box();
    report.z = track.last.groundZ;
    report.height = track.last.height;
    report.speed = track.filter.state()(3);
    report.yawRate = track.filter.yawRate();
    report.covariance = track.filter.covariance().topLeftCorner<4, 4>();
    report.lengthVariance = report.widthVariance = kSizeSigma * kSizeSigma;
    if (!isSeen) return report;
    report.points = track.last.points;
    report.measuredBox = track.last.box;
    return report;
}

void ConventionalTracker::update(Track& track, const Detection& seen, const LadarFrame& frame)
{
    constexpr double kBelief = 0.5;  // in each new size
    const Eigen::Vector2d anchor = anchorOf(track.box(), frame.sensor.head<2>());
    const Eigen::Vector2d grown(seen.box.length - track.length, seen.box.width - track.width);
    const Eigen::Vector2d offset =
        rotation(track.filter.state()(2)) * (0.5 * anchor.cwiseProduct(grown));
    track.filter.update(seen.box.centre() + offset, seen.box.heading);
    track.filter.move(-kBelief * offset);
    track.length = withinSizes(track.length + kBelief * grown.x(), kLongest);
    track.width = withinSizes(track.width + kBelief * grown.y(), kWidest);
    track.filter.setLength(track.length);
    track.last = seen;
    track.lastSeen = frame.time;
    ++track.sightings;
}

FrameResult ConventionalTracker::process(const LadarFrame& frame)
{
    FrameResult result;
    result.time = frame.time;
    for (Track& track : tracks_) track.filter.predict(frame.time - time_);
    time_ = frame.time;
    const std::vector<Detection> detections = detectionsIn(frame, result);
    const std::vector<int> assignment = assigned(detections);
    std::vector<bool> isTaken(detections.size(), false);
    for (std::size_t j = 0; j < tracks_.size(); ++j)
    {
        if (assignment[j] < 0) continue;
        const auto i = static_cast<std::size_t>(assignment[j]);
        isTaken[i] = true;
        update(tracks_[j], detections[i], frame);
    }
    for (std::size_t i = 0; i < detections.size(); ++i)
    {
        if (isTaken[i] || !detections[i].mayStart) continue;
        const OrientedBox& box = detections[i].box;
        tracks_.push_back({nextId_++, BicycleFilter(box), withinSizes(box.length, kLongest),
                           withinSizes(box.width, kWidest), detections[i], 1, frame.time, false});
    }
    endOldAndDouble(frame.time);
    for (const Track& track : tracks_) result.tracks.push_back(reportOf(track));
    tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(),
                                 [](const Track& track) { return track.ended; }),
                  tracks_.end());
    return result;
}

}  // namespace vdamf
