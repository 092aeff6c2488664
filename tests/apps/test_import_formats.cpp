// SPDX-License-Identifier: BSD-3-Clause
// vdamf-import velodyne-pcap and clouds through the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "apps/track_fixture.h"
#include "rawlog/example_capture.h"
#include "rawlog/sample_rawlogs.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

class ImportFormats : public TrackProgram
{
protected:
    Outcome import(const std::string& arguments) const { return runApp("vdamf-import", arguments); }

    std::string capture() const
    {
        test::ExampleCapture capture;
        double time = 1.7e9;
        for (const auto& packet : test::turningPackets(VelodyneModel::VLP16, time, 2.0))
        {
            capture.add(time, packet);
            time += 24 * 55.296e-6;
        }
        return capture.bytes();
    }

    void cloud(const std::string& name) const
    {
        std::ofstream file(at("in") / name);
        file << "ply\nformat ascii 1.0\nelement vertex 40\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n";
        for (int i = 0; i < 40; ++i) file << 10 + i % 7 << " " << i << " " << 0.1 * i << "\n";
    }
};

TEST_F(ImportFormats, ACaptureIsImportedAndTracked)
{
    const std::string pcap = make("c.pcap", capture()).string();
    const Outcome run =
        import("velodyne-pcap " + pcap + out("o.rawlog") + " --sensor-pose 0 0 1.8 0 0 0");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output,
                AllOf(HasSubstr("sensor      velodyne: VLP-16 at 10.0.0.1"),
                      HasSubstr("packets     151 with returns, 0 with positions, 0 others"),
                      HasSubstr("--set ins.source=standing")));
    const Outcome tracked =
        track(in("o.rawlog") + " --set ins.source=standing --tracks " + path("t.csv"));
    EXPECT_EQ(tracked.exitCode, 0) << tracked.output;
    EXPECT_THAT(tracked.output, HasSubstr("frames             3 of 3 scans"));
}

TEST_F(ImportFormats, ACutCaptureIsKeptAndTold)
{
    const std::string bytes = capture();
    const std::string pcap = make("c.pcap", bytes.substr(0, bytes.size() - 100)).string();
    const Outcome run = import("velodyne-pcap " + pcap + out("o.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("c.pcap: truncated"), HasSubstr("the 3 scans before")));
    EXPECT_TRUE(std::filesystem::exists(at("o.rawlog")));
}

TEST_F(ImportFormats, CloudsAreImportedAndTracked)
{
    std::filesystem::create_directory(at("in"));
    cloud("1.ply");
    cloud("2.ply");
    make("p.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n");
    const Outcome run =
        import("clouds " + path("in") + out("o.rawlog") + " --rate 10 --poses " + path("p.txt"));
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output,
                AllOf(HasSubstr("frames      2 (0.1 s)"), HasSubstr("points      80 (40 a frame)"),
                      HasSubstr("poses       2\n")));
    const Outcome tracked = track(in("o.rawlog") + " --tracks " + path("t.csv"));
    EXPECT_EQ(tracked.exitCode, 0) << tracked.output;
    EXPECT_THAT(tracked.output, HasSubstr("frames             2 of 2 scans"));
}

TEST_F(ImportFormats, HitsThatAreLeftOutAreToldOnce)
{
    const std::string header =
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 2\nPOINTS 4\n"
        "DATA ascii\n";
    for (const char* name : {"in/1.pcd", "in/2.pcd"})
        make(name, header + "10 1 0\nnan nan nan\n1e30 1 0\n10 2 0\n");
    const std::string job = "clouds " + path("in") + out("o.rawlog") + " --overwrite --rate 10";
    const Outcome run = import(job);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("points      4 (2 a frame)"));
    EXPECT_EQ(import(job + " -q").output,
              path("in") + ": left out: 4 hits that are not finite or beyond 1000 km\n");
    make("in/2.pcd", header + "10 1 0\n10 2 0\n10 3 0\n10 4 0\n");
    std::filesystem::remove(at("in/1.pcd"));
    EXPECT_EQ(import(job + " -q").output, "");
}

TEST_F(ImportFormats, ABadCommandLineIsTwo)
{
    for (const char* bad :
         {"velodyne-pcap", "velodyne-pcap c.pcap", "velodyne-pcap c.pcap -o o --model VLP-32",
          "velodyne-pcap c.pcap -o o --sensor-pose 1 2 3", "velodyne-pcap c.pcap -o -",
          "velodyne-pcap c.pcap -o c.pcap", "clouds", "clouds in -o o --rate 0",
          "clouds in -o o --point-time hours", "clouds in -o o --rate 10 --times t.txt",
          "clouds in -o p.txt --poses p.txt", "clouds in -o o --label vdamf_tracks"})
        EXPECT_EQ(import(bad).exitCode, 2) << bad;
    for (const std::string bad :
         {"--cut-azimuth-deg nan", "--cut-azimuth-deg 361", "--sensor-pose 1 2 inf 0 0 0"})
    {
        const Outcome run = import("velodyne-pcap c.pcap -o o " + bad);
        EXPECT_EQ(run.exitCode, 2) << bad;
        EXPECT_THAT(run.output,
                    AllOf(HasSubstr(bad.substr(0, bad.find(' '))), HasSubstr(": expected ")));
    }
    for (const std::string bad : {"--rate nan", "--rate inf", "--sensor-pose 1e300 2 3 0 0 0",
                                  "--sensor-pose 0 0 0 0 0 nan"})
    {
        const Outcome run = import("clouds in -o o " + bad);
        EXPECT_EQ(run.exitCode, 2) << bad;
        EXPECT_THAT(run.output,
                    AllOf(HasSubstr(bad.substr(0, bad.find(' '))), HasSubstr(": expected ")));
    }
    for (const std::string label : {"front #1", "a ; b", "a //b", "#1", " a"})
    {
        const Outcome run = import("clouds in -o o --label '" + label + "'");
        EXPECT_EQ(run.exitCode, 2) << label;
        EXPECT_THAT(run.output, HasSubstr("--label: '" + label + "': expected a text without"));
    }
    for (const char* bad : {"velodyne-pcap /none.pcap -o ", "clouds /none -o "})
    {
        const Outcome run = import(bad + path("o.rawlog"));
        EXPECT_EQ(run.exitCode, 1) << bad;
        EXPECT_THAT(run.output, HasSubstr("vdamf-import: /none"));
    }
    EXPECT_FALSE(std::filesystem::exists(at("o.rawlog")));
    for (const char* help : {"velodyne-pcap --help", "clouds --help"})
        EXPECT_EQ(import(help).exitCode, 0);
}

TEST_F(ImportFormats, SampleCapturesAreTracked)
{
    for (const char* name : {"sample_velodyne_hdl32.pcap", "sample_velodyne_vlp16_gps.pcap"})
    {
        const std::filesystem::path sample = test::sampleRawlog(name);
        if (sample.empty()) GTEST_SKIP() << test::whereSamplesAre();
        const Outcome run = import("velodyne-pcap " + sample.string() + out("o.rawlog") +
                                   " --overwrite --sensor-pose 0 0 1.8 0 0 0");
        EXPECT_EQ(run.exitCode, 0) << run.output;
        const Outcome tracked = track(in("o.rawlog") + " --overwrite --set ins.source=standing" +
                                      out("tracked.rawlog"));
        EXPECT_EQ(tracked.exitCode, 0) << tracked.output;
    }
}

}  // namespace
}  // namespace vdamf
