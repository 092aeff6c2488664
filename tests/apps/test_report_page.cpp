// SPDX-License-Identifier: BSD-3-Clause
// The page of vdamf-report in a browser: loads, plays, seeks, selects, shows the right numbers.
#include <gtest/gtest.h>

#include "apps/track_fixture.h"

namespace vdamf
{
namespace
{
class ReportPage : public TrackProgram
{
};

TEST_F(ReportPage, WorksInABrowser)
{
    constexpr int kNoBrowser = 77;
    constexpr int kNoProgram = 127;
    const Outcome tracked =
        track("-q --frames 20:40 -i " + kStreet + out("t.rawlog") + " --tracks " + path("t.csv"));
    ASSERT_EQ(tracked.exitCode, 0) << tracked.output;
    const Outcome made = runApp("vdamf-report", path("t.rawlog") + " -o " + path("r.html") +
                                                    " --max-range-m 15 --truth " VDAMF_SOURCE_DIR
                                                    "/datasets/street/truth.csv");
    ASSERT_EQ(made.exitCode, 0) << made.output;
    const Outcome used = runShell("PYTHONDONTWRITEBYTECODE=1 python3 " VDAMF_SOURCE_DIR
                                  "/tests/apps/browser/check_report.py " +
                                  path("r.html") + " " + path("t.csv"));
    if (used.exitCode == kNoBrowser || used.exitCode == kNoProgram)
        GTEST_SKIP() << "needs chromium and python3 (packages of these names)";
    EXPECT_EQ(used.exitCode, 0) << used.output;
}

}  // namespace
}  // namespace vdamf
