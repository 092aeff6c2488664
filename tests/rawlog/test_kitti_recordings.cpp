// SPDX-License-Identifier: BSD-3-Clause
// Drive 0001 of KITTI: what its labels must look like once they are in the world.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "../files/temporary_folder.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/kitti_import.h"

namespace vdamf
{
namespace
{
double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Root mean square distance of the boxes from their mean.
double scatter(const std::vector<TruthRow>& rows)
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const TruthRow& row : rows) mean += row.box.centre() / static_cast<double>(rows.size());
    double squares = 0.0;
    for (const TruthRow& row : rows) squares += (row.box.centre() - mean).squaredNorm();
    return std::sqrt(squares / static_cast<double>(rows.size()));
}

std::vector<double> speedsOf(const std::vector<TruthRow>& rows)
{
    std::vector<double> speeds;
    for (const TruthRow& row : rows) speeds.push_back(row.speed);
    return speeds;
}

class KittiRecordingTest : public TemporaryFolder
{
};

TEST_F(KittiRecordingTest, Drive0001)
{
    const char* data = std::getenv("VDAMF_DATA_DIR");
    if (data == nullptr) GTEST_SKIP() << "VDAMF_DATA_DIR does not name a folder of recordings";
    KittiImport job;
    job.drive = std::filesystem::path(data) / "2011_09_26" / "2011_09_26_drive_0001_sync";
    if (!std::filesystem::exists(job.drive)) GTEST_SKIP() << job.drive << " is not there";
    job.rawlog = at("drive.rawlog");
    job.truth = at("truth.csv");
    const KittiImportSummary summary = importKittiDrive(job);
    EXPECT_EQ(summary.scans, 108U);
    EXPECT_NEAR(summary.seconds, 11.04, 0.01);
    EXPECT_EQ(summary.objects, 15U);
    EXPECT_EQ(summary.labels, 572U);
    EXPECT_EQ(summary.labelsWithoutPose, 0U);

    std::map<std::string, std::vector<TruthRow>> objects;
    for (const TruthRow& row : readTruth(*job.truth)) objects[row.objectId].push_back(row);
    int cars = 0;
    int carLabels = 0;
    for (const auto& [id, rows] : objects)
    {
        if (rows.front().objectClass != "Car") continue;
        ++cars;
        carLabels += static_cast<int>(rows.size());
        EXPECT_LT(scatter(rows), 0.2) << "car " << id;
        EXPECT_NEAR(median(speedsOf(rows)), 0.0, 0.2) << "car " << id;
    }
    EXPECT_EQ(cars, 12);
    EXPECT_EQ(carLabels, 352);
    const std::vector<TruthRow>& tram = objects.at("3");
    EXPECT_EQ(tram.front().objectClass, "Tram");
    EXPECT_EQ(tram.size(), 108U);
    EXPECT_NEAR(median(speedsOf(tram)), 9.0, 0.5);
}

}  // namespace
}  // namespace vdamf
