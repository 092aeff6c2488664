// SPDX-License-Identifier: BSD-3-Clause
// Line scanners, whose hits all lie in one level plane.
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "tracking/tracker/example_frames.h"

namespace vdamf
{
namespace
{
constexpr double kBumper = 0.35;  // m above the ground

LadarFrame levelFrame(double time, const std::vector<OrientedBox>& boxes)
{
    constexpr int kRays = 1440;
    constexpr double kFarthest = 100.0;
    LadarFrame frame;
    frame.time = time;
    frame.sensor = {0.0, 0.0, kBumper};
    frame.planar = true;
    for (int k = 0; k < kRays; ++k)
    {
        const Eigen::Vector2d ray = rotation(2.0 * kPi * k / kRays).col(0);
        double range = kFarthest;
        for (const OrientedBox& box : boxes) range = std::min(range, rangeTo(box, {0.0, 0.0}, ray));
        if (range >= kFarthest) continue;
        frame.points.x.push_back(static_cast<float>(range * ray.x()));
        frame.points.y.push_back(static_cast<float>(range * ray.y()));
        frame.points.z.push_back(static_cast<float>(kBumper));
    }
    return frame;
}

TrackerOptions optionsForBumper()
{
    TrackerOptions options = optionsForBoxes();
    options.ground.assumedSensorHeight = kBumper;
    return options;
}

TEST(LevelScanner, TracksFromABumper)
{
    Tracker tracker{optionsForBumper()};
    const OrientedBox car{15.0, 2.0, 0.0, 4.5, 1.8};
    FrameResult last;
    for (int k = 0; k < 10; ++k) last = tracker.process(levelFrame(0.1 * k, {car}));
    ASSERT_NE(confirmedNear(last, car.centre()), nullptr);
}

// What lies in front hides what is behind it, however low it is hit.
TEST(LevelScanner, ACarThatPassesBehindALorryKeepsItsIdentity)
{
    Tracker tracker{optionsForBumper()};
    const OrientedBox lorry{0.0, 12.0, 0.0, 6.0, 2.0};
    std::set<std::uint64_t> ids;
    for (int k = 0; k < 40; ++k)
    {
        const OrientedBox car{-12.0 + 0.6 * k, 25.0, 0.0, 4.5, 1.8};
        const FrameResult frame = tracker.process(levelFrame(0.1 * k, {car, lorry}));
        if (const TrackReport* track = confirmedNear(frame, car.centre(), 2.0))
            ids.insert(track->id);
        if (k == 39)
        {
            EXPECT_NE(confirmedNear(frame, car.centre(), 2.0), nullptr);
        }
    }
    EXPECT_EQ(ids.size(), 1U);
}
}  // namespace
}  // namespace vdamf
