// SPDX-License-Identifier: BSD-3-Clause
// The bench as a whole: the scenarios it finds, the programs it runs, the files it leaves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/command_line.h"
#include "files/temporary_folder.h"
#include "regression/catalogue.h"
#include "regression/run.h"
#include "regression/tables.h"

namespace vdamf
{
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const char* const kScene =
    "[scenario]\nduration_s = 1.5\n[sensor]\nmodel = VLP-16\n"
    "[platform]\nspeed_mps = 5\n[object ahead]\nclass = car\nx_m = 12\ny_m = 3\nspeed_mps = 5\n";

// A source tree of two scenarios: one that works and one that does not.
class RegressionRun : public TemporaryFolder
{
protected:
    void SetUp() override
    {
        make("datasets/street/scenario.ini", kScene);
        make("datasets/scenarios/broken.ini", "[scenario]\nduration_s = long\n");
        make("bounds.csv", "scenario,metric,min,max\nstreet,frames,15,15\n");
        make("config.ini", "");
    }

    // Where the programs are not built, there is nothing to run.
    static bool hasPrograms() { return std::filesystem::exists(VDAMF_APPS_DIR "/vdamf-track"); }

    Outcome bench(const std::string& arguments) const
    {
        const std::string folder = at("").string();
        return runShell("cd '" + folder +
                        "' && '" VDAMF_REGRESSION_PROGRAM
                        "' --source . --bounds bounds.csv --out out --jobs 2 " +
                        arguments);
    }

    std::vector<RegressionRow> table() const
    {
        return readRegressionTable(at("out/regression.csv"));
    }

    /// Of the first scenario in the table.
    std::optional<double> value(const char* metric) const
    {
        return table().at(0).values[metricIndex(metric).value()];
    }
};

TEST_F(RegressionRun, AnotherTrackerInPlaceOfOurs)
{
    if (!hasPrograms()) GTEST_SKIP() << "built without the programs";
    const Outcome run = bench("--only street --tracker " VDAMF_CONVENTIONAL_TRACKER);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    ASSERT_EQ(table().size(), 1U);
    EXPECT_EQ(value("frames"), 15.0);
    EXPECT_GT(value("recall").value(), 0.5);
    EXPECT_GT(value("time_per_frame_ms").value(), 0.0);
    EXPECT_EQ(value("vehicles_mota"), value("mota")) << "it takes everything for a vehicle";

    const Outcome none = bench("--only street --tracker /no/such/program");
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_THAT(none.output, HasSubstr("/no/such/program"));
}

TEST_F(RegressionRun, OneScenarioFromScansToTable)
{
    if (!hasPrograms()) GTEST_SKIP() << "built without the programs";
    const Outcome run = bench("--only street");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    ASSERT_EQ(table().size(), 1U);
    EXPECT_EQ(value("frames"), 15.0);
    EXPECT_EQ(value("objects"), 1.0);
    EXPECT_GT(value("recall").value(), 0.5);
    EXPECT_LT(value("position_median_m").value(), 0.5);
    EXPECT_GE(value("vehicles_mota").value(), value("mota").value());
    EXPECT_GT(value("vehicles_hota").value(), 0.5);
    EXPECT_THAT(contentOf("out/street/log.txt"), HasSubstr("--vehicles-only"));
    EXPECT_THAT(contentOf("out/street/metrics.json"), HasSubstr("\"vehicles_only\": true"));
    EXPECT_GT(value("time_per_frame_ms").value(), 0.0);
    EXPECT_THAT(run.output, HasSubstr("street"));
    EXPECT_THAT(contentOf("out/regression.md"), HasSubstr("| street | 15 | 1 |"));
    EXPECT_TRUE(std::filesystem::exists(at("out/street/metrics.json")));
    EXPECT_FALSE(std::filesystem::exists(at("out/street/scans.rawlog")));
    EXPECT_THAT(contentOf("out/street/log.txt"), HasSubstr("vdamf-track"));
}

TEST_F(RegressionRun, AFailureStopsNothingElse)
{
    if (!hasPrograms()) GTEST_SKIP() << "built without the programs";
    const Outcome run = bench("");
    EXPECT_EQ(run.exitCode, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("- broken: vdamf-simulate ended with code 2"));
    EXPECT_THAT(run.output, HasSubstr("duration_s"));
    EXPECT_EQ(readRegressionTable(at("out/regression.csv")).size(), 1U);
}

TEST_F(RegressionRun, ViolatedBoundsFail)
{
    if (!hasPrograms()) GTEST_SKIP() << "built without the programs";
    make("bounds.csv", "scenario,metric,min,max\nstreet,frames,16,\n");
    const Outcome run = bench("--fast --keep");
    EXPECT_EQ(run.exitCode, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("street: frames 15.0000 is below 16"));
    EXPECT_TRUE(std::filesystem::exists(at("out/street/scans.rawlog")));
}

TEST_F(RegressionRun, ComparesWithTheTableThatItReplaces)
{
    if (!hasPrograms()) GTEST_SKIP() << "built without the programs";
    make("out/regression.csv", "scenario,frames,recall\nstreet,99,0.01\n");
    const Outcome run = bench("--only street --compare out/regression.csv");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("better   recall % 1.00 -> "));
    EXPECT_THAT(run.output, HasSubstr("frames 99 -> 15"));
}

TEST_F(RegressionRun, BadUseIsToldApart)
{
    const Outcome unknown = bench("--only stret");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.output, HasSubstr("stret"));
    EXPECT_THAT(unknown.output, HasSubstr("street"));
    EXPECT_EQ(bench("--fast --only street").exitCode, 2);
    EXPECT_EQ(bench("--data missing").exitCode, 2);
}

TEST_F(RegressionRun, FindsScenariosAndRecordings)
{
    make("datasets/scenarios/argoverse.ini", "");
    make("datasets/scenarios/pair.ini", "[sensor left]\n[sensor right]\n");
    make("data/2011_09_26/calib_imu_to_velo.txt", "");
    make("data/2011_09_26/2011_09_26_drive_0005_sync/tracklet_labels.xml", "");
    make("data/2011_09_26/2011_09_26_drive_0007_sync/oxts/timestamps.txt", "");
    make("data/av2_samples/3bff/annotations.csv", "");
    const Catalogue catalogue = catalogueOf(at("datasets"), at("data"));
    std::vector<std::string> names;
    for (const RegressionScenario& one : catalogue.scenarios) names.push_back(one.name);
    EXPECT_THAT(names,
                ElementsAre("street", "broken", "pair", "kitti_09_26_0005", "argoverse_3bff"));
    EXPECT_THAT(catalogue.scenarios[2].track, ElementsAre("--set", "scan.label=left"));
    EXPECT_TRUE(catalogue.notes.empty());
    EXPECT_EQ(catalogueOf(at("datasets"), "").notes.size(), 2U);
}

TEST_F(RegressionRun, TakesTheTimeFromTheSummary)
{
    EXPECT_EQ(trackingTimeIn("  frames  9\n  tracking, all          2.50 ms\n"), 2.5);
    EXPECT_EQ(trackingTimeIn("tracking, all 12 ms"), 12.0);
    EXPECT_EQ(trackingTimeIn("tracking, all  -\nwriting 1 ms\n"), std::nullopt);
    EXPECT_EQ(trackingTimeIn("frames 9\n"), std::nullopt);
}

}  // namespace
}  // namespace vdamf
