// SPDX-License-Identifier: BSD-3-Clause
// One scene, simulated and tracked: do the tracks of two rawlogs of it agree?
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/tables.h"

namespace vdamf
{
using Tracks = std::map<double, std::vector<TrackReport>>;  // confirmed, by time

class SimulatedClasses : public TrackProgram
{
protected:
    /// The scene heads east, so that odometry's axes are those of the scene.
    void SetUp() override
    {
        std::ofstream(at("scene.ini"))
            << "[scenario]\nduration_s = 1.6\nstart_time_s = 1700000000\n"
               "[sensor]\nmodel = HDL-32E\nfield_of_view_deg = 140\nx_m = 1\ny_m = 0.2\nz_m = "
               "1.9\nheading_deg = 10\n"
               "[platform]\nspeed_mps = 8\nsegments = 1.6 0 0.02\n"
               "[object ahead]\nclass = car\nx_m = 16\nspeed_mps = 8\nsegments = 1.6 0 0.02\n"
               "[object parked]\nclass = car\nx_m = 14\ny_m = 5\nheading_deg = 180\n"
               "[object beside]\nclass = van\nx_m = 20\ny_m = -6\nheading_deg = 20\n";
    }

    /// Written as a.rawlog.
    void simulate(const std::string& options) const
    {
        const Outcome run = runApp("vdamf-simulate",
                                   path("scene.ini") + " --overwrite" + out("a.rawlog") + options);
        EXPECT_EQ(run.exitCode, 0) << run.output;
    }

    Tracks tracksOf(const std::string& rawlog, const std::string& tracking = "") const
    {
        const Outcome run =
            track(in(rawlog) + " --overwrite --tracks " + path("t.csv") + " " + tracking);
        EXPECT_EQ(run.exitCode, 0) << run.output;
        summary_ = run.output;
        Tracks tracks;
        for (const TrackRow& row : readTracks(at("t.csv")))
            if (row.report.status == TrackStatus::Confirmed) tracks[row.time].push_back(row.report);
        return tracks;
    }

    Tracks tracksWith(const std::string& simulation) const
    {
        simulate(simulation);
        return tracksOf("a.rawlog");
    }

    mutable std::string summary_;
};

/// How far the boxes of a drive are from those of the reference, which has one near each of them.
struct Difference
{
    double position = 0.0;  // m, largest
    double heading = 0.0;   // rad, largest, either way round
    int compared = 0;
    int missing = 0;
};

inline Difference between(const Tracks& reference, const Tracks& tracks)
{
    constexpr double kSame = 1.5;     // m
    constexpr double kSettled = 1.0;  // s
    Difference result;
    const double begin = reference.empty() ? 0.0 : reference.begin()->first;
    for (const auto& [time, expected] : reference)
    {
        if (time < begin + kSettled) continue;
        const auto frame =
            std::find_if(tracks.begin(), tracks.end(),
                         [t = time](const auto& f) { return std::abs(f.first - t) < 1e-4; });
        for (const TrackReport& one : expected)
        {
            const TrackReport* nearest = nullptr;
            double least = kSame;
            for (const TrackReport& other :
                 frame == tracks.end() ? std::vector<TrackReport>{} : frame->second)
            {
                const double apart = std::hypot(one.box.x - other.box.x, one.box.y - other.box.y);
                if (apart > least) continue;
                least = apart;
                result.heading = std::max(result.heading,
                                          std::abs(std::sin(one.box.heading - other.box.heading)));
                nearest = &one;
            }
            ++result.compared;
            if (nearest == nullptr)
                ++result.missing;
            else
                result.position = std::max(result.position, least);
        }
    }
    return result;
}

inline void expectSame(const Tracks& reference, const Tracks& tracks, double position,
                       double degrees, int atLeast = 12)
{
    const Difference difference = between(reference, tracks);
    EXPECT_GE(difference.compared, atLeast);
    EXPECT_EQ(difference.missing, 0);
    EXPECT_LE(difference.position, position);
    EXPECT_LE(difference.heading * 180.0 / kPi, degrees);
}

}  // namespace vdamf
