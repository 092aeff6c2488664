// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/start_state.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vdamf
{
namespace
{
constexpr double kCarEnd = 1.3;       // m, the narrowest
constexpr double kWidestCar = 2.3;    // m
constexpr double kWidestTruck = 2.8;  // m
constexpr double kLowest = 1.6;       // m, of what is taller than most cars

struct AssumedSize
{
    double metres = 0.0;
    double sigma = 0.0;
};

// Sizes that go with the height of the highest hit (m): by labels of Argoverse 2 and KITTI, each
// metre above a car's roof adds so many to the mean and to the standard deviation.
AssumedSize lengthOfHeight(double height, const VisibilityOptions& o)
{
    const double over = std::max(0.0, height - kLowest);
    return {o.carLength + 1.2 * over, o.carLengthSigma + 0.6 * over};
}
AssumedSize widthOfHeight(double height, const VisibilityOptions& o)
{
    const double over = std::max(0.0, height - kLowest);
    return {o.carWidth + 0.4 * over, o.carWidthSigma + 0.1 * over};
}

// The end of a truck or bus alone tells little of its length.
constexpr AssumedSize kTruckLength{9.0, 2.0};

// Of the vehicle behind an end of that width and height (m).
std::optional<AssumedSize> lengthBehind(double width, double height, const VisibilityOptions& o)
{
    if (width < kCarEnd || width > kWidestTruck) return std::nullopt;
    return width < kWidestCar ? lengthOfHeight(height, o) : kTruckLength;
}

// Ends and sides that could be a car's, or the part of one that is not hidden; what is not seen
// could be anything.
bool couldBeACar(const Measurement& m)
{
    const bool lengthFits = !m.facesSeen.seesSide() || m.box.length < 5.5;
    const bool widthFits = !m.facesSeen.seesEnd() || m.box.width < kWidestCar;
    const bool carEnd = m.facesSeen.seesEnd() && m.box.width > (locatesWidth(m) ? kCarEnd : 0.9);
    const bool carSide = m.facesSeen.seesSide() && m.box.length > (locatesLength(m) ? 2.1 : 1.2);
    return lengthFits && widthFits && (carEnd || carSide);
}

BoxMeasurement withSizes(const Measurement& m, double height, const Eigen::Vector2d& sensor,
                         const VisibilityOptions& o)
{
    Eigen::Vector2d known(m.box.length, m.box.width);
    Eigen::Vector2d sigma(o.unseenSigma, o.unseenSigma);
    constexpr double kLongSide = 5.5;  // m, of vans, trucks and buses
    constexpr double kLargeWidth = 2.1;
    constexpr double kLargeWidthSigma = 0.3;
    if (o.assumeVehicleSize && couldBeACar(m))
    {
        const AssumedSize length = lengthOfHeight(height, o);
        const AssumedSize width = widthOfHeight(height, o);
        known = {length.metres, width.metres};
        sigma = {length.sigma, width.sigma};
    }
    else if (o.assumeVehicleSize && m.facesSeen.seesSide() && !m.facesSeen.seesEnd() &&
             m.box.length > kLongSide)
    {
        known.y() = kLargeWidth;
        sigma.y() = kLargeWidthSigma;
    }
    else if (o.assumeVehicleSize && m.facesSeen.seesEnd() && !m.facesSeen.seesSide() &&
             m.box.width > kWidestCar && m.box.width < kWidestTruck)
    {
        known.x() = kTruckLength.metres;
        sigma.x() = kTruckLength.sigma;
    }
    BoxMeasurement box = boxThrough(m, faceErrors(m, o), known, sensor, o);
    box = withKnown(box, 3, known.x(), sigma.x() * sigma.x());
    return withKnown(box, 4, known.y(), sigma.y() * sigma.y());
}
}  // namespace

SizesTold SizesTold::with(const Measurement& m) const
{
    return {length || locatesLength(m), width || locatesWidth(m)};
}

VehicleState grownToAVehicle(const VehicleState& predicted, const Measurement& m, double height,
                             const SizesTold& told, const VisibilityOptions& o)
{
    if (!o.assumeVehicleSize || told.length || m.facesSeen.seesSide() || !locatesWidth(m))
        return predicted;
    const auto behind = lengthBehind(std::min(m.box.width, predicted.width), height, o);
    if (!behind || behind->metres - predicted.mean(kLength) < behind->sigma) return predicted;
    const double side = m.facesSeen.has(Face::Back) ? 0.5 : -0.5;
    StateVector byFace = StateVector::Zero();
    byFace.head<2>() = side * rotation(predicted.mean(kHeading)).col(0);
    if (predicted.steering != Steering::Independent) byFace(kAxis) = side;
    byFace(kLength) = 1.0;
    VehicleState next = predicted;
    next.mean += (behind->metres - predicted.mean(kLength)) * byFace;
    next.covariance += behind->sigma * behind->sigma * byFace * byFace.transpose();
    return next;
}

VehicleState startState(const Measurement& measurement, double height,
                        const Eigen::Vector2d& sensor, const StartSpeed& speed,
                        const VisibilityOptions& visibility, const MotionOptions& motion)
{
    const BoxMeasurement box = withSizes(measurement, height, sensor, visibility);
    const double axis = motion.axisFractionSigma * box.box(3);
    constexpr double kCurvatureSigma = 0.05;  // 1/m
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
