// SPDX-License-Identifier: BSD-3-Clause
// Consistency of tracks from their innovations: who is counted, and what is said of them.
#include "vdamf/rawlog/nis_report.h"

#include <gmock/gmock.h>

#include <random>

namespace vdamf
{
namespace
{
// NIS of a filter whose covariance is `scale` times what it should be: chi-square with 3 degrees
// of freedom, divided by it.
class Innovations
{
public:
    double nis(double scale)
    {
        double sum = 0.0;
        for (int i = 0; i < 3; ++i)
        {
            const double e = normal_(random_);
            sum += e * e;
        }
        return sum / scale;
    }

private:
    std::mt19937 random_{77};
    std::normal_distribution<double> normal_;
};

TrackReport track(std::uint64_t id, std::optional<double> nis,
                  TrackStatus status = TrackStatus::Confirmed)
{
    TrackReport report;
    report.id = id;
    report.status = status;
    report.nis = nis;
    return report;
}

NisReport example(NisCollector::Rows rows = NisCollector::Rows::Keep)
{
    NisCollector collector(rows);
    Innovations draw;
    for (int i = 0; i < 400; ++i)
    {
        FrameResult frame;
        frame.tracks = {track(3, draw.nis(1.0)),
                        track(7, draw.nis(0.25)),
                        track(8, draw.nis(0.1)),
                        track(12, draw.nis(4.0)),
                        track(20, 1e6, TrackStatus::Tentative),
                        track(21, std::nullopt)};
        if (i < 20) frame.tracks.push_back(track(30, 100.0));
        collector.add(frame);
    }
    return collector.report();
}

TEST(NisReport, JudgesEachTrackAndAll)
{
    const NisReport report = example();
    std::vector<std::uint64_t> ids;
    std::vector<Verdict> verdicts;
    for (const TrackNis& t : report.tracks)
    {
        ids.push_back(t.trackId);
        verdicts.push_back(t.verdict);
    }
    EXPECT_EQ(ids, (std::vector<std::uint64_t>{3, 7, 8, 12, 30}));
    EXPECT_EQ(verdicts, (std::vector<Verdict>{Verdict::Consistent, Verdict::Overconfident,
                                              Verdict::Overconfident, Verdict::Underconfident,
                                              Verdict::TooFew}));
    EXPECT_EQ(report.all.count, 4U * 400U + 20U);
    EXPECT_EQ(report.all.dimension, 3);
    EXPECT_NEAR(report.tracks[1].nis.mean, 4.0, 0.5);
}

TEST(NisReport, TheWorstClaimTooMuch)
{
    const NisReport report = example();
    std::vector<std::uint64_t> ids;
    for (const TrackNis& t : report.worst) ids.push_back(t.trackId);
    EXPECT_EQ(ids, (std::vector<std::uint64_t>{8, 7, 12}));
}

TEST(NisReport, WithoutRowsTellsTheSameOfAll)
{
    const NisReport with = example();
    const NisReport without = example(NisCollector::Rows::Drop);
    EXPECT_TRUE(without.tracks.empty());
    EXPECT_EQ(without.verdicts, with.verdicts);
    EXPECT_EQ(without.verdicts, (std::array<std::uint64_t, 5>{1, 1, 2, 1, 0}));
    EXPECT_EQ(without.worst.size(), 3U);
    EXPECT_EQ(without.all.mean, with.all.mean);
}

TEST(NisReport, KeepsTheWorstOfManyTracks)
{
    NisCollector collector(NisCollector::Rows::Drop);
    for (std::uint64_t id = 1; id <= 40; ++id)
        for (int i = 0; i < 50; ++i)
        {
            FrameResult frame;
            frame.tracks = {track(id, 3.0 * static_cast<double>(id % 20 + 2),
                                  i < 49 ? TrackStatus::Confirmed : TrackStatus::Ended)};
            collector.add(frame);
        }
    const NisReport report = collector.report();
    ASSERT_EQ(report.worst.size(), NisReport::kMostWorst);
    EXPECT_EQ(report.worst.front().trackId, 19U);
    EXPECT_NEAR(report.worst.front().nis.mean, 21.0, 1e-9);
    EXPECT_NEAR(report.worst.back().nis.mean, 17.0, 1e-9);
}

TEST(NisReport, IsATable)
{
    EXPECT_THAT(toCsv(example()),
                testing::MatchesRegex("track_id,updates,mean_nis_per_dof,lower_bound,upper_bound,"
                                      "within_95,verdict\n"
                                      "3,400,[0-9.,]*,consistent\n7,400,[0-9.,]*,overconfident\n"
                                      "8,400,[0-9.,]*,overconfident\n"
                                      "12,400,[0-9.,]*,underconfident\n"
                                      "30,20,33.3333,[0-9.,]*,too_few\n"));
    EXPECT_EQ(NisCollector(NisCollector::Rows::Keep).report().all.count, 0U);
}

}  // namespace
}  // namespace vdamf
