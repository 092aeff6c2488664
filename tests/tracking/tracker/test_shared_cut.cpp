// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/shared_cut.h"

#include <gtest/gtest.h>

#include "tracking/association/predicted_car.h"
#include "vdamf/tracking/matched_filter/hits.h"

namespace vdamf
{
namespace
{
void addRearAndSide(Cluster& cluster, const OrientedBox& box)
{
    const auto add = [&cluster](double x, double y)
    {
        cluster.x.push_back(static_cast<float>(x));
        cluster.y.push_back(static_cast<float>(y));
        cluster.z.push_back(0.5F);
        cluster.height.push_back(0.5F);
    };
    const double rear = box.x - 0.5 * box.length;
    const double right = box.y - 0.5 * box.width;
    for (int i = 0; i < 25; ++i)
    {
        add(rear, right + box.width * i / 25.0);
        add(rear + box.length * i / 25.0, right);
    }
}

// Clutter takes no part of what was found to be vehicles.
TEST(SharedCut, PiecesOfVehiclesAreVehicles)
{
    const std::vector<PredictedTarget> cars{predictedCar(20.0, 1.2), predictedCar(20.0, -1.2)};
    SegmentedFrame frame;
    frame.clusters.resize(2);
    for (const PredictedTarget& car : cars) addRearAndSide(frame.clusters[1], car.box);
    addRearAndSide(frame.clusters[0], {40.0, 10.0, 0.0, 4.0, 1.8});
    for (const Cluster& cluster : frame.clusters) frame.hits.push_back(projectHits(cluster, 0.1));
    for (const bool isVehicle : {true, false})
    {
        SegmentedFrame before = frame;
        before.isVehicle = {false, isVehicle};
        const SegmentedFrame cut = withSharedClustersCut(before, cars, TrackerOptions());
        ASSERT_EQ(cut.clusters.size(), 3U);
        EXPECT_EQ(cut.isVehicle, (std::vector<bool>{false, isVehicle, isVehicle}));
    }
}

}  // namespace
}  // namespace vdamf
