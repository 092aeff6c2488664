// SPDX-License-Identifier: BSD-3-Clause
// Monte Carlo of what tracks say of their poses: simulated vehicles of several shapes and sizes err
// as much as that.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tracking/decompositions.h"
#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
constexpr int kSeeds = 9;

// duration: s
std::string sceneOf(const std::string& duration, const std::string& platform,
                    const std::string& vehicle, int seed)
{
    const char* shapes[] = {"car", "hatchback", "suv"};
    return "[scenario]\nduration_s = " + duration +
           "\nseed = 1\n[sensor]\nx_m = 0.8\nz_m = 1.9\n[platform]\n" + platform +
           "\n[object seen]\nclass = " + shapes[seed % 3] +
           "\nlength_m = " + std::to_string(3.7 + 0.15 * (seed % kSeeds)) + "\n" + vehicle;
}

// Mean errors squared over what is told of them, of frames from a time on.
struct MeanNees
{
    double pose = 0.0;
    double heading = 0.0;
    int frames = 0;
};

void add(const Scenario& scenario, double from, MeanNees& mean)
{
    const auto objects = trackedObjects(scenario);
    for (const Seen& seen : objects.at("seen"))
    {
        if (seen.time < from || seen.tracks.empty()) continue;
        const TrackReport& track = seen.tracks.front();
        const double turned = std::remainder(track.box.heading - seen.truth.box.heading, kPi);
        if (std::abs(turned) > 0.25 * kPi) continue;  // its axes are exchanged
        Eigen::Vector3d error;
        error << track.box.centre() - seen.truth.box.centre(), turned;
        mean.pose += squaredMahalanobis(error, track.covariance.topLeftCorner<3, 3>()) / 3.0;
        mean.heading += turned * turned / track.covariance(2, 2);
        ++mean.frames;
    }
}

TEST(ToldPose, IsAsSureOfWhatIsFollowedAsItErrs)
{
    MeanNees mean;
    for (int seed = 0; seed < kSeeds; ++seed)
    {
        const std::string ahead = std::to_string(14 + 2 * seed);
        add(scenarioOf(sceneOf("4", "speed_mps = 12\ny_m = 0.3",
                               "speed_mps = 12\ny_m = 0\nx_m = " + ahead, seed),
                       seed + 1),
            2.0, mean);
    }
    ASSERT_GT(mean.frames, 12 * kSeeds);
    EXPECT_GT(mean.heading / mean.frames, 0.45);
    EXPECT_LT(mean.heading / mean.frames, 1.5);
    EXPECT_GT(mean.pose / mean.frames, 0.42);
    EXPECT_LT(mean.pose / mean.frames, 1.5);
}

TEST(ToldPose, DoesNotTakeHitsThatComeAgainForSure)
{
    constexpr int kStanding = 4 * kSeeds;  // each errs alike in all of its frames
    MeanNees mean;
    for (int seed = 0; seed < kStanding; ++seed)
    {
        const std::string heading = std::to_string(176 + seed % kSeeds);
        add(scenarioOf(sceneOf("1.7", "speed_mps = 0",
                               "y_m = -6\nx_m = " + std::to_string(22 + seed % kSeeds) +
                                   "\nheading_deg = " + heading,
                               seed),
                       seed + 1),
            1.0, mean);
    }
    ASSERT_GT(mean.frames, 4 * kStanding);
    EXPECT_LT(mean.heading / mean.frames, 2.0);
    EXPECT_GT(mean.heading / mean.frames, 0.4);
    EXPECT_LT(mean.pose / mean.frames, 1.5);
}

}  // namespace
}  // namespace vdamf
