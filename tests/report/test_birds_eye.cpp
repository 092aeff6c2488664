// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/birds_eye.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
using testing::HasSubstr;
using testing::Not;

LadarFrame frameAt(double time)
{
    LadarFrame frame;
    frame.time = time;
    frame.origin = {5000.0, 200.0, 0.0};
    frame.sensor = {5000.0, 200.0, 1.8};
    frame.points.x = {10.0F, -10.0F, 500.0F};
    frame.points.y = {0.0F, 5.0F, 0.0F};
    frame.points.z = {0.0F, 1.0F, 0.0F};
    return frame;
}

TrackReport trackAt(double x, TrackStatus status)
{
    TrackReport track;
    track.id = 7;
    track.status = status;
    track.box = {x, 200.0, 0.0, 4.0, 2.0};
    track.speed = 8.0;
    return track;
}

std::size_t count(const std::string& text, const std::string& what)
{
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++n;
    return n;
}

TEST(BirdsEye, DrawsHitsBoxesAndTrails)
{
    BirdsEye picture;  // 100 m on 1200 pixels, the sensor in the middle at (600, 336)
    FrameResult result;
    result.time = 1.0;
    result.tracks = {trackAt(5020.0, TrackStatus::Confirmed)};
    picture.add(frameAt(1.0), result);
    result.time = 1.1;
    result.tracks = {trackAt(5020.8, TrackStatus::Confirmed)};
    picture.add(frameAt(1.1), result);
    const std::string svg = picture.svg();
    EXPECT_EQ(svg.rfind("<svg", 0), 0U);
    EXPECT_THAT(svg, HasSubstr("</svg>"));
    EXPECT_THAT(svg, HasSubstr("M720 336h0"));  // 10 m ahead is 120 pixels to the right
    EXPECT_THAT(svg, HasSubstr("M480 276h0"));  // 5 m to the north is 60 up
    EXPECT_EQ(count(svg, "h0"), 2U);            // the hit 500 m away is not in the picture
    EXPECT_EQ(count(svg, "<polygon"), 1U);
    EXPECT_THAT(svg, HasSubstr("825.6,324.0"));              // rear left corner of the second box
    EXPECT_THAT(svg, HasSubstr("840.0,336.0 849.6,336.0"));  // the trail
    EXPECT_THAT(svg, HasSubstr(">7 8.0 m/s<"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(BirdsEye, DrawsNothingBesideTheView)
{
    BirdsEye picture;
    FrameResult result;
    result.tracks = {trackAt(5051.0, TrackStatus::Confirmed)};  // over the right border
    picture.add(frameAt(1.0), result);
    const std::string svg = picture.svg();
    EXPECT_THAT(svg, HasSubstr("<clipPath id=\"view\"><rect width=\"1200\" height=\"672\"/>"));
    EXPECT_LT(svg.find("<g clip-path=\"url(#view)\">"), svg.find("<polygon"));
    EXPECT_EQ(svg.rfind("</g>\n</svg>\n"), svg.size() - 12);
}

TEST(BirdsEye, LeavesOutWhatIsNotPublished)
{
    BirdsEye picture;
    FrameResult result;
    result.tracks = {trackAt(5020.0, TrackStatus::Tentative)};
    picture.add(frameAt(0.0), result);
    EXPECT_EQ(count(picture.svg(), "<polygon"), 0U);
    result.tracks = {trackAt(5020.0, TrackStatus::Coasting)};
    picture.add(frameAt(0.1), result);
    EXPECT_THAT(picture.svg(), HasSubstr("stroke-dasharray"));
    EXPECT_EQ(count(BirdsEye().svg(), "<polygon"), 0U);
}

TEST(BirdsEye, KeepsClutterInTheBackground)
{
    BirdsEye picture;
    FrameResult result;
    result.tracks = {trackAt(5020.0, TrackStatus::Confirmed)};
    result.tracks[0].isVehicle = false;
    picture.add(frameAt(0.0), result);
    EXPECT_EQ(count(picture.svg(), "<polygon"), 1U);
    EXPECT_THAT(picture.svg(), Not(HasSubstr("m/s")));
    result.tracks[0].isVehicle = true;
    picture.add(frameAt(0.1), result);
    EXPECT_THAT(picture.svg(), HasSubstr(">7 8.0 m/s<"));
}

}  // namespace
}  // namespace vdamf
