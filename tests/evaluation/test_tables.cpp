// SPDX-License-Identifier: BSD-3-Clause
// truth.csv and tracks.csv: exact columns and round trips.
#include "vdamf/evaluation/tables.h"

#include <random>

#include "table_texts.h"

namespace vdamf
{
namespace
{
TrackReport randomReport(std::mt19937_64& random, std::uint64_t id)
{
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    TrackReport report;
    report.id = id;
    report.status = static_cast<TrackStatus>(id % 4);
    if (id % 3 != 0) report.vehicleProbability = 0.5 + 0.5 * any(random);
    report.box = {500 * any(random), 500 * any(random), 3 * any(random), 5 + any(random), 2.0};
    report.z = any(random);
    report.height = 1.5 + any(random);
    report.speed = 20 * any(random);
    report.yawRate = any(random);
    report.points = static_cast<int>(100 * id);
    report.match = 2 + any(random);
    if (id % 2 != 0) report.nis = 3 + any(random);
    report.facesSeen.bits = static_cast<std::uint8_t>(id % 16);
    const Eigen::Matrix4d root = Eigen::Matrix4d::NullaryExpr([&] { return any(random); });
    report.covariance = 1e-3 * root * root.transpose();
    report.covariance.topRightCorner<3, 1>().setZero();
    report.covariance.bottomLeftCorner<1, 3>().setZero();
    report.lengthVariance = 0.25 + 0.1 * any(random);
    report.widthVariance = 0.04;
    report.forwardProbability = 0.5 + 0.1 * any(random);
    report.axesProbability = 0.5 - 0.1 * any(random);
    if (id % 3 == 0) report.type = TypeProbability{VehicleType::Van, 0.625};
    return report;
}

void expectSame(const TrackReport& a, const TrackReport& b)
{
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.vehicleProbability.has_value(), b.vehicleProbability.has_value());
    EXPECT_NEAR(a.vehicleProbability.value_or(0), b.vehicleProbability.value_or(0), 1e-6);
    EXPECT_LT((a.box.centre() - b.box.centre()).norm(), 1e-4);
    EXPECT_NEAR(a.box.heading, b.box.heading, 1e-6);
    EXPECT_NEAR(a.box.length, b.box.length, 1e-4);
    EXPECT_NEAR(a.box.width, b.box.width, 1e-4);
    EXPECT_NEAR(a.z, b.z, 1e-4);
    EXPECT_NEAR(a.height, b.height, 1e-4);
    EXPECT_NEAR(a.speed, b.speed, 1e-4);
    EXPECT_NEAR(a.yawRate, b.yawRate, 1e-6);
    EXPECT_EQ(a.points, b.points);
    EXPECT_NEAR(a.match, b.match, 1e-6);
    EXPECT_EQ(a.nis.has_value(), b.nis.has_value());
    EXPECT_NEAR(a.nis.value_or(0), b.nis.value_or(0), 1e-6);
    EXPECT_EQ(a.facesSeen, b.facesSeen);
    EXPECT_LT((a.covariance - b.covariance).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(a.lengthVariance, b.lengthVariance, 1e-7);
    EXPECT_NEAR(a.widthVariance, b.widthVariance, 1e-7);
    EXPECT_NEAR(a.forwardProbability, b.forwardProbability, 1e-6);
    EXPECT_NEAR(a.axesProbability, b.axesProbability, 1e-6);
    EXPECT_EQ(a.type.has_value(), b.type.has_value());
    EXPECT_EQ(a.type.value_or(TypeProbability()).type, b.type.value_or(TypeProbability()).type);
}

TEST_F(TablesTest, HeadersAreTheContract)
{
    EXPECT_EQ(truthHeader(), kTruthHeader);
    EXPECT_EQ(tracksHeader(), kTracksHeader);
}

TEST_F(TablesTest, LinesAreTheContract)
{
    const TruthRow row = {
        1317042145.9639999,      "3", "Van", {12.5, -3.25, 1.5, 5.0, 2.0}, -1.0, 2.25, -0.00001, 42,
        PlanePose{1.0, 2.0, 0.5}};
    EXPECT_EQ(toCsv(row),
              "1317042145.964000,3,Van,12.5000,-3.2500,-1.0000,1.500000,5.0000,2.0000,2.2500,"
              "0.0000,42,1.0000,2.0000,0.500000\n");
    const std::vector<TrackRow> rows =
        readTracks(make("t.csv", std::string(kTracksHeader) + kTrackLine));
    ASSERT_EQ(rows.size(), 1U);
    FrameResult frame;
    frame.time = rows[0].time;
    frame.tracks = {rows[0].report};
    EXPECT_EQ(toCsv(frame), kTrackLine);
}

TEST_F(TablesTest, TruthRoundTrip)
{
    std::string text = truthHeader();
    std::vector<TruthRow> rows;
    for (const std::string& name : truthClasses())
    {
        const double n = static_cast<double>(rows.size());
        rows.push_back({1.3e9 + 0.1 * n,
                        "id " + name,
                        name,
                        {n / 3, -n / 7, n / 9, 4 + n, 2},
                        n,
                        1.5,
                        n / 11,
                        static_cast<int>(rows.size()) - 1,
                        n > 3 ? std::optional<PlanePose>({n, -n, 0.1 * n}) : std::nullopt});
        text += toCsv(rows.back());
    }
    const std::vector<TruthRow> back = readTruth(make("truth.csv", text));
    ASSERT_EQ(back.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        EXPECT_NEAR(back[i].time, rows[i].time, 1e-6);
        EXPECT_EQ(back[i].objectId, rows[i].objectId);
        EXPECT_EQ(back[i].objectClass, rows[i].objectClass);
        EXPECT_LT((back[i].box.centre() - rows[i].box.centre()).norm(), 1e-4);
        EXPECT_NEAR(back[i].box.heading, rows[i].box.heading, 1e-6);
        EXPECT_NEAR(back[i].box.length, rows[i].box.length, 1e-4);
        EXPECT_NEAR(back[i].speed, rows[i].speed, 1e-4);
        EXPECT_EQ(back[i].points, rows[i].points);
        ASSERT_EQ(back[i].sensor.has_value(), rows[i].sensor.has_value());
        if (rows[i].sensor)
        {
            EXPECT_NEAR(back[i].sensor->y, rows[i].sensor->y, 1e-4);
            EXPECT_NEAR(back[i].sensor->heading, rows[i].sensor->heading, 1e-6);
        }
    }
}

TEST_F(TablesTest, ATruthTableMayLackTheSensor)
{
    const std::string row = "1.5,a,Car,1,2,0,0,4,2,1.5,0,7";
    const auto path = make("truth.csv", std::string(kHeaderWithoutSensor) + row + '\n');
    ASSERT_EQ(readTruth(path).size(), 1U);
    EXPECT_FALSE(readTruth(path)[0].sensor);
}

TEST_F(TablesTest, TracksRoundTrip)
{
    std::mt19937_64 random(5);
    std::string text = tracksHeader();
    std::vector<FrameResult> frames(5);
    for (std::size_t f = 0; f < frames.size(); ++f)
    {
        frames[f].time = 1.3e9 + 0.1 * static_cast<double>(f);
        for (std::uint64_t id = 1; id <= 16; ++id)
        {
            frames[f].tracks.push_back(randomReport(random, id));
        }
        text += toCsv(frames[f]);
    }
    const std::vector<TrackRow> rows = readTracks(make("tracks.csv", text));
    ASSERT_EQ(rows.size(), 80U);
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        EXPECT_NEAR(rows[i].time, frames[i / 16].time, 1e-6);
        expectSame(rows[i].report, frames[i / 16].tracks[i % 16]);
    }
}

TEST_F(TablesTest, NumbersFollowTheColumns)
{
    std::mt19937_64 random(6);
    TrackReport report = randomReport(random, 6);
    const std::vector<double> numbers = toNumbers(12.5, report);
    const std::vector<std::string>& columns = trackColumns();
    ASSERT_EQ(numbers.size(), columns.size());
    const auto of = [&](const std::string& name)
    {
        const auto found = std::find(columns.begin(), columns.end(), name);
        return numbers[static_cast<std::size_t>(found - columns.begin())];
    };
    EXPECT_EQ(of("time_s"), 12.5);
    EXPECT_EQ(of("track_id"), 6.0);
    EXPECT_EQ(of("status"), static_cast<double>(TrackStatus::Coasting));
    EXPECT_TRUE(std::isnan(of("vehicle_probability")));
    EXPECT_TRUE(std::isnan(of("is_vehicle")));
    EXPECT_TRUE(std::isnan(of("nis")));
    EXPECT_EQ(of("faces_seen"), 6.0);
    EXPECT_EQ(of("cov_y_heading"), report.covariance(1, 2));
    EXPECT_EQ(of("var_width_m2"), report.widthVariance);
    EXPECT_EQ(of("forward_probability"), report.forwardProbability);
    report.type = TypeProbability{VehicleType::Truck, 0.75};
    EXPECT_EQ(toNumbers(0.0, report)[28], static_cast<double>(VehicleType::Truck));
    EXPECT_EQ(toNumbers(0.0, report)[29], 0.75);
    EXPECT_EQ(of("axes_probability"), report.axesProbability);
    report.vehicleProbability = 0.49;
    EXPECT_EQ(toNumbers(0.0, report)[4], 0.0);
    report.vehicleProbability = 0.5;
    EXPECT_EQ(toNumbers(0.0, report)[4], 1.0);
}

TEST(TrackStatusNames, RoundTrip)
{
    for (const auto status : {TrackStatus::Tentative, TrackStatus::Confirmed, TrackStatus::Coasting,
                              TrackStatus::Ended})
    {
        EXPECT_EQ(trackStatusFromString(toString(status)), status);
    }
    EXPECT_EQ(trackStatusFromString("Confirmed"), std::nullopt);
    EXPECT_EQ(trackStatusFromString(""), std::nullopt);
}

}  // namespace
}  // namespace vdamf
