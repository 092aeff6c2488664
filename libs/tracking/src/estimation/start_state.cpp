// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/start_state.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "estimation/by_size.h"
#include "vdamf/tracking/estimation/assumed_size.h"

namespace vdamf
{
namespace
{
// Of a new vehicle's path, 1/m: as tight as at a slow turn, and no tighter than this acceleration
// across (m/s^2) lets it be.
constexpr double kCurvatureSigma = 0.05;
constexpr double kAcrossSigma = 2.0;

constexpr double kShortestSide = 2.4;  // m, of any car
constexpr double kVaguelyTold = 0.4;   // m, of lengths

// Which side of an end nothing hides: 1 the left one, -1 the right one, 0 both or none.
double notHidden(const Measurement& m)
{
    return m.hiddenEnds.has(Face::Right) - m.hiddenEnds.has(Face::Left);
}

BoxMeasurement withSizes(const Measurement& m, double height, const Eigen::Vector2d& sensor,
                         const VisibilityOptions& o)
{
    Eigen::Vector2d known(m.box.length, m.box.width);
    // What is seen is a part of something that is longer than wide.
    constexpr double kLongerThanWide = 3.0;
    Eigen::Vector2d sigma(kLongerThanWide * o.unseenSigma, o.unseenSigma);
    const AssumedSizes assumed = assumedSizes(m, height, o);
    const std::optional<AssumedSize> sizes[2] = {assumed.length, assumed.width};
    for (int axis = 0; axis < 2; ++axis)
        if (sizes[axis])
        {
            known(axis) = sizes[axis]->metres;
            sigma(axis) = sizes[axis]->sigma;
        }
    FaceErrors errors = faceErrors(m, o);
    for (int axis = 0; axis < 2; ++axis)
        // The hits are somewhere on it.
        if (!errors.tells(axis, 0) && !errors.tells(axis, 1))
            errors.sigma[axis][0] = errors.sigma[axis][1] = 0.5 * known(axis);
    BoxMeasurement box = boxThrough(m, errors, known, sensor, o);
    box = withKnown(box, 3, known.x(), sigma.x() * sigma.x());
    return withKnown(box, 4, known.y(), sigma.y() * sigma.y());
}

// With the length (axis 0) or width (1) of a vehicle where it is clearly smaller; the end at
// `fixed` stays.
VehicleState grownTo(const VehicleState& state, int axis, double fixed,
                     const std::optional<AssumedSize>& size)
{
    if (!size || size->metres - state.size()(axis) < size->sigma) return state;
    const StateVector change = bySize(state, axis, fixed);
    VehicleState next = state;
    if (axis == 1)
    {
        next.width = size->metres;
        next.widthVariance = size->sigma * size->sigma;
    }
    next.mean += (size->metres - state.size()(axis)) * change;
    next.covariance += size->sigma * size->sigma * change * change.transpose();
    return next;
}

// Which end of an axis stays where the other one is moved: that seen, or else the one that nothing
// hides: 1 the front or left one, -1 the others, 0 both or none.
double staying(const Measurement& m, int axis)
{
    const auto [low, high] = kFaceAt[axis];
    if (m.facesSeen.seesAcross(axis)) return m.facesSeen.has(high) - m.facesSeen.has(low);
    return m.hiddenEnds.has(low) - m.hiddenEnds.has(high);
}

// After a measurement of the curvature, 1/m.
VehicleState withCurvature(const VehicleState& state, double curvature, double variance)
{
    const StateVector gain =
        state.covariance.col(kCurvature) / (state.covariance(kCurvature, kCurvature) + variance);
    VehicleState next = state;
    next.mean += (curvature - state.mean(kCurvature)) * gain;
    next.mean(kHeading) = wrapAngle(next.mean(kHeading));
    next.covariance -= gain * state.covariance.row(kCurvature);
    return next;
}
}  // namespace

SizesTold SizesTold::with(const Measurement& m) const
{
    return {length || locatesLength(m), width || locatesWidth(m)};
}

VehicleState grownToAVehicle(const VehicleState& predicted, const Measurement& m, double height,
                             const SizesTold& told, const VisibilityOptions& o)
{
    if (!o.assumeVehicleSize) return predicted;
    if (!told.length && !locatesLength(m) && m.facesSeen.seesEnd())
    {
        const double seen = m.facesSeen.has(Face::Back) ? -1.0 : 1.0;
        if (!told.width && isPieceOfACarsEnd(m, height))
            return grownTo(grownTo(predicted, 1, notHidden(m), carWidth(height, o)), 0, seen,
                           carLength(height, std::nullopt, o));
        // No truck by hits beyond an end of which not all was ever seen.
        const double width = std::min(m.box.width, predicted.width);
        if (isCarsEnd(width, height) || told.width || locatesWidth(m))
            return grownTo(predicted, 0, seen, lengthBehind(width, height, o));
    }
    // No vehicle is as long and narrow: of that end a part is seen.
    const bool isNarrow = told.width && predicted.width < kNarrowestCar;
    const bool showsWidth = locatesWidth(m) && m.box.width >= kNarrowestCar;
    if ((!told.width || isNarrow) && locatesLength(m) && !showsWidth)
        return grownTo(predicted, 1, m.facesSeen.has(Face::Right) ? -1.0 : 1.0,
                       widthBehind(std::min(m.box.length, predicted.mean(kLength)), height, o));
    return predicted;
}

VehicleState grownAsJudged(const VehicleState& predicted, const Measurement& m, double height,
                           const SizesTold& told, const VisibilityOptions& o)
{
    if (!o.assumeVehicleSize || m.facesSeen.empty()) return predicted;
    VehicleState next = predicted;
    if (!told.width && predicted.width < kNarrowestCar)
        next = grownTo(next, 1, staying(m, 1), carWidth(height, o));
    const double width = std::clamp(next.width, kNarrowestCar, kWidestTruck);
    // No vehicle is as wide and short, hardly one as short as that if it is told vaguely: of its
    // side a part is seen.
    const bool isWideEnd = m.facesSeen.seesEnd() && predicted.width >= kNarrowestCar;
    const bool isVague = predicted.covariance(kLength, kLength) > kVaguelyTold * kVaguelyTold;
    const double shortestTold = isVague ? kShortestUsual : kShortestSide;
    const double shortest = told.length ? (isWideEnd ? shortestTold : 0.0) : kShortestCar;
    if (predicted.mean(kLength) < shortest)
        next = grownTo(next, 0, staying(m, 0), lengthBehind(width, height, o));
    return next;
}

VehicleState goingOnOutOfSight(const VehicleState& state, const Measurement& m,
                               const AssumedSize& whole)
{
    const auto [back, front] = kFaceAt[0];
    const bool isPart = m.facesSeen.seesSide() && m.hiddenEnds.has(back) != m.hiddenEnds.has(front);
    if (!isPart || whole.metres < state.mean(kLength)) return state;
    const StateVector change = bySize(state, 0, m.hiddenEnds.has(front) ? -1.0 : 1.0);
    const double vaguer = std::pow(whole.sigma, 2) - state.covariance(kLength, kLength);
    VehicleState next = state;
    next.mean += (whole.metres - state.mean(kLength)) * change;
    next.covariance += std::max(0.0, vaguer) * change * change.transpose();
    return next;
}

VehicleState withLengthAssumed(const VehicleState& state, const AssumedSize& before,
                               const AssumedSize& now, double seen)
{
    const StateVector change = bySize(state, 0, seen);
    // As far as the length is still the one assumed.
    const double share =
        std::min(1.0, state.covariance(kLength, kLength) / std::pow(before.sigma, 2));
    const double vaguer = std::max(0.0, std::pow(now.sigma, 2) - std::pow(before.sigma, 2));
    VehicleState next = state;
    next.mean += share * (now.metres - before.metres) * change;
    next.covariance += share * share * vaguer * change * change.transpose();
    return next;
}

VehicleState withUsualCurvature(const VehicleState& state)
{
    const double speed = state.mean(kSpeed);
    const double sigma = kAcrossSigma / std::max(1e-6, speed * speed);
    if (state.steering == Steering::Independent || sigma >= kCurvatureSigma) return state;
    // As if it had been measured: what the start did not say, as it did not know the speed.
    const double variance = 1.0 / (std::pow(sigma, -2) - std::pow(kCurvatureSigma, -2));
    return withCurvature(state, 0.0, variance);
}

VehicleState withTurnShown(const VehicleState& state, const TurnShown& turn)
{
    constexpr double kStands = 1e-3;  // m: no way has a curvature
    constexpr double kSigmas = 3.0;   // beyond which the headings err
    const double speed = state.mean(kSpeed);
    const double way = speed * turn.duration;
    if (state.steering == Steering::Independent || std::abs(way) < kStands) return state;
    const double bySpeed = turn.angle * turn.angle * state.covariance(kSpeed, kSpeed);
    const double variance = (turn.variance + bySpeed / (speed * speed)) / (way * way);
    const double both = state.covariance(kCurvature, kCurvature) + variance;
    const double shown = turn.angle / way;
    if (std::pow(shown - state.mean(kCurvature), 2) > kSigmas * kSigmas * both) return state;
    return withCurvature(state, shown, variance);
}

VehicleState startState(const Measurement& measurement, double height,
                        const Eigen::Vector2d& sensor, const StartSpeed& speed,
                        const VisibilityOptions& visibility, const MotionOptions& motion)
{
    const BoxMeasurement box = withSizes(measurement, height, sensor, visibility);
    const double axis = motion.axisFractionSigma * box.box(3);
    VehicleState state;
    state.mean << box.box.head<3>(), speed.mean, 0.0, motion.axisFraction * box.box(3), box.box(3);
    state.width = box.box(4);
    state.widthVariance = box.covariance(4, 4);
    StateMatrix& p = state.covariance;
    p.topLeftCorner<3, 3>() = box.covariance.topLeftCorner<3, 3>();
    p.block<3, 1>(0, kLength) = box.covariance.block<3, 1>(0, 3);
    p.block<1, 3>(kLength, 0) = box.covariance.block<1, 3>(3, 0);
    p(kLength, kLength) = box.covariance(3, 3);
    p(kSpeed, kSpeed) = speed.sigma * speed.sigma;
    p(kCurvature, kCurvature) = kCurvatureSigma * kCurvatureSigma;
    // The axle's prior goes with the length.
    p.row(kAxis) = motion.axisFraction * p.row(kLength);
    p.col(kAxis) = motion.axisFraction * p.col(kLength);
    p(kAxis, kAxis) = axis * axis + std::pow(motion.axisFraction, 2) * p(kLength, kLength);
    return state;
}

}  // namespace vdamf
