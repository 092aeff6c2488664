// SPDX-License-Identifier: BSD-3-Clause
// Scans that are far apart in time: between two of them vehicles go farther than they are long.
#include <gtest/gtest.h>

#include <set>

#include "tracking/tracker/example_frames.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
namespace
{
// Of a car that comes towards the sensor, which stands, at so many scans a second: the confirmed
// tracks within 1.5 m of it, and in how many of the last scans there was one.
struct Followed
{
    std::set<std::uint64_t> tracks;
    int scans = 0;
};

Followed follow(double speed, double rate)
{
    constexpr int kScans = 8;
    constexpr int kLast = 4;
    Tracker tracker{TrackerOptions{}};
    Followed followed;
    for (int k = 0; k < kScans; ++k)
    {
        const double time = k / rate;
        const OrientedBox car{10.0 + speed * (kScans - 1 - k) / rate, 3.5, kPi, 4.5, 1.8};
        const auto result =
            tracker.process(exampleFrame(time, {0.0, 0.0}, {{car}}, 3 + static_cast<unsigned>(k)));
        for (const TrackReport& track : result.tracks)
        {
            const bool isThere = (track.box.centre() - car.centre()).norm() < 1.5;
            if (track.status != TrackStatus::Confirmed || !isThere) continue;
            followed.tracks.insert(track.id);
            if (k >= kScans - kLast) ++followed.scans;
        }
    }
    return followed;
}

TEST(SlowSensor, KeepsWhatGoesFarBetweenItsScans)
{
    for (const auto& [speed, rate] : {std::pair(14.0, 2.0), std::pair(12.0, 5.0)})
    {
        const Followed followed = follow(speed, rate);
        EXPECT_EQ(followed.tracks.size(), 1U) << speed << " m/s at " << rate << " Hz";
        EXPECT_GE(followed.scans, 3) << speed << " m/s at " << rate << " Hz";
    }
}

}  // namespace
}  // namespace vdamf
