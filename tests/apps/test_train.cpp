// SPDX-License-Identifier: BSD-3-Clause
// vdamf-train on the shipped street, its model in vdamf-track, and what both refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "apps/train_fixture.h"
#include "vdamf/files/csv.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Train : public TrainFixture
{
protected:
    void makeList(const std::string& more = "") const
    {
        make("list.ini", "[recording street]\nrawlog = " + kStreetFolder +
                             "street.rawlog\ntruth = " + kStreetFolder + "truth.csv\n" + more);
    }
};

TEST_F(Train, TellsHowAModelWithoutARecordingDoesThere)
{
    makeList("[recording again]\nrawlog = " + kStreetFolder +
             "street.rawlog\ntruth = " + kStreetFolder + "truth.csv\nscene = elsewhere\n");
    const std::string command = "classifier list.ini --folds 3 --cost 0.1 -q -o vehicle.txt ";
    ASSERT_EQ(run("vdamf-train", command + "--leave-out elsewhere"), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("Trained without elsewhere, tested on it"));
    EXPECT_EQ(run("vdamf-train", command + "--leave-out nowhere"), 2);
    EXPECT_THAT(output_, HasSubstr("--leave-out nowhere: no recording"));
    makeList();
    EXPECT_EQ(run("vdamf-train", command + "--overwrite --leave-out street"), 2);
    EXPECT_THAT(output_, HasSubstr("--leave-out street: no other recording to train on is left"));
}

TEST_F(Train, MakesAModelThatVdamfTrackTakes)
{
    makeList();
    const std::string command =
        "classifier list.ini --folds 3 --cost 0.1 -q -o vehicle.txt --plots plots "
        "--held-out held.csv";
    ASSERT_EQ(run("vdamf-train", command), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("single frames with 50 hits or more"));
    EXPECT_THAT(output_, HasSubstr("equal error rate"));
    for (const char* name : {"weights", "vehicles", "clutter", "roc", "det", "reliability"})
        EXPECT_TRUE(fs::exists(at("plots/" + std::string(name) + ".svg"))) << name;
    CsvReader held(at("held.csv"), {"recording", "track_id", "vehicle", "frame_probability"});
    std::set<std::int64_t> kinds;
    while (held.next()) kinds.insert(held.integer("vehicle"));
    EXPECT_EQ(kinds.size(), 2U);

    const std::string model = readTextFile(at("vehicle.txt"));
    EXPECT_EQ(run("vdamf-train", command), 1);
    EXPECT_THAT(output_, HasSubstr("--overwrite"));
    ASSERT_EQ(run("vdamf-train", command + " --overwrite"), 0) << output_;
    EXPECT_EQ(readTextFile(at("vehicle.txt")), model);

    // The configuration's folder is where its model is looked for.
    fs::create_directories(at("other"));
    fs::rename(at("vehicle.txt"), at("other/vehicle.txt"));
    make("other/config.ini", "[discriminator]\nmodel = vehicle.txt\nmin_probability = 0.9\n");
    const std::string track = "-i " + kStreetFolder + "street.rawlog --frames 0:20 -q --overwrite ";
    ASSERT_EQ(run("vdamf-track", track + "-c other/config.ini --tracks t.csv"), 0) << output_;
    CsvReader tracks(at("t.csv"), {"vehicle_probability", "is_vehicle"});
    int vehicles = 0;
    while (tracks.next())
    {
        const double probability = tracks.number("vehicle_probability");
        EXPECT_EQ(tracks.integer("is_vehicle"), probability >= 0.9 ? 1 : 0) << probability;
        vehicles += probability >= 0.9 ? 1 : 0;
    }
    EXPECT_GT(vehicles, 20);
}

TEST_F(Train, CalibratesForTheShareOfVehiclesThatIsAskedFor)
{
    makeList();
    const std::string command = "classifier list.ini --folds 3 --cost 0.1 -q -o vehicle.txt ";
    ASSERT_EQ(run("vdamf-train", command + "--vehicle-share 0.1"), 0) << output_;
    EXPECT_THAT(readTextFile(at("vehicle.txt")), HasSubstr("vehicle share 0.1\n"));
    for (const char* share : {"0", "1", "-0.5", "many", "nan", "inf"})
    {
        EXPECT_EQ(run("vdamf-train", command + "--overwrite --vehicle-share " + share), 2);
        EXPECT_THAT(output_, HasSubstr("--vehicle-share"));
    }
}

TEST_F(Train, RefusesNumbersOutOfTheirRange)
{
    makeList();
    for (const std::string cost : {"nan", "inf", "-1", "0", "1e7", "0.1 nan"})
    {
        // The limit ends a training that does not.
        EXPECT_EQ(runShell("cd '" + at("").string() +
                           "' && timeout -s KILL 60 '" VDAMF_APPS_DIR
                           "/vdamf-train' classifier list.ini -q -o m.txt --cost " +
                           cost)
                      .exitCode,
                  2)
            << cost;
    }
    for (const std::string option :
         {"--cost nan", "--folds nan", "--folds 1", "--frames-per-track nan", "--threads nan",
          "--threads 65", "--seed nan", "--seed -1"})
    {
        EXPECT_EQ(run("vdamf-train", "classifier list.ini -q -o m.txt " + option), 2) << option;
        EXPECT_THAT(output_, HasSubstr(option.substr(0, option.find(' '))));
    }
    for (const std::string option :
         {"--global nan", "--local -1", "--folds inf", "--folds 51", "--seed inf"})
    {
        EXPECT_EQ(run("vdamf-train", "filter list.ini -q -o m.txt " + option), 2) << option;
        EXPECT_THAT(output_, HasSubstr(option.substr(0, option.find(' '))));
    }
    EXPECT_FALSE(fs::exists(at("m.txt")));
}

TEST_F(Train, WithoutADiscriminatorTracksHaveNoProbability)
{
    ASSERT_EQ(
        run("vdamf-track", "-i " + kStreetFolder + "street.rawlog --frames 0:5 -q --tracks t.csv " +
                               "--set discriminator.model=none"),
        0)
        << output_;
    CsvReader tracks(at("t.csv"), {"vehicle_probability"});
    int rows = 0;
    for (; tracks.next(); ++rows)
        EXPECT_FALSE(tracks.optionalNumber("vehicle_probability").has_value());
    EXPECT_GT(rows, 0);
}

TEST_F(Train, BadModelsAreRefusedBeforeTheFirstFrame)
{
    const std::string good = readTextFile(VDAMF_SOURCE_DIR "/models/vehicle.txt");
    const auto errorWith = [&](const std::string& text)
    {
        make("bad.txt", text);
        EXPECT_EQ(run("vdamf-track", "-i " + kStreetFolder +
                                         "street.rawlog --tracks t.csv "
                                         "--set discriminator.model=bad.txt"),
                  2)
            << output_;
        EXPECT_FALSE(fs::exists(at("t.csv")));
        return output_;
    };
    EXPECT_THAT(errorWith(good.substr(0, good.size() / 2)), HasSubstr("bad.txt:"));
    EXPECT_THAT(errorWith("vdamf discriminator 9\n"), HasSubstr("another version"));
    EXPECT_THAT(errorWith(""), HasSubstr("bad.txt:1:"));
    EXPECT_EQ(run("vdamf-track", "-i " + kStreetFolder +
                                     "street.rawlog --tracks t.csv "
                                     "--set discriminator.model=missing.txt"),
              2);
    EXPECT_THAT(output_, HasSubstr("missing.txt"));
}

TEST_F(Train, BadListsAreErrorsWithTheirPlace)
{
    const auto errorOf = [&](const std::string& text)
    {
        make("list.ini", text);
        EXPECT_EQ(run("vdamf-train", "classifier list.ini -o m.txt"), 2) << output_;
        return output_;
    };
    EXPECT_THAT(errorOf(""), HasSubstr("[recording NAME]"));
    EXPECT_THAT(errorOf("[recording a]\nrawlog = a.rawlog\n"), HasSubstr("names no truth"));
    EXPECT_THAT(errorOf("[recording a]\nrawlog = a\ntruth = b\nregion_fov = 3\n"),
                HasSubstr("region_fov_deg"));
    EXPECT_THAT(errorOf("[recordings a]\nrawlog = a\ntruth = b\n"), HasSubstr("recordings a"));
    EXPECT_EQ(run("vdamf-train", ""), 2);
    EXPECT_EQ(run("vdamf-train", "classifier missing.ini -o m.txt"), 2);
}

TEST_F(Train, NothingThatTheConfigurationNamesIsWrittenOver)
{
    makeList();
    const std::string model = VDAMF_SOURCE_DIR "/models/vehicle.txt";
    fs::copy_file(model, at("vehicle.txt"));
    make("c.ini", "[discriminator]\nmodel = vehicle.txt\n");
    for (const std::string what : {"classifier", "filter"})
    {
        EXPECT_EQ(run("vdamf-train", what + " list.ini -c c.ini -o vehicle.txt --overwrite -q"), 2);
        EXPECT_THAT(output_, HasSubstr("vehicle.txt: is discriminator.model"));
    }
    EXPECT_EQ(readTextFile(at("vehicle.txt")), readTextFile(model));
}

TEST_F(Train, NeedsEnoughGroups)
{
    makeList("scene = one\n");
    EXPECT_EQ(run("vdamf-train", "classifier list.ini -q -o m.txt"), 1);
    EXPECT_THAT(output_, HasSubstr("groups"));
    EXPECT_FALSE(fs::exists(at("m.txt")));
    make("list.ini",
         "[recording a]\nrawlog = missing.rawlog\ntruth = " + kStreetFolder + "truth.csv\n");
    EXPECT_EQ(run("vdamf-train", "classifier list.ini -q -o m.txt"), 1);
    EXPECT_THAT(output_, HasSubstr("missing.rawlog"));
}

TEST_F(Train, RefusesARawlogThatEndsEarly)
{
    const std::string rawlog = readTextFile(kStreetFolder + "street.rawlog");
    make("cut.rawlog", rawlog.substr(0, rawlog.size() / 20));
    make("list.ini",
         "[recording cut]\nrawlog = cut.rawlog\ntruth = " + kStreetFolder + "truth.csv\n");
    for (const std::string what : {"classifier", "filter"})
    {
        EXPECT_EQ(run("vdamf-train", what + " list.ini -q -o m.txt"), 1);
        EXPECT_THAT(output_, HasSubstr("recording cut: "));
        EXPECT_THAT(output_, HasSubstr("cut.rawlog: truncated: "));
    }
    EXPECT_FALSE(fs::exists(at("m.txt")));
}

TEST_F(Train, WhatCannotBeReadOrWrittenIsToldBeforeTheWork)
{
    const auto errorOf = [&](const std::string& more, const std::string& options = "")
    {
        // Progress, which is not quiet, begins with the first recording that was worked on.
        makeList(more);
        EXPECT_EQ(run("vdamf-train", "classifier list.ini -o m.txt" + options), 1) << output_;
        EXPECT_THAT(output_, Not(HasSubstr("vehicle tracks")));
        EXPECT_FALSE(fs::exists(at("m.txt")));
        return output_;
    };
    const std::string second =
        "[recording second]\nrawlog = " + kStreetFolder + "street.rawlog\ntruth = ";
    EXPECT_THAT(errorOf(second + "none.csv\n"), HasSubstr("recording second: "));
    EXPECT_THAT(output_, HasSubstr("none.csv: cannot read"));
    const std::string truth = readTextFile(kStreetFolder + "truth.csv");
    make("empty.csv", truth.substr(0, truth.find('\n') + 1));
    EXPECT_THAT(errorOf(second + "empty.csv\n"), HasSubstr("empty.csv: has no rows"));
    make("held.csv", "mine");
    EXPECT_THAT(errorOf("", " --held-out held.csv"), HasSubstr("held.csv: exists already"));
    EXPECT_EQ(readTextFile(at("held.csv")), "mine");
    fs::create_directories(at("plots"));
    make("plots/roc.svg", "mine");
    EXPECT_THAT(errorOf("", " --plots plots"), HasSubstr("roc.svg: exists already"));
    EXPECT_EQ(std::distance(fs::directory_iterator(at("plots")), {}), 1);
}

TEST_F(Train, TruthOfOtherTimesIsNamedWithItsRawlog)
{
    std::string truth = readTextFile(kStreetFolder + "truth.csv");
    for (std::size_t at = 0; (at = truth.find("\n17000", at)) != std::string::npos; ++at)
        truth.replace(at, 6, "\n16000");
    make("shifted.csv", truth);
    make("list.ini",
         "[recording other]\nrawlog = " + kStreetFolder + "street.rawlog\ntruth = shifted.csv\n");
    EXPECT_EQ(run("vdamf-train", "classifier list.ini -o m.txt -q"), 1) << output_;
    EXPECT_THAT(output_, HasSubstr("recording other: truth shifted.csv, tracks " + kStreetFolder +
                                   "street.rawlog: no frame of the truth"));
}
}  // namespace
}  // namespace vdamf
