// SPDX-License-Identifier: BSD-3-Clause
// What vehicles around tell of the axes of one.
#include "tracker/neighbourhood.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
constexpr std::uint64_t kSelf = 99;

Track parkedAt(std::uint64_t id, double x, double y, double heading)
{
    HeadingCues whole;
    whole.end = {1.8, 0.9};
    whole.side = {4.3, 0.9};
    Track track;
    track.id = id;
    track.status = TrackStatus::Confirmed;
    track.state.mean << x, y, heading, 0.0, 0.0, 1.2, 4.3;
    track.state.width = 1.8;
    track.front = HeadingBelief(whole);
    return track;
}

double evidence(const std::vector<Track>& tracks, const OrientedBox& box)
{
    DiscriminatorOptions off;
    off.model = "none";
    return Neighbourhood(tracks, Discriminator(off)).axesEvidence(box, kSelf);
}

TEST(Neighbourhood, VehiclesAroundSpeakForAxesAlongTheirs)
{
    const std::vector<Track> one{parkedAt(1, 6.0, 0.0, 0.3)};
    EXPECT_GT(evidence(one, {0, 0, 0.25, 4.3, 1.8}), 0.5);
    EXPECT_DOUBLE_EQ(evidence(one, {0, 0, 0.25 + kPi, 4.3, 1.8}),
                     evidence(one, {0, 0, 0.25, 4.3, 1.8}));
    EXPECT_DOUBLE_EQ(evidence(one, {0, 0, 0.25 + 0.5 * kPi, 4.3, 1.8}),
                     -evidence(one, {0, 0, 0.25, 4.3, 1.8}));
    EXPECT_EQ(evidence(one, {0, 0, 0.3 + 0.25 * kPi, 4.3, 1.8}), 0.0) << "askew";
    EXPECT_EQ(evidence(one, {-4, 0, 0.3, 4.3, 1.8}), 0.0) << "far away";
}

TEST(Neighbourhood, ManySayMoreThanOneWithinBounds)
{
    std::vector<Track> row;
    for (int k = 1; k <= 6; ++k) row.push_back(parkedAt(std::uint64_t(k), 0.0, 1.2 * k, 0.0));
    const OrientedBox box{0, 0, 0.0, 4.3, 1.8};
    EXPECT_GT(evidence(row, box), evidence({row.front()}, box));
    EXPECT_LE(evidence(row, box), 3.0);
}

TEST(Neighbourhood, ATrackIsNoNeighbourOfItselfNorIsWhatIsNotPublished)
{
    Track self = parkedAt(kSelf, 1.0, 0.0, 0.0);
    Track tentative = parkedAt(1, 1.0, 0.0, 0.0);
    tentative.status = TrackStatus::Tentative;
    EXPECT_EQ(evidence({self, tentative}, {0, 0, 0, 4.3, 1.8}), 0.0);
}

TEST(Neighbourhood, WhoKnowsNothingOfItsOwnAxesSaysNothing)
{
    Track vague = parkedAt(1, 5.0, 0.0, 0.0);
    vague.front = HeadingBelief();
    HeadingCues told;
    told.neighbours = 3.0;  // by others, in their turn
    vague.front = vague.front.after(told);
    EXPECT_NEAR(evidence({vague}, {0, 0, 0, 4.3, 1.8}), 0.0, 1e-12);
}

TEST(RowAlongFace, EndsAtAGapAndLeavesOutWhatLiesBehindTheFace)
{
    Hits hits;
    const auto add = [&](double x, double y)
    {
        hits.x.push_back(x);
        hits.y.push_back(y);
        hits.weight.push_back(1.0);
        hits.totalWeight += 1.0;
    };
    for (int k = 0; k <= 20; ++k) add(8.0, -0.8 + 0.08 * k);  // the end
    for (int k = 0; k < 5; ++k) add(8.1, 2.6 + 0.1 * k);      // something beside it
    for (int k = 0; k < 30; ++k) add(11.0 + 0.1 * k, 0.9);    // through the windows
    const OrientedBox box{10.15, 0.0, 0.0, 4.3, 1.8};
    const FaceRow end = rowAlongFace(hits, box, {0.0, 0.0}, 0);
    EXPECT_NEAR(end.metres, 1.6, 1e-9);
    EXPECT_EQ(end.hits, 21.0);
}
}  // namespace
}  // namespace vdamf
