// SPDX-License-Identifier: BSD-3-Clause
// Bounds of hits against their plain definition, for every number of hits left over by the lanes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tracker/sighting.h"
#include "types/cluster_bounds.h"
#include "types/hit_bounds.h"
#include "types/lane_bounds.h"

namespace vdamf
{
namespace
{
Cluster scattered(std::size_t size)
{
    std::mt19937 generator(static_cast<unsigned>(size));
    std::uniform_real_distribution<float> place(-90.0F, -20.0F);
    Cluster cluster;
    for (std::size_t i = 0; i < size; ++i)
    {
        cluster.x.push_back(place(generator));
        cluster.y.push_back(-place(generator));
        cluster.z.push_back(0.0F);
        cluster.height.push_back(0.02F * place(generator));
    }
    return cluster;
}

TEST(Bounds, OfNumbersAreTheirLeastAndGreatest)
{
    for (std::size_t size = 1; size <= 33; ++size)
    {
        const std::vector<float> x = scattered(size).x;
        EXPECT_EQ(leastOf(x.data(), size), *std::min_element(x.begin(), x.end())) << size;
        EXPECT_EQ(greatestOf(x.data(), size), *std::max_element(x.begin(), x.end())) << size;
    }
}

TEST(Bounds, AreThoseOfAllHitsOfACluster)
{
    for (std::size_t size = 1; size <= 33; ++size)
    {
        const Cluster c = scattered(size);
        const ClusterBounds b = boundsOf(c);
        EXPECT_EQ(b.minX, *std::min_element(c.x.begin(), c.x.end())) << size;
        EXPECT_EQ(b.maxX, *std::max_element(c.x.begin(), c.x.end())) << size;
        EXPECT_EQ(b.minY, *std::min_element(c.y.begin(), c.y.end())) << size;
        EXPECT_EQ(b.maxY, *std::max_element(c.y.begin(), c.y.end())) << size;
        const double highest =
            static_cast<double>(*std::max_element(c.height.begin(), c.height.end()));
        EXPECT_EQ(heightOf(c), highest) << size;
    }
    EXPECT_EQ(boundsOf(Cluster()).diagonal(), 0.0);
    EXPECT_EQ(heightOf(Cluster()), 0.0);
}

TEST(Bounds, LieAlongADirection)
{
    const double heading = 0.4;
    for (std::size_t size = 1; size <= 17; ++size)
    {
        const Cluster c = scattered(size);
        Hits hits;
        hits.x.assign(c.x.begin(), c.x.end());
        hits.y.assign(c.y.begin(), c.y.end());
        hits.weight.assign(size, 1.0);
        double least = 1e30;
        double most = -1e30;
        for (std::size_t i = 0; i < size; ++i)
        {
            const double x = std::cos(heading) * hits.x[i] + std::sin(heading) * hits.y[i];
            least = std::min(least, x);
            most = std::max(most, x);
        }
        const HitBounds b = boundsAlong(directionOf(heading), hits);
        EXPECT_NEAR(b.minX, least, 1e-9) << size;
        EXPECT_NEAR(b.maxX, most, 1e-9) << size;
    }
}

}  // namespace
}  // namespace vdamf
