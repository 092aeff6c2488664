// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/pose_errors.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace vdamf
{
namespace
{
constexpr double kMaxDifferenceTime = 0.5;  // s, to a neighbouring frame

double wrapHalfTurn(double angle)
{
    const double wrapped = std::remainder(angle, kPi);
    return wrapped <= -0.5 * kPi ? 0.5 * kPi : wrapped;
}

const TruthRow* find(const ScoredFrame& frame, const std::string& objectId)
{
    for (const TruthRow& row : frame.truth)
    {
        if (row.objectId == objectId) return &row;
    }
    return nullptr;
}

std::optional<double> trueYawRate(const Sequence& sequence, std::size_t frame,
                                  const std::string& objectId)
{
    if (frame == 0 || frame + 1 >= sequence.frames.size()) return std::nullopt;
    const double now = sequence.frames[frame].time;
    const TruthRow* before = find(sequence.frames[frame - 1], objectId);
    const TruthRow* after = find(sequence.frames[frame + 1], objectId);
    if (before == nullptr || after == nullptr || now - before->time > kMaxDifferenceTime ||
        after->time - now > kMaxDifferenceTime)
    {
        return std::nullopt;
    }
    return wrapAngle(after->box.heading - before->box.heading) / (after->time - before->time);
}

double cornerError(const OrientedBox& truth, const OrientedBox& track, const PlanePose& sensor)
{
    const Eigen::Vector2d from(sensor.x, sensor.y);
    Eigen::Vector2d nearest = truth.centre();
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& corner : corners(truth))
    {
        const double distance = (corner - from).norm();
        if (distance < least) nearest = corner;
        least = std::min(least, distance);
    }
    double error = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& corner : corners(track))
    {
        error = std::min(error, (corner - nearest).norm());
    }
    return error;
}

/// Squared error over variance; -1 where that is no variance.
double normalised(double error, double variance)
{
    return variance > 0.0 ? error * error / variance : -1.0;
}

double poseNees(const Eigen::Vector3d& error, const Eigen::Matrix3d& covariance)
{
    const Eigen::LLT<Eigen::Matrix3d> root(covariance);
    if (root.info() != Eigen::Success) return -1.0;
    return error.dot(root.solve(error));
}

double sizeNees(const PoseError& e, const TrackReport& track)
{
    const double length = normalised(e.length, track.lengthVariance);
    const double width = normalised(e.width, track.widthVariance);
    return length >= 0.0 && width >= 0.0 ? length + width : -1.0;
}

PoseError errorOf(const TruthRow& truth, const TrackReport& track)
{
    const Eigen::Vector2d offset = track.box.centre() - truth.box.centre();
    const Eigen::Vector2d along = rotation(-truth.box.heading) * offset;
    PoseError e;
    e.time = truth.time;
    e.objectId = truth.objectId;
    e.trackId = track.id;
    e.status = track.status;
    e.position = offset.norm();
    e.longitudinal = along.x();
    e.lateral = along.y();
    e.heading = wrapAngle(track.box.heading - truth.box.heading);
    e.headingAxis = wrapHalfTurn(e.heading);
    e.flipped = std::abs(e.heading) > 0.5 * kPi;
    e.exchanged = std::abs(e.headingAxis) > 0.25 * kPi;
    e.axesProbability = track.axesProbability;
    e.trueSpeed = truth.speed;
    e.trackSpeed = track.speed;
    e.speed = (e.flipped ? -track.speed : track.speed) - truth.speed;
    e.length = track.box.length - truth.box.length;
    e.width = track.box.width - truth.box.width;
    if (track.lengthVariance >= 0.0) e.lengthSigma = std::sqrt(track.lengthVariance);
    e.points = truth.points;
    e.facesSeen = track.facesSeen;
    e.nis = track.nis;
    e.neesPose =
        poseNees({offset.x(), offset.y(), e.headingAxis}, track.covariance.topLeftCorner<3, 3>());
    e.neesSpeed = normalised(e.speed, track.covariance(3, 3));
    e.neesSize = sizeNees(e, track);
    return e;
}
}  // namespace

std::vector<PoseError> poseErrors(const Sequence& sequence,
                                  const std::vector<FrameMatches>& matches)
{
    std::vector<PoseError> errors;
    for (std::size_t k = 0; k < matches.size(); ++k)
    {
        const ScoredFrame& frame = sequence.frames[k];
        for (const MatchedPair& pair : matches[k].pairs)
        {
            const TruthRow& truth = frame.truth[pair.truth];
            const TrackReport& track = frame.tracks[pair.track].report;
            PoseError error = errorOf(truth, track);
            error.overlap = pair.overlap;
            if (const auto rate = trueYawRate(sequence, k, truth.objectId))
            {
                error.yawRate = track.yawRate - *rate;
            }
            const std::optional<PlanePose> sensor = truth.sensor ? truth.sensor : frame.sensor;
            if (sensor)
            {
                error.corner = cornerError(truth.box, track.box, *sensor);
                error.range = std::hypot(truth.box.x - sensor->x, truth.box.y - sensor->y);
            }
            errors.push_back(std::move(error));
        }
    }
    return errors;
}

}  // namespace vdamf
