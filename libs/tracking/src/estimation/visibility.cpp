// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/visibility.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
SizeEstimate updatedEstimate(const SizeEstimate& memory, double measured, double fitVariance,
                             const VisibilityOptions& options)
{
    // What the fit claims is capped: its model of the surface has errors that it does not see.
    double noise = options.sizeSigma * options.sizeSigma + std::min(fitVariance, 1.0);
    double prior = memory.variance + options.sizeDriftSigma * options.sizeDriftSigma;
    const double innovation = measured - memory.mean;
    const double sigma = std::sqrt(prior + noise);
    constexpr double kLoss = 2.0;          // sigmas below the average: visibility loss
    constexpr double kLossNoise = 1000.0;  // then a second of such sights moves the average little
    if (innovation < -kLoss * sigma) noise *= kLossNoise;
    // Hits never add to a vehicle: where they reach farther, the average was of partial sights.
    if (innovation > kLoss * sigma) prior = std::max(prior, innovation * innovation);
    const double gain = prior / (prior + noise);
    return {memory.mean + gain * innovation, (1.0 - gain) * prior};
}
}  // namespace

SizeMemory initialSize(const Measurement& m, const VisibilityOptions& o)
{
    // Ends and sides that could be a car's; what is not seen could be anything.
    const bool lengthFits = !locatesLength(m) || m.box.length < 5.5;
    const bool widthFits = !locatesWidth(m) || m.box.width < 2.3;
    const bool carEnd = locatesWidth(m) && m.box.width > 1.3;
    const bool carSide = locatesLength(m) && m.box.length > 2.1;
    if (o.assumeVehicleSize && lengthFits && widthFits && (carEnd || carSide))
    {
        const SizeMemory car{{o.carLength, o.carLengthSigma * o.carLengthSigma},
                             {o.carWidth, o.carWidthSigma * o.carWidthSigma}};
        return updatedSize(car, m, o);
    }
    const double seen = o.sizeSigma * o.sizeSigma;
    const double hidden = o.unseenSigma * o.unseenSigma;
    return {{m.box.length, locatesLength(m) ? seen + std::min(1.0, m.covariance(3, 3)) : hidden},
            {m.box.width, locatesWidth(m) ? seen + std::min(1.0, m.covariance(4, 4)) : hidden}};
}

SizeMemory updatedSize(const SizeMemory& memory, const Measurement& m, const VisibilityOptions& o)
{
    SizeMemory next = memory;
    if (locatesLength(m))
        next.length = updatedEstimate(memory.length, m.box.length, m.covariance(3, 3), o);
    if (locatesWidth(m))
        next.width = updatedEstimate(memory.width, m.box.width, m.covariance(4, 4), o);
    return next;
}

Eigen::Vector2d nearestPoint(const OrientedBox& box, const Eigen::Vector2d& sensor)
{
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    return {std::clamp(view.x() / (0.5 * box.length), -1.0, 1.0),
            std::clamp(view.y() / (0.5 * box.width), -1.0, 1.0)};
}

Eigen::Vector2d fixedPoint(const Measurement& m, const Eigen::Vector2d& sensor)
{
    Eigen::Vector2d point = nearestPoint(m.box, sensor);
    const auto hides = [&](Face face) { return m.hiddenEnds.has(face); };
    if (hides(Face::Front) != hides(Face::Back)) point.x() = hides(Face::Front) ? -1.0 : 1.0;
    if (hides(Face::Left) != hides(Face::Right)) point.y() = hides(Face::Left) ? -1.0 : 1.0;
    return point;
}

VehicleState resized(const VehicleState& state, const SizeMemory& before, const SizeMemory& after,
                     const Eigen::Vector2d& fixedPoint)
{
    const Eigen::Vector2d move =
        -0.5 * fixedPoint.cwiseProduct(Eigen::Vector2d(after.length.mean - before.length.mean,
                                                       after.width.mean - before.width.mean));
    VehicleState next = state;
    next.mean.head<2>() += rotation(state.mean(kHeading)) * move;
    // Every point of the axle line moves along the heading, so the axis point may follow the
    // centre sideways: it then runs on a path of another radius.
    const double ratio = 1.0 - state.mean(kCurvature) * move.y();
    next.mean(kAxis) += move.x();
    next.mean(kSpeed) *= ratio;
    next.mean(kCurvature) /= ratio;
    return next;
}

PoseMeasurement anchoredPose(const Measurement& m, const SizeMemory& size,
                             const Eigen::Vector2d& sensor, const VisibilityOptions& o)
{
    const Eigen::Vector2d fixed = fixedPoint(m, sensor);
    const Eigen::Vector2d offset =
        0.5 * fixed.cwiseProduct(
                  Eigen::Vector2d(m.box.length - size.length.mean, m.box.width - size.width.mean));
    const Eigen::Matrix2d r = rotation(m.box.heading);
    // d pose / d (x, y, heading, length, width)
    Eigen::Matrix<double, 3, 5> j = Eigen::Matrix<double, 3, 5>::Zero();
    j.topLeftCorner<2, 2>().setIdentity();
    j.block<2, 1>(0, 2) = r * Eigen::Vector2d(-offset.y(), offset.x());
    j.block<2, 1>(0, 3) = r * Eigen::Vector2d(0.5 * fixed.x(), 0.0);
    j.block<2, 1>(0, 4) = r * Eigen::Vector2d(0.0, 0.5 * fixed.y());
    j(2, 2) = 1.0;

    PoseMeasurement pose;
    pose.pose.head<2>() = m.box.centre() + r * offset;
    pose.pose(2) = m.box.heading;
    pose.covariance = j * m.covariance * j.transpose();
    const double position = m.facesSeen.empty() ? o.unseenSigma : o.positionFloor;
    const double heading = m.facesSeen.seesSide() ? o.headingFloor : o.endOnlyHeadingFloor;
    pose.covariance(0, 0) += position * position;
    pose.covariance(1, 1) += position * position;
    pose.covariance(2, 2) += heading * heading;
    // A row of hits with both ends hidden slides along itself as what hides it moves.
    constexpr double kUnknown = 30.0;  // m
    const auto bothHidden = [&](Face a, Face b)
    { return m.hiddenEnds.has(a) && m.hiddenEnds.has(b) ? kUnknown * kUnknown : 0.0; };
    const Eigen::Vector2d unknown(bothHidden(Face::Front, Face::Back),
                                  bothHidden(Face::Left, Face::Right));
    pose.covariance.topLeftCorner<2, 2>() += r * unknown.asDiagonal() * r.transpose();
    return pose;
}

Measurement turnedBy(const Measurement& measurement, int quarters)
{
    Measurement m = measurement;
    // Counter-clockwise, each face becomes the one before it: the left side is the new front.
    constexpr Face kAround[4] = {Face::Front, Face::Left, Face::Back, Face::Right};
    const int turns = ((quarters % 4) + 4) % 4;
    m.box.heading = wrapAngle(m.box.heading + 0.5 * kPi * turns);
    m.facesSeen = m.hiddenEnds = FaceSet();
    for (int k = 0; k < 4; ++k)
    {
        const Face before = kAround[(k + turns) % 4];
        if (measurement.facesSeen.has(before)) m.facesSeen.add(kAround[k]);
        if (measurement.hiddenEnds.has(before)) m.hiddenEnds.add(kAround[k]);
    }
    if (turns % 2 == 1)
    {
        std::swap(m.box.length, m.box.width);
        m.covariance.row(3).swap(m.covariance.row(4));
        m.covariance.col(3).swap(m.covariance.col(4));
    }
    return m;
}

Measurement alignedWith(const Measurement& m, double heading)
{
    return turnedBy(m, std::abs(wrapAngle(m.box.heading - heading)) <= 0.5 * kPi ? 0 : 2);
}

}  // namespace vdamf
