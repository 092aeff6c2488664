// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/annotation_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "vdamf/evaluation/tables.h"

namespace vdamf
{
namespace
{
TrackReport exampleTrack()
{
    TrackReport track;
    track.id = 123456;
    track.status = TrackStatus::Coasting;
    track.vehicleProbability = 0.75;
    track.forwardProbability = 0.25;
    track.axesProbability = 0.9375;
    track.box = {10.5, -20.25, 1.5, 4.5, 1.8};
    track.z = -0.5;
    track.height = 1.5;
    track.speed = -3.25;
    track.yawRate = 0.125;
    track.points = 321;
    track.match = 0.625;
    track.nis = 2.5;
    track.facesSeen.bits = 6;
    track.type = TypeProbability{VehicleType::Van, 0.8125};
    track.covariance(0, 0) = 0.25;
    track.covariance(0, 1) = track.covariance(1, 0) = 0.125;
    track.covariance(2, 2) = 0.01;
    track.covariance(3, 3) = 0.5;
    track.lengthVariance = 0.0625;
    track.measuredBox = OrientedBox{10.0, -20.0, 1.25, 4.0, 2.0};
    return track;
}

void expectSame(const TrackReport& a, const TrackReport& b)
{
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.vehicleProbability, b.vehicleProbability);
    EXPECT_EQ(a.nis, b.nis);
    EXPECT_EQ(a.facesSeen, b.facesSeen);
    EXPECT_EQ(a.covariance, b.covariance);
    EXPECT_EQ(a.measuredBox.has_value(), b.measuredBox.has_value());
    EXPECT_THAT(annotationRow(0.0, a),
                testing::Pointwise(testing::NanSensitiveDoubleEq(), annotationRow(0.0, b)));
}

TEST(AnnotationTable, ReadsBackWhatItWrote)
{
    TrackReport bare;
    bare.id = 1;
    std::vector<double> numbers = annotationRow(5.0, exampleTrack());
    ASSERT_EQ(numbers.size(), annotationColumns().size());
    for (const double value : annotationRow(5.0, bare)) numbers.push_back(value);
    const std::vector<TrackReport> read = tracksOf(annotationColumns(), numbers);
    ASSERT_EQ(read.size(), 2U);
    expectSame(read[0], exampleTrack());
    expectSame(read[1], bare);
    EXPECT_FALSE(read[1].measuredBox.has_value());
    EXPECT_FALSE(read[1].nis.has_value());
}

TEST(AnnotationTable, ReadsTablesWithoutMeasuredBoxesAndWithMore)
{
    std::vector<std::string> columns = trackColumns();
    std::vector<double> numbers = toNumbers(5.0, exampleTrack());
    columns.emplace_back("something_new");
    numbers.push_back(42.0);
    const std::vector<TrackReport> read = tracksOf(columns, numbers);
    ASSERT_EQ(read.size(), 1U);
    TrackReport expected = exampleTrack();
    expected.measuredBox.reset();
    expectSame(read[0], expected);
    EXPECT_TRUE(tracksOf(columns, {}).empty());
}

TEST(AnnotationTable, RefusesWhatMakesNoSense)
{
    const std::vector<double> row = annotationRow(5.0, exampleTrack());
    EXPECT_THROW(tracksOf({}, row), std::runtime_error);
    EXPECT_THROW(tracksOf(annotationColumns(), {1.0, 2.0}), std::runtime_error);
    const auto with = [&](const std::string& column, double value)
    {
        std::vector<double> changed = row;
        const auto& names = annotationColumns();
        const auto at = std::find(names.begin(), names.end(), column) - names.begin();
        changed[static_cast<std::size_t>(at)] = value;
        return changed;
    };
    for (const auto& [column, value] :
         {std::make_pair("status", 4.0), std::make_pair("status", 0.5),
          std::make_pair("track_id", -1.0), std::make_pair("track_id", std::nan("")),
          std::make_pair("x_m", std::nan(""))})
    {
        EXPECT_THROW(tracksOf(annotationColumns(), with(column, value)), std::runtime_error)
            << column << " " << value;
    }
    // Counts beyond what they can be are cut, and do not overflow.
    EXPECT_EQ(tracksOf(annotationColumns(), with("points", 1e300)).at(0).points, 2147483647);
    EXPECT_EQ(tracksOf(annotationColumns(), with("faces_seen", 99.0)).at(0).facesSeen.bits, 15);
}

}  // namespace
}  // namespace vdamf
