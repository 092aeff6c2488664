// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/clustering.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
namespace
{
/// A frame of which every hit is above ground; the sensor is far from the origin of the points.
struct HitFrame
{
    LadarFrame frame;
    AboveGround above;

    HitFrame() { frame.sensor = {100.0, -50.0, 2.0}; }

    /// Place from the sensor.
    void add(double x, double y, double height = 1.0)
    {
        above.index.push_back(static_cast<std::uint32_t>(frame.points.size()));
        above.height.push_back(static_cast<float>(height));
        frame.points.x.push_back(static_cast<float>(x + 100.0));
        frame.points.y.push_back(static_cast<float>(y - 50.0));
        frame.points.z.push_back(static_cast<float>(height));
    }

    /// A row of hits 0.1 m apart.
    void addRow(double x, double y, int count, double stepX, double stepY)
    {
        for (int i = 0; i < count; ++i) add(x + 0.1 * i * stepX, y + 0.1 * i * stepY);
    }

    std::vector<Cluster> clusters(const ClusterOptions& options = {}) const
    {
        return clusterPoints(frame, above, options);
    }
};

std::vector<std::size_t> sizes(const std::vector<Cluster>& clusters)
{
    std::vector<std::size_t> all;
    for (const Cluster& c : clusters) all.push_back(c.size());
    return all;
}

TEST(ClusterPoints, NoHitsNoClusters)
{
    EXPECT_TRUE(HitFrame().clusters().empty());
}

TEST(ClusterPoints, OneMetreKeepsObjectsApartAtAnyRangeAndPlaceInTheGrid)
{
    for (const double range : {4.0, 20.0, 60.0, 79.0})
        for (double offset = 0.0; offset < 0.25; offset += 0.05)
        {
            HitFrame hits;
            hits.addRow(range + offset, 0.0, 20, 0.0, 1.0);
            hits.addRow(range + offset + 1.0, 0.0, 20, 0.0, 1.0);
            EXPECT_THAT(sizes(hits.clusters()), testing::ElementsAre(20, 20))
                << range << " m, offset " << offset;
        }
}

TEST(ClusterPoints, SmallGapsJoinAtAnyPlaceInTheGrid)
{
    for (double offset = 0.0; offset < 0.25; offset += 0.05)
    {
        HitFrame hits;
        hits.addRow(6.0 + offset, offset, 10, 1.0, 0.0);
        hits.addRow(6.9 + offset + 0.3, offset, 10, 0.0, 1.0);
        EXPECT_THAT(sizes(hits.clusters()), testing::ElementsAre(20)) << offset;
    }
}

TEST(ClusterPoints, GapGrowsWithTheRange)
{
    for (const auto& [range, count] : {std::pair{5.0, 2U}, {50.0, 1U}})
    {
        HitFrame hits;
        hits.addRow(range, 0.0, 10, 0.0, 1.0);
        hits.addRow(range, 0.9 + 0.6, 10, 0.0, 1.0);
        EXPECT_EQ(hits.clusters().size(), count) << range;
    }
}

TEST(ClusterPoints, KeepsCoordinatesHeightsAndOrder)
{
    HitFrame hits;
    for (int i = 0; i < 6; ++i) hits.add(10.0 - 0.1 * i, 2.0, 0.3 + 0.1 * i);
    const std::vector<Cluster> clusters = hits.clusters();
    ASSERT_EQ(clusters.size(), 1U);
    EXPECT_EQ(clusters[0].x, hits.frame.points.x);
    EXPECT_EQ(clusters[0].y, hits.frame.points.y);
    EXPECT_EQ(clusters[0].z, hits.frame.points.z);
    EXPECT_EQ(clusters[0].height, hits.above.height);
}

TEST(ClusterPoints, TakesTheHitsAboveGroundOnly)
{
    HitFrame hits;
    hits.addRow(10.0, 0.0, 20, 0.0, 1.0);
    hits.above.index.erase(hits.above.index.begin() + 10, hits.above.index.end());
    hits.above.height.resize(10);
    EXPECT_THAT(sizes(hits.clusters()), testing::ElementsAre(10));
}

TEST(ClusterPoints, ComeFromSouthToNorthWhateverTheOrderOfTheHits)
{
    std::vector<std::pair<double, double>> places;
    for (int cluster = 0; cluster < 5; ++cluster)
        for (int i = 0; i < 10 + cluster; ++i)
            places.emplace_back(10.0 + 2.0 * (cluster % 2) + 0.05 * i, -8.0 + 4.0 * cluster);
    std::mt19937 random(5);
    for (int repetition = 0; repetition < 5; ++repetition)
    {
        std::shuffle(places.begin(), places.end(), random);
        HitFrame hits;
        for (const auto& [x, y] : places) hits.add(x, y);
        EXPECT_THAT(sizes(hits.clusters()), testing::ElementsAre(10, 11, 12, 13, 14));
    }
}

TEST(ClusterPoints, DropsSmallAndLongOnes)
{
    HitFrame hits;
    hits.addRow(10.0, -20.0, 4, 1.0, 0.0);
    hits.addRow(10.0, -10.0, 5, 1.0, 0.0);
    hits.addRow(-20.0, 10.0, 320, 1.0, 0.0);
    EXPECT_THAT(sizes(hits.clusters()), testing::ElementsAre(5));
    ClusterOptions options;
    options.minPoints = 1;
    options.maxExtent = 40.0;
    EXPECT_THAT(sizes(hits.clusters(options)), testing::ElementsAre(4, 5, 320));
}

TEST(ClusterHits, KeepsHitsOfGroupsTooSmall)
{
    HitFrame hits;
    hits.addRow(10.0, -20.0, 4, 1.0, 0.0);
    hits.addRow(10.0, -10.0, 5, 1.0, 0.0);
    hits.add(10.0, 5.0, 0.7);  // alone
    const ClusteredHits all = clusterHits(hits.frame, hits.above, {});
    EXPECT_THAT(sizes(all.clusters), testing::ElementsAre(5));
    ASSERT_EQ(all.loose.size(), 5U);
    EXPECT_THAT(all.loose.y, testing::Contains(5.0F - 50.0F));
    EXPECT_THAT(all.loose.height, testing::Contains(0.7F));
    // What is too long is no group too small.
    ClusterOptions options;
    options.maxExtent = 0.1;
    EXPECT_EQ(clusterHits(hits.frame, hits.above, options).loose.size(), 5U);
}

TEST(ClusterPoints, FollowsWindingObjects)
{
    // A spiral: its end joins cells that were numbered long before.
    HitFrame hits;
    const int count = 1500;
    for (int i = 0; i < count; ++i)
    {
        const double turn = 0.02 * i;
        hits.add(20.0 + 0.3 * turn * std::cos(turn), 0.3 * turn * std::sin(turn));
    }
    EXPECT_THAT(sizes(hits.clusters()), testing::ElementsAre(count));
}

TEST(ClusterPoints, HitsThatAreNotFiniteAreLeftOut)
{
    HitFrame hits;
    hits.addRow(10.0, 0.0, 8, 1.0, 0.0);
    hits.add(std::numeric_limits<double>::quiet_NaN(), 0.0);
    hits.add(10.0, std::numeric_limits<double>::infinity());
    hits.add(1e7, 0.0);
    EXPECT_THAT(sizes(hits.clusters()), testing::ElementsAre(8));
}

TEST(ClusterPoints, ReachesAcrossTheWholeFrame)
{
    HitFrame hits;
    hits.addRow(-900.0, -900.0, 6, 1.0, 0.0);
    hits.addRow(899.0, 900.0, 6, 1.0, 0.0);
    EXPECT_THAT(sizes(hits.clusters()), testing::ElementsAre(6, 6));
}

TEST(ClusterOptions, NamesWhatIsOutOfRange)
{
    EXPECT_TRUE(problemsOf(ClusterOptions{}).empty());
    ClusterOptions options;
    options.gap = 0.0;
    options.minPoints = 0;
    EXPECT_THAT(problemsOf(options), testing::ElementsAre(testing::HasSubstr("gap_m = 0 "),
                                                          testing::HasSubstr("min_points = 0 ")));
}

}  // namespace
}  // namespace vdamf
