// SPDX-License-Identifier: BSD-3-Clause
// Network captures to rawlogs: link layers, sweeps, clocks, GPS, damage.
#include "vdamf/rawlog/velodyne_import.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <fstream>

#include "../files/temporary_folder.h"
#include "example_capture.h"
#include "example_objects.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservationGPS;
using mrpt::obs::CObservationVelodyneScan;
using test::ExampleCapture;
using ::testing::HasSubstr;

constexpr double kFirstPacket = 1453364282.0;  // 08:18:02 UTC
constexpr double kPacketPeriod = 24 * 55.296e-6;

class VelodyneImportTest : public TemporaryFolder
{
protected:
    VelodyneImportSummary import(const ExampleCapture& capture)
    {
        return importBytes(capture.bytes());
    }
    VelodyneImportSummary importBytes(const std::string& bytes)
    {
        job_.capture = make("c.pcap", bytes);
        job_.output.rawlog = at("o.rawlog");
        job_.output.existing = OutputFile::Existing::Overwrite;
        return importVelodyne(job_);
    }
    std::string error(const std::string& bytes)
    {
        try
        {
            importBytes(bytes);
        }
        catch (const std::runtime_error& failure)
        {
            return failure.what();
        }
        return "none";
    }

    template <class T>
    std::vector<std::shared_ptr<T>> written()
    {
        RawlogReader reader(at("o.rawlog"));
        std::vector<std::shared_ptr<T>> all;
        for (const RawlogEntry& entry : test::entriesOf(reader))
            if (auto one = std::dynamic_pointer_cast<T>(entry.object)) all.push_back(one);
        return all;
    }

    VelodyneImport job_;
};

/// `turns` of a VLP-16 from `begin` on, by both clocks.
void addTurns(ExampleCapture& capture, double begin, double turns, int host = 1)
{
    double time = begin;
    for (const std::string& packet : test::turningPackets(VelodyneModel::VLP16, begin, turns))
    {
        capture.add(time, packet, host);
        time += kPacketPeriod;
    }
}

TEST_F(VelodyneImportTest, MakesScansOfRevolutions)
{
    ExampleCapture capture;
    addTurns(capture, kFirstPacket, 3.0);
    const VelodyneImportSummary summary = import(capture);
    EXPECT_EQ(summary.scans, 4U);  // they are cut at the rear
    EXPECT_EQ(summary.capture.problem, "");
    EXPECT_THAT(summary.sensors, testing::ElementsAre("velodyne: VLP-16 at 10.0.0.1"));
    const auto scans = written<CObservationVelodyneScan>();
    ASSERT_EQ(scans.size(), 4U);
    std::size_t points = 0;
    for (const auto& scan : scans) points += decodeVelodyne(*scan).size();
    EXPECT_EQ(points, summary.points);
    EXPECT_EQ(points, static_cast<std::size_t>(0.3 / 55.296e-6) * 16);
    EXPECT_NEAR(mrpt::Clock::toDouble(scans[0]->timestamp), kFirstPacket, 1e-6);
    EXPECT_NEAR(mrpt::Clock::toDouble(scans[1]->timestamp), kFirstPacket + 0.05, kPacketPeriod);
    EXPECT_NEAR(mrpt::Clock::toDouble(scans[2]->timestamp), kFirstPacket + 0.15, kPacketPeriod);
    EXPECT_EQ(scans[0]->calibration.laser_corrections.size(), 16U);
}

TEST_F(VelodyneImportTest, CutsWhereAsked)
{
    ExampleCapture capture;
    addTurns(capture, kFirstPacket, 3.0);
    job_.cutAzimuth = 0.0;
    EXPECT_EQ(import(capture).scans, 3U);
}

TEST_F(VelodyneImportTest, ReadsEveryLinkLayer)
{
    for (const std::uint32_t link : {0U, 1U, 12U, 113U, 228U, 276U})
    {
        ExampleCapture capture(link);
        addTurns(capture, kFirstPacket, 1.0);
        EXPECT_EQ(import(capture).capture.data, 76U) << link;
    }
    ExampleCapture tagged;
    tagged.tagged = true;
    addTurns(tagged, kFirstPacket, 1.0);
    EXPECT_EQ(import(tagged).capture.data, 76U);
    EXPECT_THAT(error(ExampleCapture(105).bytes()), HasSubstr("link of type 105"));
}

TEST_F(VelodyneImportTest, TheSensorsClockTakesTheJitterOut)
{
    ExampleCapture capture;
    double time = kFirstPacket;
    int i = 0;
    for (const std::string& packet : test::turningPackets(VelodyneModel::VLP16, kFirstPacket, 2.5))
    {
        capture.add(time + (i % 7 == 3 ? 0.004 : 0.0), packet);
        time += kPacketPeriod;
        ++i;
    }
    import(capture);
    const auto scans = written<CObservationVelodyneScan>();
    ASSERT_EQ(scans.size(), 3U);
    const double between =
        mrpt::Clock::toDouble(scans[2]->timestamp) - mrpt::Clock::toDouble(scans[1]->timestamp);
    EXPECT_NEAR(std::remainder(between, kPacketPeriod), 0.0, 3e-6);
}

TEST_F(VelodyneImportTest, TellsOfAClockThatStartsAnew)
{
    ExampleCapture capture;
    addTurns(capture, kFirstPacket, 1.0);
    // The sensor was switched off and on; it counts from the hour again.
    double time = kFirstPacket + 30.0;
    for (const std::string& packet : test::turningPackets(VelodyneModel::VLP16, 1e6, 1.0))
    {
        capture.add(time, packet);
        time += kPacketPeriod;
    }
    const VelodyneImportSummary summary = import(capture);
    EXPECT_EQ(summary.clockRestarts, 1U);
    EXPECT_NEAR(summary.seconds, 30.05, 0.01);
}

TEST_F(VelodyneImportTest, PositionPacketsBecomeGps)
{
    const std::string rmc =
        "$GPRMC,081802.00,A,3649.7478558,N,00224.4542928,W,0.034,212.5,210116,0.0,E,A*2E\r\n";
    const std::string wrong =
        "$GPRMC,081803.00,A,3649.7478558,N,00224.4542928,W,0.034,212.5,210116,0.0,E,A*2E\r\n";
    const std::string gga =
        "$GPGGA,081804.00,3649.7478558,N,00224.4542928,W,4,12,0.8,25.5,M,48.1,"
        "M,,*46\r\n";
    ExampleCapture capture;
    addTurns(capture, kFirstPacket, 1.0);
    capture.add(kFirstPacket + 0.1, test::positionPacket(1082100000, rmc));
    capture.add(kFirstPacket + 0.2, test::positionPacket(1082200000, rmc));  // nothing new
    capture.add(kFirstPacket + 0.3, test::positionPacket(1082300000, wrong));
    capture.add(kFirstPacket + 2.3, test::positionPacket(1084300000, gga));
    const VelodyneImportSummary summary = import(capture);
    EXPECT_EQ(summary.capture.positions, 4U);
    const auto gps = written<CObservationGPS>();
    ASSERT_EQ(gps.size(), 2U);
    const auto& fields = gps[0]->getMsgByClass<mrpt::obs::gnss::Message_NMEA_RMC>().fields;
    EXPECT_NEAR(fields.latitude_degrees, 36.829130930, 1e-8);
    EXPECT_NEAR(fields.longitude_degrees, -2.407571547, 1e-8);
    EXPECT_NEAR(fields.speed_knots, 0.034, 1e-9);
    EXPECT_EQ(fields.date_year, 16);
    // The time that it was measured at, by the clock of the scans.
    EXPECT_NEAR(mrpt::Clock::toDouble(gps[0]->timestamp), kFirstPacket, 1e-5);
    const auto& height = gps[1]->getMsgByClass<mrpt::obs::gnss::Message_NMEA_GGA>().fields;
    EXPECT_NEAR(height.altitude_meters, 25.5, 1e-9);
    EXPECT_EQ(height.fix_quality, 4);
}

TEST_F(VelodyneImportTest, EachSensorHasScansOfItsOwn)
{
    ExampleCapture capture;
    const auto left = test::turningPackets(VelodyneModel::VLP16, kFirstPacket, 1.0);
    const auto right = test::turningPackets(VelodyneModel::HDL32E, kFirstPacket, 1.0);
    for (std::size_t i = 0; i < left.size(); ++i)
    {
        const double time = kFirstPacket + kPacketPeriod * static_cast<double>(i);
        capture.add(time, left[i], 1);
        capture.add(time, right[i], 2);
    }
    import(capture);
    for (const auto& scan : written<CObservationVelodyneScan>())
    {
        const bool isFirst = scan->sensorLabel == "velodyne";
        EXPECT_TRUE(isFirst || scan->sensorLabel == "velodyne_2");
        EXPECT_EQ(scan->calibration.laser_corrections.size(), isFirst ? 16U : 32U);
    }
}

TEST_F(VelodyneImportTest, PosesAreWrittenInTheirOrder)
{
    ExampleCapture capture;
    addTurns(capture, kFirstPacket, 2.0);
    job_.poses = make("p.txt",
                      "# t x y z qx qy qz qw\n1453364281.9 0 0 0 0 0 0 1\n"
                      "1453364282.1 1 0 0 0 0 0 1\n1453364282.3 2 0 0 0 0 0 1\n");
    EXPECT_EQ(import(capture).poses, 3U);
    RawlogReader reader(at("o.rawlog"));
    double last = 0.0;
    for (const RawlogEntry& entry : test::entriesOf(reader))
    {
        const auto one = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry.object);
        ASSERT_TRUE(one);
        EXPECT_GE(mrpt::Clock::toDouble(one->timestamp), last);
        last = mrpt::Clock::toDouble(one->timestamp);
    }
    EXPECT_EQ(written<mrpt::obs::CObservationRobotPose>().size(), 3U);
    job_.poses = make("k.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
    EXPECT_THAT(error(capture.bytes()), HasSubstr("k.txt: has no times"));
}

TEST_F(VelodyneImportTest, ACutCaptureGivesWhatItHolds)
{
    ExampleCapture capture;
    addTurns(capture, kFirstPacket, 2.0);
    const VelodyneImportSummary summary =
        importBytes(capture.bytes().substr(0, capture.bytes().size() - 700));
    EXPECT_THAT(summary.capture.problem, HasSubstr("truncated"));
    EXPECT_EQ(summary.capture.data, 150U);
    EXPECT_EQ(summary.scans, 3U);
}

TEST_F(VelodyneImportTest, SaysWhatItCannotImport)
{
    EXPECT_THAT(error("no capture at all, but some text"), HasSubstr("c.pcap: not a network"));
    EXPECT_THAT(error(""), HasSubstr("c.pcap: not a network"));
    ExampleCapture other;
    other.add(kFirstPacket, "hello");
    EXPECT_THAT(error(other.bytes()),
                HasSubstr("no data packets of a Velodyne sensor among its 1"));
    ExampleCapture vlp;
    addTurns(vlp, kFirstPacket, 1.0);
    job_.model = VelodyneModel::HDL32E;
    EXPECT_THAT(error(vlp.bytes()), HasSubstr("packets are of the model VLP-16, not HDL-32E"));
    job_.model.reset();
    job_.calibration = make("c.xml", "<nothing/>");
    EXPECT_THAT(error(vlp.bytes()), HasSubstr("c.xml: no calibration"));
    job_.calibration.clear();
    ExampleCapture hdl64;
    for (const std::string& packet : test::turningPackets(VelodyneModel::HDL64E, kFirstPacket, 0.1))
        hdl64.add(kFirstPacket, packet);
    EXPECT_THAT(error(hdl64.bytes()), HasSubstr("needs its own calibration"));
    EXPECT_FALSE(std::filesystem::exists(at("o.rawlog.partial")));
    job_.capture = at("none.pcap");
    EXPECT_THROW(importVelodyne(job_), std::runtime_error);
    job_.capture = job_.output.rawlog;
    EXPECT_THROW(checkPaths(job_), std::runtime_error);
}

TEST_F(VelodyneImportTest, StopsOnRequest)
{
    ExampleCapture capture;
    addTurns(capture, kFirstPacket, 3.0);
    job_.output.progress = [](std::size_t scans, double) { return scans < 2; };
    EXPECT_TRUE(import(capture).stopped);
    EXPECT_FALSE(std::filesystem::exists(at("o.rawlog")));
}

}  // namespace
}  // namespace vdamf
