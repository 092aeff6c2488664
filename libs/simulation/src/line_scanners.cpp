// SPDX-License-Identifier: BSD-3-Clause
// Line scanners: SICK's LMS. Sources: the technical descriptions of the LMS2xx and the LMS5xx
// (angles, rates, ranges; the statistical part of the range errors).
#include "line_scanners.h"

#include <cmath>

namespace vdamf
{
namespace
{
SpinningLadar lineScanner(double fieldOfView, double resolution, double rate)
{
    SpinningLadar ladar;
    ladar.elevations = {0.0};
    ladar.laserDelays = {0.0};
    ladar.fieldOfView = fieldOfView;
    ladar.resolution = resolution;
    ladar.maxRate = rate;
    ladar.firingPeriod = resolution / (2.0 * kPi * rate);
    ladar.maxRange = 80.0;
    return ladar;
}
}  // namespace

/// The device interlaces two turns of its mirror at 0.5 degrees; here one turn takes all shots.
SpinningLadar lms291()
{
    SpinningLadar ladar = lineScanner(kPi, 0.5 * kDegree, 75.0);
    ladar.rangeNoise = 0.010;
    ladar.halfLossStrength = 0.011;  // reflectivity 0.1 to 30 m
    ladar.minRange = 0.1;
    return ladar;
}

SpinningLadar lms511()
{
    SpinningLadar ladar = lineScanner(190.0 * kDegree, 0.5 * kDegree, 50.0);
    ladar.rangeNoise = 0.007;
    ladar.halfLossStrength = 0.006;  // reflectivity 0.1 to 40 m
    ladar.minRange = 0.2;
    return ladar;
}

Sweep lineSweep(const SpinningLadar& ladar, double fieldOfView)
{
    const int steps = static_cast<int>(std::floor(fieldOfView / ladar.resolution + 1e-6));
    Sweep sweep;
    sweep.firings = steps + 1;
    sweep.firstAzimuth = 0.5 * steps * ladar.resolution;
    sweep.azimuthStep = -ladar.resolution;
    sweep.period = ladar.resolution / (2.0 * kPi * ladar.maxRate);
    return sweep;
}

}  // namespace vdamf
