// SPDX-License-Identifier: BSD-3-Clause
// vdamf-evaluate through its command line: known tracks get the scores that they must have.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "apps/evaluate_fixture.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

void expectPerfect(const Json& m)
{
    for (const char* score : {"hota", "det_a", "ass_a", "loc_a"})
        EXPECT_NEAR(m["hota"][score].get<double>(), 1.0, 1e-9) << score;
    for (const char* score : {"mota", "motp", "recall", "precision"})
        EXPECT_NEAR(m["clear_mot"][score].get<double>(), 1.0, 1e-9) << score;
    EXPECT_NEAR(m["identity"]["idf1"].get<double>(), 1.0, 1e-12);
    EXPECT_EQ(m["clear_mot"]["identity_switches"], 0);
    EXPECT_EQ(m["clear_mot"]["fragmentations"], 0);
    for (const char* error : {"position_m", "longitudinal_m", "lateral_m", "heading_deg",
                              "heading_mod_180_deg", "speed_mps", "length_m", "width_m"})
    {
        EXPECT_EQ(m["errors"][error]["max"], 0.0) << error;
        EXPECT_GT(m["errors"][error]["count"], 0) << error;
    }
    EXPECT_EQ(m["errors"]["flips"], 0);
    EXPECT_EQ(m["coverage"]["ever_tracked"], 1.0);
}

TEST_F(EvaluateAppTest, TheTruthItselfIsPerfect)
{
    writeTables(unchanged);
    const Json m = metrics();
    expectPerfect(m);
    EXPECT_EQ(m["errors"]["yaw_rate_degps"]["max"], 0.0);
    EXPECT_EQ(m["errors"]["corner_m"]["max"], 0.0);
    EXPECT_EQ(m["scored"]["object_rows"], 40);
    EXPECT_EQ(m["clear_mot"]["mostly_tracked"], 2);
    EXPECT_EQ(m["coverage"]["time_to_first_s"]["max"], 0.0);
    EXPECT_TRUE(m["discriminator"].is_null());
}

TEST_F(EvaluateAppTest, ShiftedSwappedAndLostAsBadAsItIs)
{
    writeTables(
        [](TrackRow row, int frame) -> std::vector<TrackRow>
        {
            if (frame % 5 == 4) return {};
            if (frame >= 10) row.report.id = 3 - row.report.id;
            return {moved(std::move(row), 0.3, 0.0)};
        });
    const Json m = metrics();
    const Json& c = m["clear_mot"];
    EXPECT_EQ(c["true_positives"], 32);
    EXPECT_EQ(c["false_negatives"], 8);
    EXPECT_EQ(c["false_positives"], 0);
    EXPECT_EQ(c["identity_switches"], 2);
    EXPECT_EQ(c["fragmentations"], 6);
    EXPECT_EQ(c["partly_tracked"], 2);
    EXPECT_NEAR(c["mota"].get<double>(), (32.0 - 2.0) / 40.0, 1e-12);
    EXPECT_NEAR(c["motp"].get<double>(), 3.7 / 4.3, 1e-6);
    EXPECT_NEAR(c["motp_distance_m"].get<double>(), 0.3, 1e-9);
    EXPECT_NEAR(m["identity"]["idf1"].get<double>(), 2.0 * 16 / (2.0 * 16 + 16 + 24), 1e-12);
    // 17 of 19 thresholds lie below the overlap; each identity stands for 8 of 20 and of 16 rows.
    const double share = 17.0 / 19.0;
    EXPECT_NEAR(m["hota"]["det_a"].get<double>(), share * 0.8, 1e-9);
    EXPECT_NEAR(m["hota"]["ass_a"].get<double>(), share * 8.0 / 28.0, 1e-9);
    EXPECT_NEAR(m["hota"]["hota"].get<double>(), share * std::sqrt(0.8 * 8.0 / 28.0), 1e-9);
    const Json& e = m["errors"];
    EXPECT_NEAR(e["longitudinal_m"]["median"].get<double>(), 0.3, 1e-9);
    EXPECT_NEAR(e["longitudinal_m"]["bias"].get<double>(), 0.3, 1e-9);
    EXPECT_NEAR(e["position_m"]["rms"].get<double>(), 0.3, 1e-9);
    EXPECT_NEAR(e["lateral_m"]["max"].get<double>(), 0.0, 1e-9);
    EXPECT_NEAR(e["corner_m"]["median"].get<double>(), 0.3, 1e-9);
    EXPECT_EQ(e["pairs"], 32);
    EXPECT_EQ(e["yaw_rate_degps"]["count"], 30);
    EXPECT_NEAR(m["coverage"]["longest_gap_s"]["max"].get<double>(), 0.2, 1e-6);
    // (0.3 m)^2 / (0.1 m)^2 where 3 are expected.
    EXPECT_NEAR(m["consistency"]["nees_pose"]["mean"].get<double>(), 3.0, 1e-6);
    EXPECT_EQ(m["objects"].size(), 2U);
    EXPECT_EQ(m["objects"][0]["found"], 16);
    EXPECT_EQ(m["objects"][0]["tracks"], 2);
}

TEST_F(EvaluateAppTest, OneFlipIsCountedOnce)
{
    writeTables(
        [](TrackRow row, int frame) -> std::vector<TrackRow>
        {
            if (frame == 7 && row.report.id == 1)
            {
                row.report.box.heading = kPi;
                row.report.speed *= -1.0;
            }
            return {row};
        });
    const Json m = metrics();
    EXPECT_EQ(m["errors"]["flips"], 1);
    EXPECT_LT(m["errors"]["front_share"], 1.0);
    EXPECT_EQ(m["flips_of_moving_objects"], 1);
    EXPECT_NEAR(m["errors"]["heading_deg"]["max"].get<double>(), 180.0, 1e-4);
    EXPECT_NEAR(m["errors"]["heading_mod_180_deg"]["max"].get<double>(), 0.0, 1e-4);
    EXPECT_NEAR(m["errors"]["speed_mps"]["max"].get<double>(), 0.0, 1e-9);
}

TEST_F(EvaluateAppTest, LengthTakenForWidthIsCounted)
{
    writeTables(
        [](TrackRow row, int frame) -> std::vector<TrackRow>
        {
            const bool isAcross = frame >= 7 && frame < 10 && row.report.id == 1;
            if (isAcross) row.report.box.heading += 0.5 * kPi;
            row.report.axesProbability = isAcross && frame == 7 ? 0.6 : 0.995;
            return {row};
        });
    const Json m = metrics();
    EXPECT_EQ(m["errors"]["exchanged"], 3);
    EXPECT_EQ(m["errors"]["exchanged_though_sure"], 2);
}

TEST_F(EvaluateAppTest, ClutterAndItsProbability)
{
    writeTables(
        [](TrackRow row, int /*frame*/)
        {
            row.report.vehicleProbability = 0.9;
            TrackRow clutter = moved(row, 0.0, 7.0);
            clutter.report.id += 2;
            clutter.report.vehicleProbability = 0.2;
            return std::vector<TrackRow>{row, clutter};
        });
    const Json all = metrics();
    EXPECT_EQ(all["clear_mot"]["precision"], 0.5);
    EXPECT_EQ(all["clear_mot"]["false_alarms_per_frame"], 2.0);
    EXPECT_EQ(all["discriminator"]["area_under_curve"]["value"], 1.0);
    EXPECT_TRUE(all["discriminator"]["miss_rate_at_fpr_1e-2"]["value"].is_null());
    const Json vehicles = metrics("--vehicles-only");
    EXPECT_EQ(vehicles["clear_mot"]["precision"], 1.0);
    // The curve is that of all tracks.
    EXPECT_EQ(vehicles["discriminator"]["clutter_samples"], 40);
}

TEST_F(EvaluateAppTest, TheRegionLimitsWhatIsScored)
{
    writeTables(unchanged);
    // car1 is 10 m and more ahead of the sensor, car2 60 degrees and less to the left.
    EXPECT_EQ(metrics("--region-fov-deg 40")["scored"]["object_rows"], 20);
    EXPECT_EQ(metrics("--max-range-m 12")["scored"]["object_rows"], 5);
    EXPECT_EQ(metrics("--min-points 81")["scored"]["object_rows"], 0);
    EXPECT_EQ(metrics("--min-points 80")["scored"]["object_rows"], 40);
}

TEST_F(EvaluateAppTest, SaysWhereNothingIsScored)
{
    writeTables(unchanged);
    EXPECT_THAT(evaluate("--min-points 81").output,
                HasSubstr("truth.csv: nothing is scored: none of its 40 rows is of the classes "
                          "asked for, has at least 81 hits and lies in the region"));
    EXPECT_THAT(evaluate("--min-points 80").output, Not(HasSubstr("nothing is scored")));
}

TEST_F(EvaluateAppTest, ObjectsOfTheClassesAskedForCount)
{
    writeTables(unchanged);
    EXPECT_EQ(metrics("--classes Van,Car")["scored"]["object_rows"], 40);
    const Json riders = metrics("--classes Cyclist");
    EXPECT_EQ(riders["scored"]["object_rows"], 0);
    EXPECT_EQ(riders["scored"]["dont_care_rows"], 40);
    EXPECT_EQ(riders["options"]["classes"], Json({"Cyclist"}));
}

TEST_F(EvaluateAppTest, TentativeTracksCountWhenAsked)
{
    writeTables(
        [](TrackRow row, int frame)
        {
            if (frame < 10) row.report.status = TrackStatus::Tentative;
            return std::vector<TrackRow>{row};
        });
    EXPECT_EQ(metrics()["clear_mot"]["recall"], 0.5);
    EXPECT_EQ(metrics("--with-tentative")["clear_mot"]["recall"], 1.0);
}

TEST_F(EvaluateAppTest, TheStreetsTruthIsPerfect)
{
    std::string tracks = tracksHeader();
    std::map<std::string, std::uint64_t> ids;
    for (const TruthRow& truth : readTruth(VDAMF_SOURCE_DIR "/datasets/street/truth.csv"))
    {
        const auto id = ids.try_emplace(truth.objectId, ids.size() + 1).first->second;
        tracks += toCsv(FrameResult{truth.time, {trackOn(truth, id).report}, 0, 0, 0, {}});
    }
    make("tracks.csv", tracks);
    std::filesystem::copy_file(VDAMF_SOURCE_DIR "/datasets/street/truth.csv", at("truth.csv"));
    expectPerfect(metrics());
}

TEST_F(EvaluateAppTest, PrintsTablesAndWritesPictures)
{
    writeTables(unchanged);
    const Outcome run = evaluate("--objects --plots '" + at("p").string() + "'");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("HOTA        1.000  DetA        1.000"));
    EXPECT_THAT(run.output, HasSubstr("  car2            Car             20     20      1"));
    EXPECT_THAT(contentOf("p/position.svg"), HasSubstr("</svg>"));
    EXPECT_THAT(contentOf("p/consistency.svg"), HasSubstr("</svg>"));
    EXPECT_FALSE(std::filesystem::exists(at("p/roc.svg")));
    EXPECT_EQ(evaluate("--plots '" + at("all.svg").string() + "'").exitCode, 0);
    EXPECT_THAT(contentOf("all.svg"), HasSubstr(">Position<"));
}

TEST_F(EvaluateAppTest, ChartsOfAnEarlierRunDoNotStayBesideThoseOfThisOne)
{
    const std::string plots = "--overwrite --plots '" + at("p").string() + "'";
    writeTables(
        [](TrackRow row, int /*frame*/)
        {
            row.report.vehicleProbability = 0.9;
            TrackRow clutter = moved(row, 0.0, 7.0);
            clutter.report.id += 2;
            return std::vector<TrackRow>{row, clutter};
        });
    make("p/own.svg", "mine");
    EXPECT_EQ(evaluate(plots).exitCode, 0);
    EXPECT_TRUE(std::filesystem::exists(at("p/roc.svg")));
    writeTables(unchanged);
    EXPECT_EQ(evaluate(plots).exitCode, 0);
    EXPECT_FALSE(std::filesystem::exists(at("p/roc.svg")));
    EXPECT_FALSE(std::filesystem::exists(at("p/det.svg")));
    EXPECT_TRUE(std::filesystem::exists(at("p/position.svg")));
    EXPECT_EQ(contentOf("p/own.svg"), "mine");
}

TEST_F(EvaluateAppTest, LengthsOfNoVarianceAreInTheFirstGroup)
{
    writeTables(
        [](TrackRow row, int frame)
        {
            if (frame < 15) row.report.lengthVariance = 0.0;
            return std::vector<TrackRow>{std::move(row)};
        });
    const Json m = metrics();
    EXPECT_EQ(m["errors"]["pairs"], 40);
    EXPECT_EQ(m["errors_by_length_sigma_cm"]["0-25"]["pairs"], 40);
    EXPECT_EQ(m.dump().find(" inf "), std::string::npos);
    EXPECT_THAT(evaluate().output, HasSubstr("half of the errors or more have no covariance"));
}

TEST_F(EvaluateAppTest, NoTrackAtAllIsAResult)
{
    writeTables([](const TrackRow&, int) { return std::vector<TrackRow>(); });
    const Json m = metrics();
    EXPECT_EQ(m["clear_mot"]["recall"], 0.0);
    EXPECT_TRUE(m["clear_mot"]["precision"].is_null());
    EXPECT_TRUE(m["errors"]["position_m"]["median"].is_null());
    EXPECT_EQ(m["consistency"]["nees_pose"]["count"], 0);
}

TEST_F(EvaluateAppTest, TheLabelsOfARecordedDriveArePerfect)
{
    const char* data = std::getenv("VDAMF_DATA_DIR");
    if (data == nullptr) GTEST_SKIP() << "VDAMF_DATA_DIR is not set: no recordings to evaluate";
    const std::string drive = std::string(data) + "/2011_09_26/2011_09_26_drive_0005_sync";
    if (!std::filesystem::exists(drive)) GTEST_SKIP() << drive << " is absent";
    const Outcome imported = runApp("vdamf-import", "kitti-raw '" + drive + "' --gz-level 0 -o '" +
                                                        at("in.rawlog").string() + "' --truth '" +
                                                        at("truth.csv").string() + "'");
    ASSERT_EQ(imported.exitCode, 0) << imported.output;
    std::string tracks = tracksHeader();
    for (const TruthRow& truth : readTruth(at("truth.csv")))
    {
        const auto id = static_cast<std::uint64_t>(1 + std::stoi(truth.objectId));
        tracks += toCsv(FrameResult{truth.time, {trackOn(truth, id).report}, 0, 0, 0, {}});
    }
    make("tracks.csv", tracks);
    // The cyclist and the rest are don't care: tracks on them are no false alarms.
    expectPerfect(metrics());
    expectPerfect(metrics("--region-fov-deg 80 --max-range-m 60"));
}

}  // namespace
}  // namespace vdamf
