// SPDX-License-Identifier: BSD-3-Clause
// The same drive near the world's origin and far away: the same tracks, bit for bit.
#include <gtest/gtest.h>

#include "tracking/tracker/example_frames.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
namespace
{
/// A vehicle ahead and a parked one, passed at 8 m/s; all at `away` (m).
std::vector<FrameResult> driveAt(const Eigen::Vector3d& away)
{
    Tracker tracker{TrackerOptions{}};
    std::vector<FrameResult> results;
    for (int k = 0; k < 25; ++k)
    {
        const double time = 0.125 * k;
        const std::vector<ExampleBody> bodies{{{14.0 + 9.0 * time, 0.5, 0.05, 4.4, 1.8}},
                                              {{18.0, 4.5, 3.1, 4.1, 1.7}}};
        LadarFrame frame =
            exampleFrame(time, {8.0 * time, 0.25}, bodies, 7 + static_cast<unsigned>(k));
        frame.origin += away;
        frame.sensor += away;
        results.push_back(tracker.process(frame));
    }
    return results;
}

TEST(FarAway, TracksAreTheSame)
{
    constexpr double kRounding = 1e-8;  // m, of adding up what is compared
    const std::vector<FrameResult> here = driveAt(Eigen::Vector3d::Zero());
    std::size_t confirmed = 0;
    // 10 km, 1000 km, and halfway around the Earth, none of them a round number of the computer's.
    for (const Eigen::Vector3d& away :
         {Eigen::Vector3d(10007.0, -9973.0, 31.0), Eigen::Vector3d(1000003.0, 7.0, -5.0),
          Eigen::Vector3d(-20000011.0, 19999999.0, 4001.0)})
    {
        const std::vector<FrameResult> there = driveAt(away);
        for (std::size_t k = 0; k < here.size(); ++k)
        {
            ASSERT_EQ(here[k].tracks.size(), there[k].tracks.size());
            for (std::size_t j = 0; j < here[k].tracks.size(); ++j)
            {
                const TrackReport& a = here[k].tracks[j];
                const TrackReport& b = there[k].tracks[j];
                confirmed += a.status == TrackStatus::Confirmed ? 1 : 0;
                EXPECT_NEAR(a.box.x + away.x(), b.box.x, kRounding);
                EXPECT_NEAR(a.box.y + away.y(), b.box.y, kRounding);
                EXPECT_NEAR(a.z + away.z(), b.z, kRounding);
                EXPECT_EQ(a.box.heading, b.box.heading);
                EXPECT_EQ(a.box.length, b.box.length);
                EXPECT_EQ(a.speed, b.speed);
                EXPECT_EQ(a.nis, b.nis);
                EXPECT_EQ(a.covariance, b.covariance);
            }
        }
    }
    EXPECT_GT(confirmed, 100U);
}

}  // namespace
}  // namespace vdamf
