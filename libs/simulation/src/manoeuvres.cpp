// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/simulation/manoeuvres.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "vdamf/files/numbers.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kSmallestRadius = 1.0;      ///< m
constexpr double kSteepestLaneChange = 1.2;  ///< rad

void require(bool isMet, const std::string& what)
{
    if (!isMet) throw std::runtime_error(what);
}

void requireMoving(double speed)
{
    require(std::abs(speed) > 1e-6, "it needs a speed, but the object stands when it begins");
}

/// Steering to a curvature, through 0 to its opposite, and back, in quarters of the time.
std::vector<MotionSegment> swing(double curvature, double duration)
{
    const double quarter = 0.25 * duration;
    return {{quarter, 0.0, 0.0, curvature},
            {2.0 * quarter, 0.0, curvature, -curvature},
            {quarter, 0.0, -curvature, 0.0}};
}

double offsetOf(double speed, double curvature, double duration)
{
    return Trajectory({0.0, 0.0, 0.0, speed, 0.0}, swing(curvature, duration)).at(duration).y;
}
}  // namespace

std::vector<MotionSegment> keep(double duration)
{
    require(duration > 0.0 && duration <= 3600.0, "a duration is above 0 s, to 3600 s");
    return {{duration, 0.0, 0.0, {}}};
}

std::vector<MotionSegment> speedTo(double speed, double target, double acceleration)
{
    require(acceleration > 0.0 && acceleration <= 20.0,
            "an acceleration is above 0 m/s^2, to 20 m/s^2, also when braking");
    require(std::abs(target) <= 60.0, "a speed is from -60 m/s to 60 m/s");
    const double change = target - speed;
    if (change == 0.0) return {};
    return {{std::abs(change) / acceleration, std::copysign(acceleration, change), 0.0, {}}};
}

std::vector<MotionSegment> turn(double speed, double angle, double radius)
{
    requireMoving(speed);
    require(angle != 0.0 && std::abs(angle) <= 8.0 * kPi, "an angle is not 0 and at most 1440 deg");
    require(radius >= kSmallestRadius, "a radius is 1 m or more");
    // Both ramps together turn as far as one of them would at full curvature.
    const double fullTime = std::abs(angle) * radius / std::abs(speed);
    const double ramp = std::min(1.0, 0.5 * fullTime);
    const double curvature = std::copysign(1.0 / radius, angle * speed);
    return {{ramp, 0.0, 0.0, curvature},
            {fullTime - ramp, 0.0, curvature, {}},
            {ramp, 0.0, curvature, 0.0}};
}

std::vector<MotionSegment> laneChange(double speed, double offset, double duration)
{
    requireMoving(speed);
    require(duration > 0.0 && duration <= 3600.0, "a duration is above 0 s, to 3600 s");
    // The heading swings by speed * curvature * duration / 4.
    double low = 0.0;
    double high =
        std::min(4.0 * kSteepestLaneChange / std::abs(speed * duration), 1.0 / kSmallestRadius);
    const double reach = std::abs(offsetOf(speed, high, duration));
    require(std::abs(offset) < reach, "in " + toText(duration) + " s a lane change is less than " +
                                          toFixedText(reach, 2) + " m wide at this speed");
    while (high - low > 1e-15)
    {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (std::abs(offsetOf(speed, middle, duration)) < std::abs(offset) ? low : high) = middle;
    }
    // Curving left leads to the left in both directions of travel.
    return swing(std::copysign(high, offset), duration);
}

}  // namespace vdamf
