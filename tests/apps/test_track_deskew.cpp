// SPDX-License-Identifier: BSD-3-Clause
// Standing things stay where they are, however the platform moves during a revolution.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/rawlog/scan.h"
#include "vdamf/rawlog/world_frame.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservation;
using testing::HasSubstr;

constexpr double kWall = 45.0;                                              // m east, its near face
const Eigen::Vector2d kPole(25.0, 6.0);                                     // m
constexpr double kNoise = 0.02;                                             // of a range, m
const std::string kStraight = "speed_mps = 20\n";                           // towards the wall
const std::string kTurning = "speed_mps = 10\nsegments = 2 0 0.0523599\n";  // by 30 deg/s

class TrackDeskew : public TrackProgram
{
protected:
    /// A second of a drive towards a wall across the road, past a pole.
    void simulate(const std::string& platform) const
    {
        std::ofstream(at("scene.ini"))
            << "[scenario]\nduration_s = 1\nstart_time_s = 1700000000\n"
               "[sensor]\nmodel = HDL-32E\ninstantaneous = false\nhalf_loss_strength = 0\n"
               "range_noise_m = 0.02\n[platform]\n"
            << platform
            << "[object wall]\nclass = wall\nx_m = 45.15\nheading_deg = 90\nlength_m = 60\n"
               "width_m = 0.3\nheight_m = 6\n"
               "[object pole]\nclass = pole\nx_m = 25\ny_m = 6\nlength_m = 0.3\nwidth_m = 0.3\n";
        const Outcome run =
            runApp("vdamf-simulate", path("scene.ini") + out("a.rawlog") + " --overwrite");
        ASSERT_EQ(run.exitCode, 0) << run.output;
    }

    /// All frames, with and without de-skewing.
    std::vector<std::pair<LadarFrame, LadarFrame>> frames() const
    {
        InsTrajectory ins{InsOptions()};
        std::vector<Scan> scans;
        const Contents log(at("a.rawlog"));
        for (const RawlogEntry& entry : log.entries)
        {
            ins.insert(*entry.object);
            const auto scan = scanFrom(dynamic_cast<const CObservation&>(*entry.object));
            if (scan) scans.push_back(*scan);
        }
        std::vector<std::pair<LadarFrame, LadarFrame>> all;
        for (const Scan& scan : scans)
        {
            const VehiclePose pose = ins.at(scan.time).value();
            DeskewedFrame deskewed = toLadarFrame(scan, pose, ins);
            EXPECT_TRUE(deskewed.posesCoverScan);
            all.emplace_back(std::move(deskewed.frame), toLadarFrame(scan, pose));
        }
        return all;
    }
};

/// How far hits are from where they belong, m.
struct Errors
{
    std::size_t count = 0;
    double rms = 0.0;
    double largest = 0.0;
};

Errors errorsOf(const std::vector<double>& distances)
{
    Errors errors;
    for (const double d : distances)
    {
        errors.rms += d * d;
        errors.largest = std::max(errors.largest, std::abs(d));
    }
    errors.count = distances.size();
    errors.rms =
        std::sqrt(errors.rms / static_cast<double>(std::max<std::size_t>(1, errors.count)));
    return errors;
}

Eigen::Vector3d hitOf(const LadarFrame& frame, std::size_t i)
{
    return frame.origin + Eigen::Vector3d(frame.points.x[i], frame.points.y[i], frame.points.z[i]);
}

/// Of the hits on the wall's face, away from its ends.
Errors wallErrors(const LadarFrame& frame)
{
    std::vector<double> distances;
    for (std::size_t i = 0; i < frame.points.size(); ++i)
    {
        const Eigen::Vector3d hit = hitOf(frame, i);
        if (hit.z() < 0.5 || hit.z() > 5.5 || std::abs(hit.y()) > 20.0 || hit.x() < 40.0) continue;
        distances.push_back(hit.x() - kWall);
    }
    return errorsOf(distances);
}

/// Of the hits on the pole: from its axis, less its radius.
Errors poleErrors(const LadarFrame& frame)
{
    std::vector<double> distances;
    for (std::size_t i = 0; i < frame.points.size(); ++i)
    {
        const Eigen::Vector3d hit = hitOf(frame, i);
        const double distance = (hit.head<2>() - kPole).norm();
        if (hit.z() < 0.5 || distance > 3.0) continue;
        distances.push_back(distance - 0.15);
    }
    return errorsOf(distances);
}

TEST_F(TrackDeskew, StandingThingsAreWithinTheRangeNoise)
{
    for (const std::string& platform : {kStraight, kTurning})
    {
        simulate(platform);
        double worstWithout = 0.0;
        double worstPole = 0.0;
        for (const auto& [deskewed, plain] : frames())
        {
            const Errors wall = wallErrors(deskewed);
            ASSERT_GT(wall.count, 1000U) << platform;
            EXPECT_LT(wall.rms, 1.1 * kNoise) << platform;
            EXPECT_LT(wall.largest, 6.0 * kNoise) << platform;
            const Errors pole = poleErrors(deskewed);
            ASSERT_GT(pole.count, 10U) << platform;
            EXPECT_LT(pole.largest, 6.0 * kNoise) << platform;
            worstWithout = std::max(worstWithout, wallErrors(plain).rms);
            worstPole = std::max(worstPole, poleErrors(plain).rms);
        }
        EXPECT_GT(worstWithout, 10.0 * kNoise) << platform;
        EXPECT_GT(worstPole, 10.0 * kNoise) << platform;
    }
}

TEST_F(TrackDeskew, ParkedCarsStandStill)
{
    std::ofstream(at("scene.ini")) << "[scenario]\nduration_s = 3\nstart_time_s = 1700000000\n"
                                      "[sensor]\nmodel = HDL-32E\ninstantaneous = false\n"
                                      "[platform]\nspeed_mps = 20\n"
                                      "[object parked]\nclass = car\nx_m = 60\ny_m = 5\n";
    ASSERT_EQ(runApp("vdamf-simulate",
                     path("scene.ini") + out("a.rawlog") + " --truth " + path("truth.csv"))
                  .exitCode,
              0);
    const auto positionError = [&](const std::string& deskew)
    {
        EXPECT_EQ(
            track(in("a.rawlog") + " --tracks " + path(deskew) + " --set scan.deskew=" + deskew)
                .exitCode,
            0);
        double sum = 0.0;
        int count = 0;
        for (const TrackRow& row : readTracks(at(deskew)))
        {
            if (row.report.status != TrackStatus::Confirmed) continue;
            sum += std::hypot(row.report.box.x - 60.0, row.report.box.y - 5.0);
            ++count;
        }
        EXPECT_GT(count, 15);
        return sum / count;
    };
    EXPECT_LT(positionError("true"), 0.35);
    EXPECT_GT(positionError("false"), 0.5);
}

TEST_F(TrackDeskew, WaitsForThePosesUpToTheEndOfARevolution)
{
    simulate(kStraight);
    // Each pose 0.3 s late in the file: those of a revolution's end come behind those that reach
    // its begin.
    {
        const Contents log(at("a.rawlog"));
        std::vector<std::pair<double, const std::string*>> order;
        for (const RawlogEntry& entry : log.entries)
        {
            const auto& o = dynamic_cast<const CObservation&>(*entry.object);
            order.emplace_back(mrpt::Clock::toDouble(o.timestamp) + (isScan(o) ? 0.0 : 0.3),
                               &entry.bytes);
        }
        std::stable_sort(order.begin(), order.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        RawlogWriter late(at("late.rawlog"), {});
        for (const auto& [time, bytes] : order) late.writeBytes(*bytes);
        late.commit();
    }
    const std::string noGuess = " --set ins.max_extrapolation_s=0";
    Outcome run = track(in("a.rawlog") + " --tracks " + path("a.csv") + noGuess);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             10 of 10 scans"));
    run = track(in("late.rawlog") + " --tracks " + path("late.csv") + noGuess);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    // The next pose but one, which the interpolation looks at, may be there or not.
    const auto punctual = readTracks(at("a.csv"));
    const auto late = readTracks(at("late.csv"));
    ASSERT_EQ(punctual.size(), late.size());
    for (std::size_t i = 0; i < late.size(); ++i)
    {
        EXPECT_NEAR(punctual[i].report.box.x, late[i].report.box.x, 1e-3);
        EXPECT_NEAR(punctual[i].report.speed, late[i].report.speed, 1e-3);
    }
    EXPECT_THAT(run.output, testing::Not(HasSubstr("no INS pose")));
}

TEST_F(TrackDeskew, SaysWhereThePosesEndBeforeTheScan)
{
    simulate(kStraight);
    {
        const Contents log(at("a.rawlog"));
        RawlogWriter cut(at("cut.rawlog"), {});
        for (const RawlogEntry& entry : log.entries)
        {
            const auto& o = dynamic_cast<const CObservation&>(*entry.object);
            if (isScan(o) || mrpt::Clock::toDouble(o.timestamp) < 1700000000.93)
                cut.writeBytes(entry.bytes);
        }
        cut.commit();
    }
    const Outcome run =
        track(in("cut.rawlog") + " --tracks " + path("a.csv") + " --set ins.max_extrapolation_s=0");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("1 scans with hits at whose time there is no INS pose"));
}

}  // namespace
}  // namespace vdamf
