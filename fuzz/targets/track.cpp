// SPDX-License-Identifier: BSD-3-Clause
// A rawlog tracked from end to end: whatever its scans hold, the tables stay readable.
#include <atomic>
#include <cmath>

#include "memory_file.h"
#include "require.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace
{
using namespace vdamf;

void check(const FrameResult& result)
{
    fuzz::require(std::isfinite(result.time), "a frame has a time");
    std::uint64_t before = 0;
    for (const TrackReport& track : result.tracks)
    {
        fuzz::require(track.id > before, "identities rise");
        before = track.id;
        fuzz::require(std::isfinite(track.box.x + track.box.y + track.box.heading + track.z),
                      "a track has a pose");
        fuzz::require(track.box.length > 0.0 && track.box.width > 0.0 && track.height >= 0.0,
                      "a track has a size");
        fuzz::require(
            std::isfinite(track.speed + track.yawRate + track.match + track.nis.value_or(0.0)),
            "a track has a speed");
        fuzz::require(track.covariance.allFinite(), "a track has a covariance");
    }
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const fuzz::MemoryFile file(fuzz::textOf(data, size));
    TrackRawlogJob job;
    job.input = file.path();
    job.output = "/dev/null";
    job.configuration.output.gzLevel = 0;
    job.configuration.output.gzThreads = 0;
    const std::atomic<bool> stop{false};
    fuzz::mayRefuse(
        [&]
        {
            std::string table = tracksHeader();
            trackRawlog(job, stop,
                        [&](const LadarFrame&, const FrameResult& result, double progress)
                        {
                            fuzz::require(progress >= 0.0 && progress <= 1.0,
                                          "progress is a share");
                            check(result);
                            table += toCsv(result);
                        });
            const fuzz::MemoryFile written(table);
            readTracks(written.path());
        });
    return 0;
}
