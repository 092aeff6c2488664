// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/track_rawlog.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "tracking_run.h"

namespace vdamf
{
namespace
{
constexpr double kShareOfFirst = 0.8;  // of the work, in the first of two readings

TrackRawlogSummary runInHindsight(const TrackRawlogJob& job, const std::atomic<bool>& stop,
                                  const FrameListener& listener,
                                  const FirstReadingListener& firstReading)
{
    std::error_code ignored;
    if (std::filesystem::exists(job.input, ignored) &&
        !std::filesystem::is_regular_file(job.input, ignored))
        throw std::runtime_error(job.input.string() +
                                 ": [output] hindsight = true reads it twice: it must be a file");
    const FrameListener later =
        [&](const LadarFrame& frame, const FrameResult& result, double progress)
    { listener(frame, result, kShareOfFirst + (1.0 - kShareOfFirst) * progress); };
    // Its outputs are opened before the work begins.
    TrackingRun second(job, listener ? later : listener);
    try
    {
        std::vector<FrameResult> tracked;
        const FrameListener take =
            [&](const LadarFrame& /*frame*/, const FrameResult& result, double progress)
        {
            tracked.push_back(result);
            if (firstReading) firstReading(kShareOfFirst * progress);
        };
        TrackRawlogJob first = job;
        for (auto* output : {&first.output, &first.tracks, &first.nis}) output->reset();
        TrackRawlogSummary summary = TrackingRun(first, take).run(stop);
        if (stop)
        {
            second.discard();
            summary.frames = 0;
            summary.interrupted = true;
            return summary;
        }
        second.tell(std::move(tracked), summary);
    }
    catch (...)
    {
        second.discard();
        throw;
    }
    return second.run(stop);
}
}  // namespace

void checkPaths(const TrackRawlogJob& job)
{
    std::vector<std::filesystem::path> outputs = job.otherOutputs;
    for (const auto& output : {job.output, job.tracks, job.nis})
        if (output) outputs.push_back(*output);
    std::vector<NamedInput> inputs = filesNamedBy(job.configuration);
    inputs.push_back({job.input, "the input"});
    inputs.push_back({job.configurationFile, "the configuration"});
    checkOutputPaths(outputs, inputs);
}

TrackRawlogSummary trackRawlog(const TrackRawlogJob& job, const std::atomic<bool>& stop,
                               const FrameListener& listener,
                               const FirstReadingListener& firstReading)
{
    checkPaths(job);
    if (job.configuration.output.hindsight)
        return runInHindsight(job, stop, listener, firstReading);
    return TrackingRun(job, listener).run(stop);
}

}  // namespace vdamf
