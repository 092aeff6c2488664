// SPDX-License-Identifier: BSD-3-Clause
// vdamf-train filter on simulated clusters and the shipped street, its filters in vdamf-track, and
// what both refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
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
namespace fs = std::filesystem;

const std::string kFew = " --global 2 --local 2 -q";

class TrainFilterApp : public TrainFixture
{
};

TEST_F(TrainFilterApp, MakesAFilterThatVdamfTrackTakes)
{
    make("sources.ini",
         "[simulated cars]\nkind = car\nclusters = 8\n"
         "[simulated other]\nkind = van\nclusters = 5\nseed = 2\nuse = test\n"
         "[recording street]\nrawlog = " +
             kStreetFolder + "street.rawlog\ntruth = " + kStreetFolder +
             "truth.csv\nmost_clusters = 20\n");
    const std::string command = "filter sources.ini -o filter.txt --folds 2 --held-out held.csv";
    ASSERT_EQ(run("vdamf-train", command + kFew), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("Cross-validation"));
    EXPECT_THAT(output_, HasSubstr("learned: better in"));
    CsvReader held(at("held.csv"), {"held_out", "condition", "filter", "heading_deg"});
    std::set<std::string> conditions;
    while (held.next())
        conditions.insert(held.text("held_out") + ' ' + held.text("condition") + ' ' +
                          held.text("filter"));
    EXPECT_EQ(conditions.count("fold cars car learned"), 1U);
    EXPECT_EQ(conditions.count("fold street cluster hand_set"), 1U);
    EXPECT_EQ(conditions.count("test other van learned"), 1U);

    const std::string filter = readTextFile(at("filter.txt"));
    EXPECT_EQ(run("vdamf-train", command + kFew), 1);
    EXPECT_THAT(output_, HasSubstr("--overwrite"));
    fs::remove(at("held.csv"));
    ASSERT_EQ(run("vdamf-train", command + kFew + " --overwrite"), 0) << output_;
    EXPECT_EQ(readTextFile(at("filter.txt")), filter);

    make("config.ini", "[measurement]\nfilter_file = filter.txt\n");
    const std::string track = "-i " + kStreetFolder + "street.rawlog --frames 0:10 -q --overwrite ";
    ASSERT_EQ(run("vdamf-track", track + "-c config.ini --tracks t.csv"), 0) << output_;
    // At the end of a line.
    make("filter.txt", filter.substr(0, filter.find('\n', filter.size() / 2) + 1));
    EXPECT_EQ(run("vdamf-track", track + "-c config.ini --tracks u.csv"), 2);
    EXPECT_THAT(output_, HasSubstr("filter.txt"));
    EXPECT_THAT(output_, HasSubstr("is the file whole?"));
    EXPECT_FALSE(fs::exists(at("u.csv")));
}

TEST_F(TrainFilterApp, TellsWhichTypesABankLeavesOut)
{
    make("sources.ini",
         "[simulated cars]\nkind = car\nclusters = 40\n"
         "[simulated vans]\nkind = van\nclusters = 39\n");
    const std::string command = "filter sources.ini --folds 0 --global 0 --local 0 -q -o ";
    ASSERT_EQ(run("vdamf-train", command + "bank.txt --bank"), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("--bank: types with fewer than 40 clusters have no filter of "
                                   "their own: van (39), truck (0), two_wheeler (0)\n"));
    EXPECT_THAT(contentOf("bank.txt"), HasSubstr("[filter car]"));
    ASSERT_EQ(run("vdamf-train", command + "common.txt"), 0) << output_;
    EXPECT_THAT(output_, testing::Not(HasSubstr("--bank")));
}

TEST_F(TrainFilterApp, RefusesSourcesThatItCannotLearnFrom)
{
    make("none.ini", "# nothing\n");
    EXPECT_EQ(run("vdamf-train", "filter none.ini -o f.txt" + kFew), 2);
    EXPECT_THAT(output_, HasSubstr("[recording NAME] or [simulated NAME]"));
    make("kind.ini", "[simulated a]\nkind = submarine\n");
    EXPECT_EQ(run("vdamf-train", "filter kind.ini -o f.txt" + kFew), 2);
    EXPECT_THAT(output_, HasSubstr("submarine"));
    make("test.ini", "[simulated a]\nkind = car\nclusters = 5\nuse = test\n");
    EXPECT_EQ(run("vdamf-train", "filter test.ini -o f.txt" + kFew), 1);
    EXPECT_THAT(output_, HasSubstr("all is for testing"));
    make("few.ini", "[simulated a]\nkind = car\nclusters = 3\n");
    EXPECT_EQ(run("vdamf-train", "filter few.ini -o f.txt --folds 5" + kFew), 1);
    EXPECT_THAT(output_, HasSubstr("too few vehicles"));
    EXPECT_EQ(run("vdamf-train", "filter few.ini -o f.txt --folds 1" + kFew), 2) << "0: none";
    EXPECT_FALSE(fs::exists(at("f.txt")));
}

}  // namespace
}  // namespace vdamf
