// SPDX-License-Identifier: BSD-3-Clause
// Vehicles that pass so close that their hits come as one cluster keep their identities.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tracking/tracker/example_frames.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
namespace
{
struct Pass
{
    const char* name;
    double gap;     // m between the sides
    double speedA;  // m/s
    double speedB;
};

std::ostream& operator<<(std::ostream& out, const Pass& pass)
{
    return out << pass.name;
}

const TrackReport* publishedNear(const FrameResult& frame, const OrientedBox& truth)
{
    const TrackReport* best = nullptr;
    double least = 1.2;  // m
    for (const TrackReport& track : frame.tracks)
    {
        const bool published =
            track.status == TrackStatus::Confirmed || track.status == TrackStatus::Coasting;
        const double distance = (track.box.centre() - truth.centre()).norm();
        if (!published || distance > least) continue;
        least = distance;
        best = &track;
    }
    return best;
}

class ClosePassing : public testing::TestWithParam<Pass>
{
};

TEST_P(ClosePassing, KeepsIdentities)
{
    const Pass& pass = GetParam();
    Tracker tracker{TrackerOptions()};
    std::set<std::uint64_t> idsA;
    std::set<std::uint64_t> idsB;
    int merged = 0;
    int lost = 0;
    for (int k = 0; k < 50; ++k)
    {
        const double t = 0.1 * k - 2.5;  // s from the moment at which they are abreast
        const OrientedBox a{28.0, pass.speedA * t, 0.5 * kPi, 4.4, 1.8};
        const OrientedBox b{28.0 + 1.8 + pass.gap, pass.speedB * t, 0.5 * kPi, 4.4, 1.8};
        const LadarFrame frame = exampleFrame(0.1 * k, {0.0, -12.0}, {{a, 1.0}, {b, 1.9}},
                                              300U + static_cast<unsigned>(k));
        merged += clusterPoints(frame, removeGround(frame, {}), {}).size() == 1 ? 1 : 0;
        const FrameResult r = tracker.process(frame);
        if (k < 8) continue;
        const TrackReport* trackA = publishedNear(r, a);
        const TrackReport* trackB = publishedNear(r, b);
        lost += (trackA == nullptr ? 1 : 0) + (trackB == nullptr ? 1 : 0);
        if (trackA != nullptr) idsA.insert(trackA->id);
        if (trackB != nullptr) idsB.insert(trackB->id);
    }
    EXPECT_GT(merged, 2) << "the cars never shared a cluster: this test shows nothing";
    EXPECT_EQ(idsA.size(), 1U);
    EXPECT_EQ(idsB.size(), 1U);
    EXPECT_NE(idsA, idsB);
    EXPECT_LE(lost, 2);
}

INSTANTIATE_TEST_SUITE_P(Cars, ClosePassing,
                         testing::Values(Pass{"oncoming", 0.4, 3.0, -3.0},
                                         Pass{"overtaking", 0.5, 8.0, 5.0},
                                         Pass{"past_a_parked_one", 0.4, 7.0, 0.0}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace vdamf
