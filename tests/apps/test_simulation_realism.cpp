// SPDX-License-Identifier: BSD-3-Clause
// Simulated scans of an HDL-64E against recorded ones: as many hits on vehicles, near and far.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <vector>

#include "apps/kitti_scenes.h"

namespace vdamf
{
namespace
{
struct Counts
{
    std::vector<double> recorded;
    std::vector<double> simulated;
};

/// By range in tens of metres.
using CountsByRange = std::map<int, Counts>;

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

bool isCompared(const KittiBox& label)
{
    const double range = label.box.centre().norm();
    const double bearing = std::atan2(label.box.y, label.box.x);
    const bool isCarOrVan = label.objectClass == "Car" || label.objectClass == "Van";
    return isCarOrVan && range >= 8.0 && range <= 60.0 && std::abs(bearing) < 0.7;
}

bool isOccluded(const KittiBox& label, const PointCloud& scan, int points)
{
    return pointsInFront(label, scan) > 3 + points / 10;
}

void compareFrame(const PointCloud& recorded, const std::vector<KittiBox>& labels,
                  std::uint64_t frame, CountsByRange& counts)
{
    const LadarMount mount = kittiMount();
    RandomStream random(1, frame);
    const Scene scene = sceneOf(labels, random);
    const PointCloud simulated = cloudOf(castScan(scene, mount, 0.0, random), mount);
    for (const KittiBox& label : labels)
    {
        if (!isCompared(label)) continue;
        KittiBox onFlatGround = label;
        onFlatGround.bottom = -kKittiMountHeight;
        const int recordedHits = pointsInside(label, recorded, 0.0);
        const int simulatedHits = pointsInside(onFlatGround, simulated, 0.0);
        if (isOccluded(label, recorded, recordedHits)) continue;
        if (isOccluded(onFlatGround, simulated, simulatedHits)) continue;
        Counts& bin = counts[static_cast<int>(label.box.centre().norm() / 10.0)];
        bin.recorded.push_back(recordedHits);
        bin.simulated.push_back(simulatedHits);
    }
}

void compareDrive(const std::filesystem::path& folder, CountsByRange& counts)
{
    const KittiDrive drive = readKittiDrive(folder);
    const std::vector<KittiTracklet> tracklets =
        readKittiTracklets(folder / "tracklet_labels.xml", drive.scans.size());
    for (std::size_t frame = 0; frame < drive.scans.size(); ++frame)
    {
        const std::vector<KittiBox> labels = boxesOf(tracklets, frame);
        if (labels.empty()) continue;
        compareFrame(readKittiScan(drive.scans[frame].path), labels, frame, counts);
    }
}

TEST(SimulationRealism, VehiclesHaveAsManyHitsAsInKitti)
{
    const char* data = std::getenv("VDAMF_DATA_DIR");
    if (data == nullptr) GTEST_SKIP() << "VDAMF_DATA_DIR does not name a folder of recordings";
    const std::filesystem::path day = std::filesystem::path(data) / "2011_09_26";
    CountsByRange counts;
    for (const char* name : {"2011_09_26_drive_0001_sync", "2011_09_26_drive_0005_sync"})
    {
        if (!std::filesystem::exists(day / name)) GTEST_SKIP() << day / name << " is not there";
        compareDrive(day / name, counts);
    }
    EXPECT_EQ(counts.size(), 5U);
    for (const auto& [tens, bin] : counts)
    {
        EXPECT_GE(bin.recorded.size(), 5U);
        const double ratio = median(bin.simulated) / median(bin.recorded);
        std::printf("%d to %d m: %zu vehicles, median hits %g recorded, %g simulated\n", 10 * tens,
                    10 * tens + 10, bin.recorded.size(), median(bin.recorded),
                    median(bin.simulated));
        EXPECT_GT(ratio, 1.0 / 1.5) << "from " << 10 * tens << " m";
        EXPECT_LT(ratio, 1.5) << "from " << 10 * tens << " m";
    }
}
}  // namespace
}  // namespace vdamf
