// SPDX-License-Identifier: BSD-3-Clause
// What lies close around the sensor, and in it.
#include <gtest/gtest.h>

#include <cmath>

#include "vdamf/tracking/tracker/tracker.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
void add(LadarFrame& frame, double x, double y, double z)
{
    frame.points.x.push_back(static_cast<float>(x));
    frame.points.y.push_back(static_cast<float>(y));
    frame.points.z.push_back(static_cast<float>(z));
}

// A wall half as high as the sensor again, 0.3 m beside it and hidden at its ends below, and hits
// `away` from the sensor's axis, as drivers have them where no ray came back.
LadarFrame wallBeside(double time, double away)
{
    LadarFrame frame;
    frame.time = time;
    for (int range = 3; range < 60; range += 2)
        for (int bearing = 0; bearing < 360; bearing += 3)
            add(frame, range * std::cos(bearing * kDegree), range * std::sin(bearing * kDegree),
                -1.9);
    for (double x = -1.03; x < 1.39; x += 0.06)
        for (double z = -1.5; z < 0.05; z += 0.15) add(frame, x, 0.3, z);
    for (int k = 0; k < 10; ++k) add(frame, away, 0.0, 0.05 - 0.01 * k);
    for (double y = 0.0; y < 0.61; y += 0.05)
        for (double z = -1.5; z < -0.9; z += 0.1)
        {
            add(frame, 1.69, y, z);
            add(frame, -1.33, y, z);
        }
    return frame;
}

TEST(BesideTheSensor, HitsOnItsAxisAreNoHindrance)
{
    TrackerOptions options;
    options.ground.minRange = 0.0;
    for (const double away : {1e-9, 0.0})
    {
        Tracker tracker(options);
        for (int k = 0; k < 5; ++k)
            for (const TrackReport& track : tracker.process(wallBeside(0.1 * k, away)).tracks)
            {
                EXPECT_TRUE(std::isfinite(track.box.length));
                EXPECT_TRUE(track.covariance.allFinite());
            }
    }
}

}  // namespace
}  // namespace vdamf
