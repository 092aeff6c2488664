// SPDX-License-Identifier: BSD-3-Clause
#include "hit_selection.h"

#include <gtest/gtest.h>

#include <numeric>

#include "report/example_run.h"

namespace vdamf
{
namespace
{
std::size_t hitsShown(const ShownHits& shown)
{
    return std::accumulate(shown.clusters.begin(), shown.clusters.end(),
                           shown.ground.size() + shown.overhead.size() + shown.structure.size(),
                           [](std::size_t sum, const ShownCluster& cluster)
                           { return sum + cluster.hits.size(); });
}

TEST(HitSelection, TellsTheGroundFromWhatIsOnATrack)
{
    const ShownHits shown = selectHits(test::exampleFrame(1.0), test::exampleResult(1.0), {});
    ASSERT_EQ(shown.clusters.size(), 1U);
    EXPECT_EQ(shown.clusters[0].track, 7U);
    EXPECT_GT(shown.clusters[0].hits.size(), 300U);
    for (const Eigen::Vector3f& hit : shown.clusters[0].hits) EXPECT_NEAR(hit.x(), 20.0F, 0.1F);
    EXPECT_GT(shown.ground.size(), 1000U);
    for (const Eigen::Vector3f& hit : shown.ground) EXPECT_FLOAT_EQ(hit.z(), 0.0F);
    EXPECT_EQ(shown.clusterCount, 1U);
    EXPECT_EQ(shown.aboveGround, 400U);
}

TEST(HitSelection, GivesClustersToPublishedTracksOnly)
{
    TrackReport elsewhere = test::exampleTrack(9);
    elsewhere.box.y += 10.0;
    elsewhere.measuredBox->y += 10.0;
    TrackReport tentative = test::exampleTrack(11);
    tentative.status = TrackStatus::Tentative;
    const ShownHits shown =
        selectHits(test::exampleFrame(1.0), test::exampleResult(1.0, {elsewhere, tentative}), {});
    ASSERT_EQ(shown.clusters.size(), 1U);
    EXPECT_EQ(shown.clusters[0].track, 0U);
}

TEST(HitSelection, StaysBelowItsLimit)
{
    for (const std::size_t limit : {200U, 1000U, 5000U})
    {
        HitSelectionOptions options;
        options.hitsPerFrame = limit;
        const ShownHits shown =
            selectHits(test::exampleFrame(1.0, 20000), test::exampleResult(1.0), options);
        EXPECT_LE(hitsShown(shown), limit);
        EXPECT_GT(hitsShown(shown), limit / 8);
        EXPECT_FALSE(shown.clusters.at(0).hits.empty());
    }
}

TEST(HitSelection, LeavesOutWhatIsFarOrNoNumber)
{
    LadarFrame frame = test::exampleFrame(1.0, 0);
    const std::size_t before = hitsShown(selectHits(frame, test::exampleResult(1.0), {}));
    for (const float x : {500.0F, std::nanf("")})
    {
        frame.points.x.push_back(x);
        frame.points.y.push_back(0.0F);
        frame.points.z.push_back(0.0F);
    }
    EXPECT_EQ(hitsShown(selectHits(frame, test::exampleResult(1.0), {})), before);
}

}  // namespace
}  // namespace vdamf
