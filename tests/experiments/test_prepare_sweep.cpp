// SPDX-License-Identifier: BSD-3-Clause
// What is found wrong before anything runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/sweep_fixture.h"
#include "vdamf/evaluation/evaluation.h"
#include "vdamf/evaluation/evaluation_json.h"
#include "vdamf/experiments/metric_names.h"
#include "vdamf/experiments/setting_configuration.h"
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
namespace
{
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class PrepareSweep : public SweepFolder
{
};

TEST_F(PrepareSweep, AGridOverTwoRecordings)
{
    const PreparedSweep sweep = prepareSweep(
        sweepFile("", "measurement.sigma_m = 0.1 : 0.1 : 0.3\nclustering.min_points = 5, 8"));
    ASSERT_THAT(sweep.settings, SizeIs(6));
    EXPECT_EQ(sweep.runs, 12U);
    ASSERT_THAT(sweep.recordings, SizeIs(2));
    EXPECT_EQ(sweep.recordings[0].name, "one");
    EXPECT_EQ(sweep.recordings[1].truth, at("data/two_truth.csv"));
    const std::string ini =
        configurationOf(sweep.file, sweep.base, sweep.file.groups[0], sweep.settings[3]);
    const Configuration c = readConfiguration(IniDocument::parse(ini, "effective"));
    EXPECT_EQ(c.tracker.clustering.minPoints, 8);
    EXPECT_THAT(ini, HasSubstr("sigma_m = 0.2\n"));
}

TEST_F(PrepareSweep, KeysThatTheTrackerDoesNotHave)
{
    EXPECT_THAT(problemOf(sweepFile("", "measurement.sigma = 0.1, 0.2")),
                AllOf(HasSubstr("sweep.ini:4: unknown key measurement.sigma"),
                      HasSubstr("did you mean 'sigma_m'?")));
    EXPECT_THAT(problemOf(sweepFile("", "mesurement.sigma_m = 0.1, 0.2")),
                AllOf(HasSubstr("sweep.ini:4: unknown section [mesurement]"),
                      HasSubstr("did you mean 'measurement'?")));
    EXPECT_THAT(problemOf(sweepFile("", "sigma_m = 0.1, 0.2")),
                AllOf(HasSubstr("sweep.ini:4"), HasSubstr("section.key=value")));
}

TEST_F(PrepareSweep, ValuesThatTheTrackerDoesNotTake)
{
    EXPECT_THAT(problemOf(sweepFile("", "measurement.sigma_m = 0.5 : 0.5 : 1.5")),
                AllOf(HasSubstr("sweep.ini:4: measurement.sigma_m = '1.5'"),
                      HasSubstr("a number from 0.02 to 1")));
    EXPECT_THAT(problemOf(sweepFile("", "measurement.filter = paper, papers")),
                HasSubstr("'papers': expected one of paper"));
    EXPECT_THAT(problemOf(sweepFile("plan = random\ncount = 3", "clustering.min_points = 1 : 9")),
                HasSubstr("a whole number"));
    for (const std::string plan : {"random", "optimise"})
        EXPECT_THAT(problemOf(sweepFile("plan = " + plan, "clustering.min_points = 1 : 9")),
                    HasSubstr("sweep.ini:4: clustering.min_points: a range without a step takes "
                              "any number between 1 and 9; give it one, as in '1 : 1 : 9'"));
    EXPECT_THAT(
        problemOf(sweepFile("", "clustering.gap_m = 0.5, 1\nclustering.max_gap_m = 0.8")),
        AllOf(HasSubstr("setting clustering.gap_m = 1"), HasSubstr("clustering.max_gap_m")));
}

TEST_F(PrepareSweep, ValuesThatGoTogetherOnlyWithOthersOfTheSweep)
{
    const PreparedSweep sweep =
        prepareSweep(sweepFile("", "clustering.gap_m = 0.4, 1\nclustering.max_gap_m = 2"));
    EXPECT_THAT(sweep.settings, SizeIs(2));
    for (const NamedInput& file : filesOfSweep(sweep.file, sweep.base)) EXPECT_EQ(file.path, "");
}

TEST_F(PrepareSweep, AllProblemsOfTheFileAtOnce)
{
    const std::string problem =
        problemOf(sweepFile("goal = most hota.hota\nmetrics = hota.hota, hota.hot",
                            "measurement.sigma_m = 0.3 : 0.1 : 0.1\nclustering.gap_m = 0.4 :"));
    EXPECT_THAT(problem, HasSubstr("sweep.ini:2: sweep.goal: expected 'max' or 'min'"));
    EXPECT_THAT(problem, HasSubstr("sweep.ini:3: sweep.metrics: unknown metric 'hota.hot'; did you "
                                   "mean 'hota.hota'?"));
    EXPECT_THAT(problem, HasSubstr("sweep.ini:5: vary.measurement.sigma_m"));
    EXPECT_THAT(problem, HasSubstr("the range is empty"));
    EXPECT_THAT(problem, HasSubstr("sweep.ini:6: vary.clustering.gap_m"));
}

TEST_F(PrepareSweep, SectionsThatAreMissingOrMisspelt)
{
    EXPECT_THAT(problemOf(make("sweep.ini", "[vary]\na.b = 1\n")), HasSubstr("[recordings]"));
    EXPECT_THAT(problemOf(make("sweep.ini", "[recordings]\nrawlogs = x\n")), HasSubstr("vary"));
    EXPECT_THAT(problemOf(make("sweep.ini", "[swep]\n")),
                HasSubstr("unknown section [swep]; did you mean 'sweep'?"));
    EXPECT_THAT(problemOf(sweepFile("plan = gird", "scan.deskew = true, false")),
                HasSubstr("expected one of grid, random, optimise"));
    EXPECT_THAT(problemOf(sweepFile("", "scan.deskew = true, false", "rawlog = data/*.rawlog")),
                HasSubstr("unknown key recordings.rawlog; did you mean 'rawlogs'?"));
}

TEST_F(PrepareSweep, APlanOfTooManyRuns)
{
    const std::string vary = "measurement.sigma_m = 0.1 : 0.01 : 0.3\nscan.deskew = true, false";
    EXPECT_THAT(problemOf(sweepFile("max_runs = 83", vary)),
                HasSubstr("84 runs (42 settings, 2 recordings), more than max_runs = 83"));
    EXPECT_EQ(prepareSweep(sweepFile("max_runs = 84", vary)).runs, 84U);
    EXPECT_THAT(
        problemOf(sweepFile("plan = optimise\ncount = 600", "measurement.sigma_m = 0.1 : 1")),
        HasSubstr("1200 runs"));
}

TEST_F(PrepareSweep, RecordingsThatAreNotThere)
{
    const std::string vary = "scan.deskew = true, false";
    make("data/three.rawlog", "x");
    EXPECT_THAT(problemOf(sweepFile("", vary)), HasSubstr("three_truth.csv does not exist"));
    std::filesystem::remove(at("data/three.rawlog"));
    EXPECT_THAT(problemOf(sweepFile("", vary, "rawlogs = data/*.log")),
                HasSubstr("no file is called"));
    EXPECT_THAT(problemOf(sweepFile("", vary, "rawlogs = data/*.rawlog, data/one*")),
                HasSubstr("one.rawlog is found twice"));
    EXPECT_THAT(problemOf(sweepFile("config = no.ini", vary)), HasSubstr("no.ini"));
}

TEST_F(PrepareSweep, GroupsHaveTruthScoringAndKeysOfTheirOwn)
{
    make("more/a/scans.rawlog", "x");
    make("more/a/truth.csv", "y");
    make("more/b/scans.rawlog", "z");
    make("more/b/truth.csv", "y");
    const PreparedSweep sweep = prepareSweep(sweepFile(
        "", "scan.deskew = true, false",
        std::string(kRecordings) +
            "\n[recordings more]\nrawlogs = more/*/scans.rawlog\ntruth = {folder}/truth.csv\n"
            "region_fov_deg = 80\nset = scan.label=front, ins.label=gps"));
    ASSERT_THAT(sweep.recordings, SizeIs(4));
    EXPECT_EQ(sweep.recordings[2].name, "a/scans");
    EXPECT_EQ(sweep.recordings[2].truth, at("more/a/truth.csv"));
    EXPECT_EQ(sweep.recordings[2].group, 1U);
    EXPECT_NEAR(sweep.file.groups[1].score.scoring.regionFov, 80 * kPi / 180.0, 1e-12);
    EXPECT_THAT(configurationOf(sweep.file, sweep.base, sweep.file.groups[1], sweep.settings[0]),
                AllOf(HasSubstr("label = front\n"), HasSubstr("label = gps\n")));
    EXPECT_THAT(problemOf(sweepFile("", "scan.deskew = true, false",
                                    std::string(kRecordings) + "\nset = scan.deskew=true")),
                HasSubstr("sweep.ini:9: [recordings] set: scan.deskew is varied as well"));
    EXPECT_THAT(
        problemOf(sweepFile("", "scan.deskew = true, false",
                            std::string(kRecordings) + "\nset = scan.labl=x")),
        AllOf(HasSubstr("sweep.ini:9: [recordings] set: "), HasSubstr("did you mean 'label'?")));
    EXPECT_THAT(problemOf(sweepFile("", "scan.deskew = true, false",
                                    std::string(kRecordings) + "\nset = scan.label")),
                HasSubstr("[recordings] set: expected section.key=value, found 'scan.label'"));
    EXPECT_THAT(problemOf(sweepFile(
                    "", "scan.deskew = true, false",
                    std::string(kRecordings) + "\nset = scan.label=front, scan.label = back")),
                HasSubstr("sweep.ini:9: [recordings] set: scan.label stands there twice"));
}

TEST_F(PrepareSweep, FilesOfASetAreBesideTheSweepWhateverTheBlanks)
{
    make("beside.txt", contentOf(VDAMF_SOURCE_DIR "/models/vehicle.txt"));
    for (const std::string set :
         {"discriminator.model=beside.txt", " discriminator.model = beside.txt "})
    {
        const PreparedSweep sweep = prepareSweep(sweepFile(
            "", "scan.deskew = true, false", std::string(kRecordings) + "\nset = " + set));
        EXPECT_THAT(
            configurationOf(sweep.file, sweep.base, sweep.file.groups[0], sweep.settings[0]),
            HasSubstr("model = " + at("beside.txt").string() + "\n"))
            << set;
    }
}

TEST_F(PrepareSweep, NamesStandInCellsOfTheTable)
{
    make("data/a, \"b\".rawlog", "x");
    make("data/a, \"b\"_truth.csv", "y");
    const PreparedSweep sweep = prepareSweep(sweepFile("", "scan.deskew = true, false"));
    EXPECT_EQ(sweep.recordings.at(0).name, "a; ;b;");
}

TEST(MetricNames, AreThoseOfTheEvaluation)
{
    EXPECT_THAT(metricNames(),
                ::testing::IsSupersetOf(
                    {"hota.hota", "clear_mot.mota", "identity.idf1", "errors.position_m.median",
                     "errors.flips", "errors_by_range_m.10-20.position_m.median",
                     "discriminator.area_under_curve.value", "consistency.nees_pose.mean"}));
    EXPECT_THAT(errorOf([] { checkMetricName("idf1"); }), HasSubstr("unknown metric 'idf1'"));
}

TEST_F(PrepareSweep, EachMetricIsFoundInWhatTheEvaluationWrites)
{
    TruthRow car;
    car.objectId = "car";
    car.objectClass = "Car";
    car.box = {0.0, 0.0, 0.0, 4.0, 2.0};
    TrackRow track;
    track.report.status = TrackStatus::Confirmed;
    track.report.box = car.box;
    const auto file = make("metrics.json", toJson(evaluate({car}, {track})));
    EXPECT_THAT(readMetrics(file, metricNames()), SizeIs(metricNames().size()));
}

}  // namespace
}  // namespace vdamf
