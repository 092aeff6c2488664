// SPDX-License-Identifier: BSD-3-Clause
// Captures of real sensors, imported whole.
#include <gtest/gtest.h>

#include "../files/temporary_folder.h"
#include "sample_rawlogs.h"
#include "vdamf/rawlog/velodyne_import.h"

namespace vdamf
{
namespace
{
class SampleCaptures : public TemporaryFolder
{
};

TEST_F(SampleCaptures, GiveAllTheirReturns)
{
    struct Expected
    {
        const char* file;
        std::size_t packets, positions, scans, points, gps;
    };
    for (const Expected& expected :
         {Expected{"sample_velodyne_hdl32.pcap", 500, 0, 3, 146705, 0},
          Expected{"sample_velodyne_vlp16_gps.pcap", 293, 57, 5, 73486, 1}})
    {
        VelodyneImport job;
        job.capture = test::sampleRawlog(expected.file);
        if (job.capture.empty()) GTEST_SKIP() << test::whereSamplesAre();
        job.output.rawlog = at(expected.file);
        const VelodyneImportSummary summary = importVelodyne(job);
        EXPECT_EQ(summary.capture.data, expected.packets);
        EXPECT_EQ(summary.capture.positions, expected.positions);
        EXPECT_EQ(summary.scans, expected.scans);
        EXPECT_EQ(summary.points, expected.points);
        EXPECT_EQ(summary.gps, expected.gps);
    }
}

}  // namespace
}  // namespace vdamf
