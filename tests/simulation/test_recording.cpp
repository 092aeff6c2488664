// SPDX-License-Identifier: BSD-3-Clause
// Recorded traffic: tables in, a scene with smooth motion out.
#include "vdamf/simulation/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "files/temporary_folder.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/simulation/scenario.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

constexpr const char* kEgoHeader = "timestamp_ns,qw,qx,qy,qz,tx_m,ty_m,tz_m\n";
constexpr const char* kLabelHeader =
    "timestamp_ns,track_uuid,category,length_m,width_m,height_m,qw,qx,qy,qz,tx_m,ty_m,tz_m\n";

void write(const std::filesystem::path& path, const std::string& text)
{
    std::ofstream(path) << text;
}

/// The ego drives north at 10 m/s from (5000, 2000) in the city; a car 20 m ahead at the same
/// speed, a parked van 8 m to the left of where the ego is after 1 s, and a cone seen once.
void writeLog(const std::filesystem::path& folder)
{
    std::string ego = kEgoHeader;
    std::string labels = kLabelHeader;
    for (int i = 0; i <= 20; ++i)
    {
        const std::string time = std::to_string(1000000000 + 100000000LL * i);
        const double y = 2000.0 + i;
        ego += time + ",0.70710678,0,0,0.70710678,5000," + std::to_string(y) + ",60\n";
        labels += time + ",ahead,REGULAR_VEHICLE,4.5,1.8,1.5,1,0,0,0,20,0,0.7\n";
        labels += time + ",parked,REGULAR_VEHICLE,5.8,2,2.2,0,0,0,1," + std::to_string(10.0 - i) +
                  ",8,1\n";
        labels += time + ",self,EGO_VEHICLE,4.9,1.9,1.5,1,0,0,0,1.4,0,0.7\n";
    }
    labels += "3000000000,once,CONSTRUCTION_CONE,0.4,0.4,0.9,1,0,0,0,5,2,0.4\n";
    write(folder / "city_SE3_egovehicle.csv", ego);
    write(folder / "annotations.csv", labels);
}

class ArgoverseLog : public TemporaryFolder
{
};

TEST_F(ArgoverseLog, PutsBoxesIntoTheSceneFrame)
{
    writeLog(at(""));
    const Recording recording = readArgoverseLog(at(""));
    ASSERT_EQ(recording.platform.size(), 21U);
    EXPECT_NEAR(recording.platform[10].time, 1.0, 1e-9);
    EXPECT_NEAR(recording.platform[10].y, 10.0, 1e-6);
    EXPECT_NEAR(recording.platform[10].heading, 0.5 * kPi, 1e-6);
    ASSERT_EQ(recording.objects.size(), 3U);
    const LabelledObject& ahead = recording.objects[0];
    EXPECT_EQ(ahead.name, "ahead");
    EXPECT_EQ(ahead.objectClass, ObjectClass::Car);
    EXPECT_NEAR(ahead.poses[5].x, 0.0, 1e-6);
    EXPECT_NEAR(ahead.poses[5].y, 25.0, 1e-6);
    const LabelledObject& parked = recording.objects[1];
    EXPECT_EQ(parked.objectClass, ObjectClass::Van);
    EXPECT_NEAR(parked.poses[20].x, -8.0, 1e-5);
    EXPECT_NEAR(parked.poses[20].y, 10.0, 1e-5);
    EXPECT_NEAR(wrapAngle(parked.poses[3].heading + 0.5 * kPi), 0.0, 1e-6);
}

TEST_F(ArgoverseLog, ErrorsNameFileLineAndColumn)
{
    writeLog(at(""));
    std::ofstream(at("annotations.csv"), std::ios::app)
        << "9000000000,late,BUS,12,2.5,3,1,0,0,0,5,2,1\n";
    try
    {
        readArgoverseLog(at(""));
        FAIL();
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("annotations.csv:66"));
        EXPECT_THAT(error.what(), HasSubstr("no poses around this time"));
    }
    EXPECT_THROW(readArgoverseLog(at("missing")), std::runtime_error);
}

TEST_F(ArgoverseLog, ATimeThatNoSceneReachesIsNamed)
{
    for (const std::string wrong : {"9000000000000", "9000000000000000000", "-9000000000000000000"})
    {
        writeLog(at(""));
        std::string poses = contentOf("city_SE3_egovehicle.csv");
        const std::string right = "1100000000";
        write(at("city_SE3_egovehicle.csv"), poses.replace(poses.find(right), right.size(), wrong));
        EXPECT_THAT(errorOf([&] { readArgoverseLog(at("")); }),
                    HasSubstr("city_SE3_egovehicle.csv:3: column 'timestamp_ns': " + wrong + ": "));
    }
}

TEST_F(ArgoverseLog, WithoutLabelsIsNamed)
{
    writeLog(at(""));
    write(at("annotations.csv"), kLabelHeader);
    EXPECT_THAT(errorOf([&] { readArgoverseLog(at("")); }),
                HasSubstr("annotations.csv: holds no label"));
}

Scenario scenarioIn(const std::filesystem::path& folder, const std::string& text)
{
    return readScenario(IniDocument::parse(text, (folder / "scenario.ini").string()));
}

std::string errorIn(const std::filesystem::path& folder, const std::string& text)
{
    try
    {
        scenarioIn(folder, text);
    }
    catch (const IniError& error)
    {
        return error.what();
    }
    return "no error";
}

class Traffic : public TemporaryFolder
{
};

TEST_F(Traffic, ALogDrivesObjectsAndPlatform)
{
    writeLog(at(""));
    const Scenario scenario =
        scenarioIn(at(""), "[scenario]\nduration_s = 3\n[traffic]\nargoverse_log = .\n");
    ASSERT_EQ(scenario.scene.objects.size(), 2U);  // the cone is seen too rarely
    EXPECT_NEAR(scenario.scene.platform.at(1.0).y, 10.0, 1e-4);
    EXPECT_NEAR(scenario.scene.platform.at(1.0).speed, 10.0, 1e-3);
    const OrientedBox ahead = boxAt(scenario.scene.objects[0], 1.0);
    EXPECT_NEAR(ahead.y, 30.0, 1e-3);
    EXPECT_EQ(scenario.scene.objects[1].trajectory.at(1.2).speed, 0.0);
    EXPECT_EQ(simulateFrame(scenario, 10).truth.size(), 2U);
    EXPECT_TRUE(simulateFrame(scenario, 21).truth.empty());  // behind the last label
}

TEST_F(Traffic, ATruthTableGivesTheSameMotionBack)
{
    const Scenario source = scenarioIn(
        at(""),
        "[scenario]\nduration_s = 6\n[platform]\nx_m = 3\nspeed_mps = 8\n[object bend]\nclass = "
        "van\nx_m = 30\ny_m = 4\nheading_deg = 180\nspeed_mps = 7\nsegments = keep 1, turn 60 "
        "20\n[object parked]\nclass = car\nx_m = 20\ny_m = -4\n");
    std::string table = truthHeader();
    for (int i = 0; i < source.frames(); ++i)
    {
        for (const TruthRow& row : simulateFrame(source, i).truth) table += toCsv(row);
    }
    write(at("truth.csv"), table);
    const Scenario again = scenarioIn(at(""), "[traffic]\ntable = truth.csv\n");
    ASSERT_EQ(again.scene.objects.size(), 2U);
    EXPECT_EQ(again.scene.objects[0].objectClass, ObjectClass::Van);
    for (const double time : {0.5, 2.0, 4.1})
    {
        const OrientedBox expected = boxAt(source.scene.objects[0], time);
        const OrientedBox box = boxAt(again.scene.objects[0], time);
        EXPECT_NEAR(box.x, expected.x - 3.0, 0.1);  // its frame begins at the first pose
        EXPECT_NEAR(box.y, expected.y, 0.1);
        EXPECT_NEAR(wrapAngle(box.heading - expected.heading), 0.0, 0.02);
        EXPECT_NEAR(again.scene.platform.at(time).speed, 8.0, 0.05);
    }
    EXPECT_EQ(again.scene.objects[1].trajectory.at(3.0).speed, 0.0);
}

TEST_F(Traffic, ATimeThatNoSceneReachesIsNamed)
{
    TruthRow row{100.0, "a", "Car", {0.0, 0.0, 0.0, 4.5, 1.8}, 0.0, 1.5, 0.0, -1, std::nullopt};
    std::string table = truthHeader();
    for (int i = 0; i < 6; ++i, row.time += 1.0) table += toCsv(row);
    row.time = 100.0 + 3600.0;
    write(at("hour.csv"), table + toCsv(row));
    EXPECT_EQ(errorIn(at(""), "[traffic]\ntable = hour.csv\n"), "no error");
    row.time = 1701000000.0;
    write(at("truth.csv"), table + toCsv(row));
    EXPECT_THAT(
        errorIn(at(""), "[traffic]\ntable = truth.csv\n"),
        HasSubstr("truth.csv: time_s 1701000000.000000: it is 1700999900.0 s from the first"));
}

TEST_F(Traffic, MistakesAreNamed)
{
    writeLog(at(""));
    EXPECT_THAT(errorIn(at(""), "[traffic]\nargoverse_log = elsewhere\n"),
                HasSubstr("scenario.ini:2: traffic.argoverse_log"));
    EXPECT_THAT(errorIn(at(""), "[traffic]\nargoverse_log = .\n[platform]\nx_m = 1\n"),
                HasSubstr("remove the section [platform]"));
    EXPECT_THAT(errorIn(at(""), "[traffic]\nargoverse_log = .\ntable = t.csv\n"),
                HasSubstr("cannot be given together"));
    EXPECT_THAT(errorIn(at(""), "[traffic]\nargoverse_log = .\n[object ahead]\nx_m = 60\n"),
                HasSubstr("another object ahead"));
}

TEST(Towing, MistakesAreNamed)
{
    EXPECT_THAT(errorIn("", "[object t]\nclass = trailer\ntowed_by = truck\n"),
                HasSubstr("stands above in the file"));
    EXPECT_THAT(errorIn("",
                        "[object truck]\nclass = truck\n[object t]\nclass = trailer\n"
                        "towed_by = truck\nspeed_mps = 3\n"),
                HasSubstr("scenario.ini:6: object t.speed_mps: follows from what tows it"));
}

TEST(Towing, ATrailerHangsBehindItsTruck)
{
    const Scenario scenario =
        scenarioIn("",
                   "[object truck]\nclass = truck\nx_m = 40\nspeed_mps = 5\nsegments = turn 90 20\n"
                   "[object t]\nclass = trailer\ntowed_by = truck\ndrawbar_m = 2\n");
    const OrientedBox truck = boxAt(scenario.scene.objects[0], 0.0);
    const OrientedBox trailer = boxAt(scenario.scene.objects[1], 0.0);
    EXPECT_NEAR(truck.x - trailer.x, 0.5 * truck.length + 2.0 + 0.5 * trailer.length, 1e-9);
    EXPECT_STREQ(*truthClass(scenario.scene.objects[1].objectClass), "Truck");
}

std::vector<std::filesystem::path> recordedLogs()
{
    const char* const root = std::getenv("VDAMF_DATA_DIR");
    std::vector<std::filesystem::path> logs;
    if (root == nullptr) return logs;
    const std::filesystem::path folder = std::filesystem::path(root) / "av2_samples";
    if (!std::filesystem::is_directory(folder)) return logs;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        if (std::filesystem::exists(entry.path() / "annotations.csv")) logs.push_back(entry.path());
    }
    return logs;
}

/// Largest distance of the smoothed motion from the labels, and the root mean square.
std::pair<double, double> residuals(const LabelledObject& labels, const SceneObject& object)
{
    double sum = 0.0;
    double largest = 0.0;
    for (const LabelledPose& pose : labels.poses)
    {
        const OrientedBox box = boxAt(object, pose.time);
        const double distance = std::hypot(box.x - pose.x, box.y - pose.y);
        sum += distance * distance;
        largest = std::max(largest, distance);
    }
    return {std::sqrt(sum / static_cast<double>(labels.poses.size())), largest};
}

TEST(RecordedLogs, MotionIsSane)
{
    const auto logs = recordedLogs();
    if (logs.empty()) GTEST_SKIP() << "VDAMF_DATA_DIR has no av2_samples";
    for (const auto& log : logs)
    {
        const Scenario scenario = readScenario(IniDocument::parse(
            "[scenario]\nduration_s = 15\n[traffic]\nargoverse_log = " + log.string() + "\n",
            "scenario.ini"));
        std::map<std::string, LabelledObject> labels;
        for (const LabelledObject& one : readArgoverseLog(log).objects) labels[one.name] = one;
        int standing = 0;
        int moving = 0;
        for (const SceneObject& object : scenario.scene.objects)
        {
            if (!isVehicle(object.objectClass)) continue;
            double fastest = 0.0;
            for (double time = object.appears; time <= object.vanishes; time += 0.05)
            {
                const MotionState state = object.trajectory.at(time);
                fastest = std::max(fastest, std::abs(state.speed));
                EXPECT_LE(std::abs(state.yawRate), 1.2) << log << " " << object.name << " " << time;
            }
            EXPECT_LE(fastest, 30.0) << object.name;
            ++(fastest == 0.0 ? standing : moving);
            const auto [rms, largest] = residuals(labels.at(object.name), object);
            EXPECT_LE(rms, 0.6) << log << " " << object.name << " fastest " << fastest;
            EXPECT_LE(largest, 1.1) << log << " " << object.name << " fastest " << fastest;
        }
        EXPECT_GT(standing, 5) << log;
        EXPECT_GT(moving, 2) << log;
        EXPECT_GT(simulateFrame(scenario, 50).truth.size(), 20U);
    }
}
}  // namespace
}  // namespace vdamf
