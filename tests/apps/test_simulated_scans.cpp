// SPDX-License-Identifier: BSD-3-Clause
// The scans of vdamf-simulate as they are read back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "apps/simulate_fixture.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
namespace
{
class SimulatedScans : public SimulateFixture
{
};

/// The returns of a revolution in the sensor's frame, exact, in the order of the packets.
std::vector<Eigen::Vector3d> pointsOf(const SimulatedFrame& frame, const SpinningLadar& ladar)
{
    const double step = 2.0 * kPi / static_cast<double>(frame.scans.at(0).firings.size());
    std::vector<Eigen::Vector3d> points;
    for (const LadarFiring& firing : frame.scans.at(0).firings)
    {
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            const double range = firing.returns[laser].range;
            if (range == 0.0) continue;
            const double e = ladar.elevations[laser];
            const double a = firing.azimuth + step * ladar.laserDelays[laser] / ladar.firingPeriod;
            points.emplace_back(range * std::cos(e) * std::cos(a),
                                -range * std::cos(e) * std::sin(a), range * std::sin(e));
        }
    }
    return points;
}

TEST_F(SimulatedScans, DecodedScansHaveTheSimulatedPoints)
{
    for (const char* model : {"VLP-16", "HDL-32E", "HDL-64E"})
    {
        writeScenario(model);
        ASSERT_EQ(run("scene.ini -o a.rawlog --overwrite"), 0) << contentOf("err.txt");
        const Scenario scenario = readScenario(IniDocument::load(path("scene.ini")));
        RawlogReader reader(path("a.rawlog"));
        mrpt::obs::CObservationVelodyneScan::Ptr scan;
        while (!scan)
        {
            const auto entry = reader.next();
            ASSERT_TRUE(entry);
            scan = std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(entry->object);
        }
        EXPECT_NEAR(scan->sensorPose.z(), 2.0, 1e-9);
        const PointCloud cloud = decodeVelodyne(*scan);
        const std::vector<Eigen::Vector3d> expected =
            pointsOf(simulateFrame(scenario, 0), scenario.sensors.at(0).mount.ladar);
        ASSERT_EQ(cloud.size(), expected.size()) << model;
        ASSERT_GT(cloud.size(), 10000U);
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
            const Eigen::Vector3d point(cloud.x[i], cloud.y[i], cloud.z[i]);
            // Packets hold 2 mm of range and 0.01 degrees of azimuth.
            const double allowed = 0.0015 + 1e-4 * expected[i].norm();
            ASSERT_LT((point - expected[i]).norm(), allowed) << model << ", return " << i;
        }
    }
}

TEST(SimulatedSensors, HaveTheBeamsOfTheDecoder)
{
    const std::pair<LadarModel, VelodyneModel> models[] = {
        {LadarModel::VLP16, VelodyneModel::VLP16},
        {LadarModel::HDL32E, VelodyneModel::HDL32E},
        {LadarModel::HDL64E, VelodyneModel::HDL64E}};
    for (const auto& [simulated, decoded] : models)
    {
        const std::vector<double> beams = ladarOf(simulated).elevations;
        const std::vector<double>& expected = laserElevations(decoded);
        ASSERT_EQ(beams.size(), expected.size());
        for (std::size_t i = 0; i < beams.size(); ++i) EXPECT_NEAR(beams[i], expected[i], 1e-12);
    }
}

TEST_F(SimulatedScans, FrozenRevolutionsHaveOneTime)
{
    ASSERT_EQ(run("scene.ini -o a.rawlog"), 0);
    RawlogReader reader(path("a.rawlog"));
    while (const auto entry = reader.next())
    {
        const auto scan =
            std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(entry->object);
        if (!scan) continue;
        // Within the 1.3 ms of one packet, in which a car at 30 m/s moves 4 cm.
        for (const float time : decodeVelodyne(*scan).time) EXPECT_LT(time, 0.0014F);
    }
}

TEST_F(SimulatedScans, LineScannersBecome2DRangeScans)
{
    std::ofstream(path("lms.ini")) << "[scenario]\nduration_s = 0.2\nrate_hz = 10\n"
                                      "[sensor roof]\nmodel = VLP-16\n"
                                      "[sensor bumper]\nmodel = LMS-291\nrate_hz = 20\nx_m = 3.5\n"
                                      "z_m = 0.5\nrange_noise_m = 0\n"
                                      "[object wall]\nclass = wall\nx_m = 13.65\nheading_deg = 90\n"
                                      "length_m = 40\n";
    ASSERT_EQ(run("lms.ini -o a.rawlog"), 0) << contentOf("err.txt");
    RawlogReader reader(path("a.rawlog"));
    int scans = 0;
    while (const auto entry = reader.next())
    {
        using mrpt::obs::CObservation2DRangeScan;
        const auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(entry->object);
        if (!scan) continue;
        ++scans;
        EXPECT_EQ(scan->sensorLabel, "bumper");
        EXPECT_NEAR(scan->sensorPose.x(), 3.5, 1e-9);
        EXPECT_NEAR(scan->aperture, kPi, 1e-5);
        EXPECT_TRUE(scan->rightToLeft);
        ASSERT_EQ(scan->getScanSize(), 361U);
        int valid = 0;
        for (std::size_t i = 0; i < scan->getScanSize(); ++i)
        {
            if (!scan->getScanRangeValidity(i)) continue;
            ++valid;
            // The wall's face is 10 m ahead.
            EXPECT_NEAR(scan->getScanRange(i) * std::cos(scan->getScanAngle(i)), 10.0, 1e-3);
        }
        EXPECT_GT(valid, 200);
    }
    EXPECT_EQ(scans, 4);
}

TEST_F(SimulatedScans, APassingCarIsSmearedByItsSpeedTimesTheDecodedTimes)
{
    // A box of 4 m length passes at 20 m/s in the opposite direction; the platform stands.
    std::ofstream(path("pass.ini")) << "[scenario]\nduration_s = 0.1\n"
                                       "[sensor]\nmodel = HDL-32E\ninstantaneous = false\n"
                                       "range_noise_m = 0\nhalf_loss_strength = 0\n"
                                       "[object passing]\nclass = box\nlength_m = 4\nwidth_m = 2\n"
                                       "height_m = 1.5\nx_m = 8\ny_m = 6\nheading_deg = 180\n"
                                       "speed_mps = 20\n";
    ASSERT_EQ(run("pass.ini -o a.rawlog"), 0) << contentOf("err.txt");
    RawlogReader reader(path("a.rawlog"));
    mrpt::obs::CObservationVelodyneScan::Ptr scan;
    while (!scan)
    {
        const auto entry = reader.next();
        ASSERT_TRUE(entry);
        scan = std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(entry->object);
    }
    const PointCloud cloud = decodeVelodyne(*scan);
    int onBox = 0;
    double shift = 0.0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        if (cloud.z[i] < -1.9F || cloud.z[i] > -0.51F) continue;  // ground; top
        ++onBox;
        const double way = 20.0 * static_cast<double>(cloud.time[i]);
        shift = std::max(shift, way);
        // Moved back by speed times time it lies on the box as it stood at the scan's begin.
        const double x = std::abs(cloud.x[i] + way - 8.0) - 2.0;
        const double y = std::abs(cloud.y[i] - 6.0) - 1.0;
        EXPECT_NEAR(std::max(x, y), 0.0, 0.01);
    }
    EXPECT_GT(onBox, 300);
    EXPECT_GT(shift, 1.2);  // it is met late in the revolution: 1.2 m and more of smear
}

}  // namespace
}  // namespace vdamf
