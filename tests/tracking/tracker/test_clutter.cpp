// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/clutter.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
PredictedTarget at(double x, double y, bool isClutter)
{
    PredictedTarget target;
    target.box = {x, y, 0.0, 1.0, 1.0};
    target.isClutter = isClutter;
    return target;
}

TEST(Clutter, IsNamedByItsTargets)
{
    const Clutter clutter({at(5.0, 1.0, false), at(6.0, 1.0, true), at(7.0, 1.0, false),
                           at(8.0, 1.0, true), at(30.0, 1.0, true)});
    ClusterBounds cluster;
    cluster.minX = 4.0F;
    cluster.maxX = 9.0F;
    cluster.minY = 0.0F;
    cluster.maxY = 2.0F;
    EXPECT_EQ(clutter.within(cluster), (std::vector<std::size_t>{1, 3}));
    cluster.minY = 1.5F;
    EXPECT_TRUE(clutter.within(cluster).empty()) << "its places are outside";
    EXPECT_TRUE(Clutter({at(5.0, 1.0, false)}).within(cluster).empty());
}

}  // namespace
}  // namespace vdamf
