// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/simulation/towed_motion.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

namespace vdamf
{
namespace
{
constexpr double kStep = 0.005;  ///< s

class TowedMotion : public Motion
{
public:
    TowedMotion(Trajectory vehicle, const TowBar& bar, double end)
        : vehicle_(std::move(vehicle)), bar_(bar)
    {
        double heading = vehicle_.at(0.0).heading;
        const int steps = 1 + static_cast<int>(std::ceil(std::max(0.0, end) / kStep));
        for (int i = 0; i <= steps; ++i)
        {
            headings_.push_back(heading);
            heading = stepped(i * kStep, heading);
        }
    }

    MotionState at(double time) const override
    {
        const MotionState vehicle = vehicle_.at(time);
        const double heading = headingAt(time, vehicle);
        const Eigen::Vector2d hitch = hitchOf(vehicle);
        const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
        const Eigen::Vector2d axle = hitch - bar_.hitchToAxle * along;
        MotionState state{axle.x(), axle.y(), heading, hitchVelocity(vehicle).dot(along), 0.0};
        state.yawRate = isIntegrated(time) ? yawRate(vehicle, heading) : vehicle.yawRate;
        return state;
    }

private:
    Eigen::Vector2d hitchOf(const MotionState& vehicle) const
    {
        return {vehicle.x - bar_.hitchBehindAxle * std::cos(vehicle.heading),
                vehicle.y - bar_.hitchBehindAxle * std::sin(vehicle.heading)};
    }

    Eigen::Vector2d hitchVelocity(const MotionState& vehicle) const
    {
        const double c = std::cos(vehicle.heading);
        const double s = std::sin(vehicle.heading);
        const double swing = bar_.hitchBehindAxle * vehicle.yawRate;
        return {vehicle.speed * c + swing * s, vehicle.speed * s - swing * c};
    }

    /// The hitch's velocity across the trailer turns it.
    double yawRate(const MotionState& vehicle, double heading) const
    {
        const Eigen::Vector2d across(-std::sin(heading), std::cos(heading));
        return hitchVelocity(vehicle).dot(across) / bar_.hitchToAxle;
    }

    double stepped(double time, double heading) const
    {
        const MotionState middle = vehicle_.at(time + 0.5 * kStep);
        const double k1 = yawRate(vehicle_.at(time), heading);
        const double k2 = yawRate(middle, heading + 0.5 * kStep * k1);
        const double k3 = yawRate(middle, heading + 0.5 * kStep * k2);
        const double k4 = yawRate(vehicle_.at(time + kStep), heading + kStep * k3);
        return heading + kStep / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }

    bool isIntegrated(double time) const
    {
        return time >= 0.0 && time < static_cast<double>(headings_.size() - 1) * kStep;
    }

    double headingAt(double time, const MotionState& vehicle) const
    {
        if (!isIntegrated(time))
        {
            const double rim = time < 0.0 ? 0.0 : static_cast<double>(headings_.size() - 1) * kStep;
            const double angle = time < 0.0 ? 0.0 : headings_.back() - vehicle_.at(rim).heading;
            return vehicle.heading + angle;
        }
        const auto step = std::min(static_cast<std::size_t>(time / kStep), headings_.size() - 2);
        const double begin = static_cast<double>(step) * kStep;
        const double a = headings_[step];
        const double b = headings_[step + 1];
        const double slopeA = kStep * yawRate(vehicle_.at(begin), a);
        const double slopeB = kStep * yawRate(vehicle_.at(begin + kStep), b);
        const double u = (time - begin) / kStep;
        const double v = 1.0 - u;  // Hermite's cubic
        return a * v * v * (1.0 + 2.0 * u) + slopeA * u * v * v + b * u * u * (1.0 + 2.0 * v) -
               slopeB * u * u * v;
    }

    Trajectory vehicle_;
    TowBar bar_;
    std::vector<double> headings_;  ///< every kStep from time 0
};
}  // namespace

Trajectory towed(const Trajectory& vehicle, const TowBar& bar, double end)
{
    return Trajectory(std::make_shared<TowedMotion>(vehicle, bar, end));
}

}  // namespace vdamf
