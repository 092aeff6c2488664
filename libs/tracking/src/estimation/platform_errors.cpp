// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/platform_errors.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
double shiftVariance(const Eigen::Matrix3d& covariance)
{
    return 0.5 * covariance.topLeftCorner<2, 2>().trace();
}

// Whether it tells shift and turn by itself.
bool tells(const StandingPoint& point)
{
    constexpr double kShift = 0.12;  // m
    constexpr double kTurn = 1.5 * kDegree;
    const Eigen::Vector3d variances = point.innovation.covariance.diagonal();
    return variances.head<2>().maxCoeff() < kShift * kShift && variances(2) < kTurn * kTurn;
}
}  // namespace

Eigen::Matrix3d byMotion(const Eigen::Vector2d& point)
{
    Eigen::Matrix3d j = Eigen::Matrix3d::Identity();
    j(0, 2) = -point.y();
    j(1, 2) = point.x();
    return j;
}

EstimatedMotion commonMotion(const std::vector<StandingPoint>& points, const Eigen::Vector3d& prior)
{
    constexpr double kFreedom = 4.0;  // of Student's distribution
    constexpr int kRounds = 4;
    Eigen::Vector3d motion = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (int round = 0; round < kRounds; ++round)
    {
        Eigen::Matrix3d information = prior.cwiseInverse().asDiagonal();
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const StandingPoint& point : points)
        {
            const Eigen::Matrix3d byAll = byMotion(point.at);
            const Eigen::Matrix3d weights = point.innovation.covariance.inverse();
            const Eigen::Vector3d rest = point.innovation.value - byAll * motion;
            const double share = (kFreedom + 3.0) / (kFreedom + rest.dot(weights * rest));
            const Eigen::Matrix3d gain = share * byAll.transpose() * weights;
            information += gain * byAll;
            sum += gain * point.innovation.value;
        }
        covariance = information.inverse();
        motion = covariance * sum;
    }
    return {{motion(2), motion.head<2>()}, covariance};
}

void PlatformErrors::Spread::fade(double kept)
{
    sum_ *= kept;
    frames_ *= kept;
}

void PlatformErrors::Spread::add(double square, double variance)
{
    sum_ += square - variance;
    frames_ += 1.0;
}

double PlatformErrors::Spread::value() const
{
    constexpr double kWithout = 2.0;  // frames without any error, as if seen before the first one
    return std::max(0.0, sum_ / (frames_ + kWithout));
}

Eigen::Vector3d PlatformErrors::variances() const
{
    constexpr double kLeastShift = 0.01 * 0.01;                   // m^2
    constexpr double kLeastTurn = 0.1 * kDegree * 0.1 * kDegree;  // rad^2
    const double shift = std::max(kLeastShift, shift_.value());
    return {shift, shift, std::max(kLeastTurn, turn_.value())};
}

std::optional<EstimatedMotion> PlatformErrors::after(const std::vector<StandingPoint>& points,
                                                     double dt)
{
    constexpr double kMemory = 4.0;               // s
    constexpr double kVague = 1.0;                // m^2, rad^2
    constexpr double kKnownShift = 0.06 * 0.06;   // m^2
    constexpr double kKnownTurn = 0.006 * 0.006;  // rad^2
    constexpr std::ptrdiff_t kLeastPoints = 2;    // a single one may have set off
    for (Spread* spread : {&shift_, &turn_}) spread->fade(std::exp(-dt / kMemory));
    const EstimatedMotion alone = commonMotion(points, Eigen::Vector3d::Constant(kVague));
    const double ofShift = shiftVariance(alone.covariance);
    const double ofTurn = alone.covariance(2, 2);
    const auto telling = std::count_if(points.begin(), points.end(), tells);
    if (telling >= kLeastPoints && ofShift < kKnownShift && ofTurn < kKnownTurn)
    {
        shift_.add(0.5 * alone.motion.shift.squaredNorm(), ofShift);
        turn_.add(std::pow(alone.motion.turn, 2), ofTurn);
    }
    const bool errs = shift_.value() > std::pow(options_.from, 2) ||
                      turn_.value() > std::pow(options_.fromTurn, 2);
    if (!errs) return std::nullopt;
    return commonMotion(points, variances());
}

}  // namespace vdamf
