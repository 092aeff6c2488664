// SPDX-License-Identifier: BSD-3-Clause
// Reading tracklet_labels.xml, and errors with their line.
#include "vdamf/rawlog/kitti_tracklets.h"

#include <gmock/gmock.h>

#include "../files/temporary_folder.h"
#include "kitti_example_drive.h"
#include "replaced_text.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;

class KittiTrackletsTest : public TemporaryFolder
{
protected:
    std::string errorFor(const std::string& xml, std::size_t frames = 3)
    {
        const auto path = make("t.xml", xml);
        return errorOf([&] { readKittiTracklets(path, frames); });
    }
    std::string errorWith(const std::string& from, const std::string& to)
    {
        return errorFor(replaced(KittiExampleDrive::tracklets(), from, to));
    }
};

TEST_F(KittiTrackletsTest, ReadsSizesPosesAndFrames)
{
    const auto tracklets = readKittiTracklets(make("t.xml", KittiExampleDrive::tracklets()), 3);
    ASSERT_EQ(tracklets.size(), 2U);
    EXPECT_EQ(tracklets[0].objectClass, "Car");
    EXPECT_EQ(tracklets[0].height, 1.5);
    EXPECT_EQ(tracklets[0].width, 2.0);
    EXPECT_EQ(tracklets[0].length, 4.0);
    EXPECT_EQ(tracklets[0].firstFrame, 0U);
    ASSERT_EQ(tracklets[0].poses.size(), 3U);
    EXPECT_EQ(tracklets[0].poses[1].x, 19.0);
    EXPECT_EQ(tracklets[0].poses[1].y, 3.0);
    EXPECT_EQ(tracklets[0].poses[1].z, -1.75);
    EXPECT_NEAR(tracklets[0].poses[1].heading, 3.14159265, 1e-8);
    EXPECT_EQ(tracklets[1].objectClass, "Van");
    EXPECT_EQ(tracklets[1].firstFrame, 1U);
    EXPECT_EQ(tracklets[1].poses.size(), 2U);
}

TEST_F(KittiTrackletsTest, MapsTheClasses)
{
    const std::pair<const char*, const char*> names[] = {
        {"Truck", "Truck"},           {"Tram", "Tram"},
        {"Pedestrian", "Pedestrian"}, {"Person (sitting)", "Pedestrian"},
        {"Cyclist", "Cyclist"},       {"Misc", "Other"}};
    for (const auto& [kitti, ours] : names)
    {
        const std::string xml =
            replaced(KittiExampleDrive::tracklets(), ">Car<", ">" + std::string(kitti) + "<");
        EXPECT_EQ(readKittiTracklets(make("t.xml", xml), 3).at(0).objectClass, ours);
    }
}

TEST_F(KittiTrackletsTest, ErrorsNameTheLine)
{
    EXPECT_THAT(errorFor("<a>\n<b>\n</a>\n"), HasSubstr("t.xml:3: not valid XML"));
    EXPECT_THAT(errorFor(""), HasSubstr("t.xml:1: not valid XML"));
    EXPECT_THAT(errorFor("<html></html>"), HasSubstr("is it a tracklet file?"));
    EXPECT_THAT(errorWith(">Car<", ">Boat<"), HasSubstr("t.xml:8: unknown <objectType> 'Boat'"));
    EXPECT_THAT(errorWith("<h>1.5</h>", "<h>tall</h>"),
                HasSubstr("t.xml:9: <h>: expected a number, found 'tall'"));
    EXPECT_THAT(errorWith("<l>4</l>", "<l>0</l>"), HasSubstr("t.xml:11: <l>: expected a size"));
    EXPECT_THAT(errorWith("<w>2</w>", ""), HasSubstr("t.xml:7: <item> has no <w>"));
    EXPECT_THAT(errorWith("<first_frame>0", "<first_frame>-1"),
                HasSubstr("t.xml:12: <first_frame>: expected a whole number, found '-1'"));
    EXPECT_THAT(errorWith("<ty>3</ty>", ""), HasSubstr("t.xml:16: <item> has no <ty>"));
    EXPECT_THAT(errorWith("<rz>0</rz>", "<rz>nan</rz>"), HasSubstr("t.xml:31: <rz>"));
    EXPECT_THAT(errorWith("<count>2", "<count>3"),
                HasSubstr("t.xml:5: <count> is 3, but there are 2 <item>"));
    EXPECT_THAT(errorWith("<count>3", "<count>4"),
                HasSubstr("t.xml:14: <count> is 4, but there are 3 <item>"));
}

TEST_F(KittiTrackletsTest, NoTrackletReachesBeyondTheDrive)
{
    EXPECT_THAT(errorFor(KittiExampleDrive::tracklets(), 2),
                HasSubstr("t.xml:7: the 3 poses from frame 0 on reach beyond the drive's 2 scans"));
    EXPECT_THAT(errorWith("<first_frame>1", "<first_frame>9000000000000000000"),
                HasSubstr("reach beyond"));
}

}  // namespace
}  // namespace vdamf
