// SPDX-License-Identifier: BSD-3-Clause
// A parked car that leaves the sensor's field of view stays where it stands.
#include <gtest/gtest.h>

#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
TEST(LeavingView, AParkedCarStaysWhereItStands)
{
    const Scenario scene = scenarioOf(
        "[scenario]\nduration_s = 3\n"
        "[sensor]\nmodel = VLP-16\nx_m = 1.6\ny_m = 0.7\nz_m = 1.7\nheading_deg = 60\n"
        "field_of_view_deg = 240\n"
        "[platform]\nx_m = 0\ny_m = -1.75\nspeed_mps = 8\n"
        "[object parked]\nclass = hatchback\nx_m = 17\ny_m = -4.7\n");
    const auto tracked = trackedObjects(scene);
    int coasting = 0;
    for (const Seen& frame : tracked.at("parked"))
    {
        if (frame.time < 1.0) continue;
        ASSERT_FALSE(frame.tracks.empty()) << frame.time;
        const TrackReport& track = frame.tracks.front();
        coasting += track.status == TrackStatus::Coasting ? 1 : 0;
        EXPECT_LT((track.box.centre() - frame.truth.box.centre()).norm(), 0.3) << frame.time;
        EXPECT_LT(std::abs(track.speed), 0.3) << frame.time;
    }
    EXPECT_GT(coasting, 5);
}
}  // namespace
}  // namespace vdamf
