// SPDX-License-Identifier: BSD-3-Clause
// Which folder the names in configurations and on command lines count from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/train_fixture.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class NamedFiles : public TrainFixture
{
protected:
    void SetUp() override
    {
        const fs::path model = VDAMF_SOURCE_DIR "/models/vehicle.txt";
        fs::create_directory(at("folder"));
        fs::copy(model, at("m.txt"));
        fs::copy(model, at("folder/m.txt"));
        make("folder/plain.ini", "[clustering]\ngap_m = 0.4\n");
        make("folder/model.ini", "[discriminator]\nmodel = m.txt\n");
    }

    std::string modelOf(const std::string& arguments)
    {
        EXPECT_EQ(run("vdamf-track", "--print-config " + arguments + " | grep '^model ='"), 0);
        return output_;
    }

    std::string line(const std::string& name) { return "model = " + at(name).string() + "\n"; }
};

TEST_F(NamedFiles, OfTheCommandLineAreInTheCurrentFolder)
{
    const std::string set = " --set discriminator.model=m.txt";
    EXPECT_EQ(modelOf("-c folder/plain.ini" + set), line("m.txt"));
    EXPECT_EQ(modelOf("-c folder/model.ini" + set), line("m.txt"));
    fs::remove(at("m.txt"));
    EXPECT_EQ(run("vdamf-track", "--print-config -c folder/plain.ini" + set), 2);
    EXPECT_THAT(output_, HasSubstr("discriminator.model: " + at("m.txt").string()));
}

TEST_F(NamedFiles, OfAConfigurationAreInItsFolderWhereverItIsSaved)
{
    EXPECT_EQ(modelOf("-c folder/model.ini"), line("folder/m.txt"));
    ASSERT_EQ(run("vdamf-track", "--print-config -c folder/model.ini > saved.ini"), 0);
    EXPECT_EQ(modelOf("-c saved.ini"), line("folder/m.txt"));
    fs::create_directories(at("elsewhere/deep"));
    fs::create_directory_symlink(at("elsewhere/deep"), at("link"));
    fs::copy(at("m.txt"), at("elsewhere/m.txt"));
    make("link/above.ini", "[discriminator]\nmodel = ../m.txt\n");
    EXPECT_EQ(modelOf("-c link/above.ini"), line("elsewhere/m.txt"));
    fs::remove(at("folder/m.txt"));
    EXPECT_EQ(modelOf("-c folder/model.ini"), line("m.txt"));
}

TEST_F(NamedFiles, OfRecordingsAreInTheListsFolderOrTheCurrentOne)
{
    make("folder/list.ini", "[recording a]\nrawlog = a.rawlog\ntruth = a.csv\n");
    EXPECT_EQ(run("vdamf-train", "classifier folder/list.ini -o v.txt"), 1);
    EXPECT_THAT(output_, HasSubstr("recording a: folder/a.rawlog: cannot read"));
    EXPECT_EQ(run("vdamf-train",
                  "classifier folder/list.ini -o v.txt "
                  "--set 'recording a.rawlog=b.rawlog'"),
              1);
    EXPECT_THAT(output_, HasSubstr("recording a: b.rawlog: cannot read"));
}

TEST_F(NamedFiles, LimitsThatDoNotGoTogetherAreToldWithTheirPlaces)
{
    const std::string print = "--print-config -c folder/plain.ini ";
    EXPECT_EQ(run("vdamf-track", print + "--set clustering.gap_m=2 --set clustering.max_gap_m=1"),
              2);
    EXPECT_THAT(output_, AllOf(HasSubstr("vdamf-track: --set: clustering.gap_m = 2 must not be "
                                         "above clustering.max_gap_m = 1"),
                               Not(HasSubstr("plain.ini"))));
    EXPECT_EQ(run("vdamf-track", print + "--set clustering.max_gap_m=0.2"), 2);
    EXPECT_THAT(output_, HasSubstr("folder/plain.ini:2, --set: clustering.gap_m = 0.4 must not"));
    EXPECT_EQ(run("vdamf-track", "--print-config --set clustering.gap_m=2"), 2);
    EXPECT_THAT(output_, HasSubstr("--set, built-in configuration: clustering.gap_m = 2"));
}

}  // namespace
}  // namespace vdamf
