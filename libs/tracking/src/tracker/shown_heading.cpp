// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/shown_heading.h"

#include <algorithm>
#include <cmath>

#include "types/box_changes.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kSigmas = 5.0;               // beyond which two headings contradict each other
constexpr double kVaguer = 2.0;               // times the variance of what was shown
constexpr double kSure = 0.7 * kPi / 180.0;   // rad
constexpr double kJitter = 0.02;              // of a measurement's variance, new in each frame
constexpr double kLeast = 0.2 * kPi / 180.0;  // rad: bodies are not known any better

// To another heading, but for quarter turns, rad.
double turnTo(double heading, double from)
{
    return std::remainder(heading - from, 0.5 * kPi);
}
}  // namespace

ShownHeading ShownHeading::after(const Measurement& measurement, const View& now) const
{
    const double measured = measurement.covariance(2, 2);
    const double turn = turnTo(measurement.box.heading, heading);
    ShownHeading next = *this;
    next.view = now;
    // What contradicts it makes it doubtful.
    const double known = std::max(variance, turn * turn / (kSigmas * kSigmas) - measured);
    const double news = std::min(1.0, kJitter + changeOfView(view, now));
    const double gain = known / (known + measured / news);
    next.heading = wrapAngle(heading + gain * turn);
    next.variance = std::max(kLeast * kLeast, (1.0 - gain) * known);
    return next;
}

ShownHeading turned(ShownHeading shown, int quarters)
{
    shown.view.bearing = wrapAngle(shown.view.bearing - 0.5 * kPi * quarters);
    return shown;
}

Measurement turnedTowards(const ShownHeading& shown, const Measurement& measurement,
                          const Eigen::Vector2d& hits)
{
    const double measured = measurement.covariance(2, 2);
    const double turn = turnTo(shown.heading, measurement.box.heading);
    const bool isKnown = shown.variance < kSure * kSure && measured > kVaguer * shown.variance;
    const bool contradicts = turn * turn > kSigmas * kSigmas * (shown.variance + measured);
    if (!isKnown || contradicts) return measurement;
    Measurement m = measurement;
    m.box = turnedAbout(hits, measured / (measured + shown.variance) * turn, m.box);
    return m;
}

}  // namespace vdamf
