// SPDX-License-Identifier: BSD-3-Clause
// The tracker inside a program of one's own: MRPT observations in, tracked vehicles out. Here the
// observations come from a rawlog; in a robot they come from its sensors.
#include <cstdio>
#include <exception>

#include <mrpt/obs/CObservation.h>

#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/scan.h"
#include "vdamf/rawlog/world_frame.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace
{
void report(const vdamf::FrameResult& frame)
{
    for (const vdamf::TrackReport& track : frame.tracks)
    {
        if (track.status != vdamf::TrackStatus::Confirmed || track.speed < 3.0) continue;
        std::printf("%.2f track %llu at (%.1f, %.1f) heading %.0f deg, %.1f m/s\n", frame.time,
                    static_cast<unsigned long long>(track.id), track.box.x, track.box.y,
                    track.box.heading * 180.0 / vdamf::kPi, track.speed);
    }
}

// Takes one observation of whatever kind.
void process(const mrpt::obs::CObservation& observation, vdamf::InsTrajectory& ins,
             vdamf::Tracker& tracker)
{
    constexpr double kPosesKept = 10.0;  // s
    ins.insert(observation);
    const auto scan = vdamf::scanFrom(observation);
    if (!scan) return;
    const auto pose = ins.at(scan->time);
    if (!pose) return;
    report(tracker.process(vdamf::toLadarFrame(*scan, *pose)));
    // The trajectory must not grow as long as the robot runs.
    ins.forgetBefore(scan->time - kPosesKept);
}
}  // namespace

int main(int argc, char** argv)
try
{
    if (argc != 2)
    {
        std::fprintf(stderr, "usage: robot_app FILE.rawlog\n");
        return 2;
    }
    vdamf::RawlogReader reader(argv[1]);
    vdamf::InsTrajectory ins{vdamf::InsOptions()};
    vdamf::TrackerOptions options;
    options.lifecycle.confirmHits = 5;
    vdamf::Tracker tracker(options);
    while (const auto entry = reader.next())
    {
        const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry->object);
        if (!observation) continue;
        try
        {
            process(*observation, ins, tracker);
        }
        catch (const std::exception& error)  // it came too late, or cannot be read
        {
            std::fprintf(stderr, "scan skipped: %s\n", error.what());
        }
    }
    return 0;
}
catch (const std::exception& error)
{
    std::fprintf(stderr, "robot_app: %s\n", error.what());
    return 1;
}
