// SPDX-License-Identifier: BSD-3-Clause
// Rawlogs with flipped bytes, impossible sizes, holes and cuts: none may crash the reader, and the
// bytes must all come through.
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <random>

#include "../files/temporary_folder.h"
#include "example_objects.h"
#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/scan.h"
#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf
{
namespace
{
class RawlogDamage : public TemporaryFolder
{
};

mrpt::obs::CObservationVelodyneScan velodyneScan()
{
    VelodyneFiring firing;
    firing.range.assign(16, 20.0F);
    firing.intensity.assign(16, 0.5F);
    return encodeVelodyne(VelodyneModel::VLP16, 1.5e9, std::vector<VelodyneFiring>(48, firing));
}

mrpt::obs::CObservationGPS gps()
{
    mrpt::obs::CObservationGPS object;
    object.timestamp = mrpt::Clock::fromDouble(1.5e9);
    mrpt::obs::gnss::Message_NMEA_GGA message;
    message.fields.fix_quality = 4;
    message.fields.latitude_degrees = 37.0;
    object.setMsg(message);
    return object;
}

std::string exampleRawlog()
{
    mrpt::obs::CSensoryFrame frame;
    frame.insert(mrpt::obs::CObservationGPS::Create(gps()));
    frame.insert(mrpt::obs::CObservationPointCloud::Create(test::pointCloud(30)));
    mrpt::obs::CObservationRobotPose pose;
    pose.timestamp = mrpt::Clock::fromDouble(1.5e9);
    mrpt::obs::CObservation2DRangeScan scan;
    scan.resizeScanAndAssign(100, 4.0F, true);
    std::string bytes;
    for (int i = 0; i < 3; ++i)
    {
        bytes += serialized(pose) + serialized(test::pointCloud(200)) + serialized(gps()) +
                 serialized(velodyneScan()) + serialized(frame) + serialized(scan) +
                 test::nullObject() + test::unknownObject("a::B", "payload") +
                 serialized(test::odometry(i));
    }
    return bytes;
}

std::string damaged(std::string bytes, std::mt19937& random)
{
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const std::size_t wounds = 1 + below(4);
    for (std::size_t i = 0; i < wounds && bytes.size() > 100; ++i)
    {
        const std::size_t at = below(bytes.size() - 8);
        switch (below(5))
        {
            case 0:
                bytes[at] = static_cast<char>(random());
                break;
            case 1:  // a size
                for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<char>(random());
                break;
            case 2:
                bytes.erase(at, below(300));
                break;
            case 3:
                bytes.insert(at, std::string(below(300), static_cast<char>(random())));
                break;
            default:
                if (below(4) == 0) bytes.resize(at);
                break;
        }
    }
    return bytes;
}

/// Does with an object what the tracker does with it.
void use(const RawlogEntry& entry, InsTrajectory& ins)
{
    if (!entry.object) return;
    ins.insert(*entry.object);
    const auto* observation = dynamic_cast<const mrpt::obs::CObservation*>(entry.object.get());
    if (observation == nullptr || !isScan(*observation)) return;
    try
    {
        scanFrom(*observation);
    }
    catch (const std::runtime_error&)
    {
        // A scan that cannot be used is told, not a crash.
    }
}

TEST_F(RawlogDamage, NeverCrashesAndLosesNoByte)
{
    const std::string whole = exampleRawlog();
    std::mt19937 random(20240229);
    std::uint64_t objects = 0;
    constexpr int kFiles = 250;
    for (int i = 0; i < kFiles; ++i)
    {
        const std::string bytes = damaged(whole, random);
        const auto path = make("damaged.rawlog", bytes);
        try
        {
            RawlogReader reader(path);
            const auto entries = test::entriesOf(reader);
            InsTrajectory ins{InsOptions{}};
            for (const RawlogEntry& entry : entries) use(entry, ins);
            ins.at(1.5e9);
            ASSERT_TRUE(bytes == test::concatenated(entries)) << "file " << i;
            objects += reader.summary().objects;
        }
        catch (const std::runtime_error& error)
        {
            ADD_FAILURE() << "file " << i << ": " << error.what();
        }
    }
    // Of 21 objects in each whole file.
    EXPECT_GT(static_cast<double>(objects) / kFiles, 17.0);
}

TEST_F(RawlogDamage, OfGzStreamsNeverCrashes)
{
    RawlogWriter::Options options;
    options.memberBytes = 2000;
    RawlogWriter writer(at("whole.rawlog"), options);
    for (int i = 0; i < 300; ++i) writer.write(test::odometry(i));
    writer.commit();
    const std::string whole = contentOf("whole.rawlog");
    std::mt19937 random(4);
    std::uint64_t objects = 0;
    constexpr int kFiles = 200;
    for (int i = 0; i < kFiles; ++i)
    {
        const std::string bytes = damaged(whole, random);
        try
        {
            RawlogReader reader(make("damaged.rawlog", bytes));
            test::entriesOf(reader);
            objects += reader.summary().objects;
            EXPECT_TRUE(bytes == whole || reader.summary().truncated) << "file " << i;
        }
        catch (const std::runtime_error&)
        {
            // The very first member may be hit.
        }
    }
    EXPECT_GT(static_cast<double>(objects) / kFiles, 200.0);
}

}  // namespace
}  // namespace vdamf
