// SPDX-License-Identifier: BSD-3-Clause
#include "scaling/stage_times.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace vdamf
{
namespace
{
Duration now()
{
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    std::timespec processor{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &processor);
    return {std::chrono::duration<double>(wall).count(),
            static_cast<double>(processor.tv_sec) + 1e-9 * static_cast<double>(processor.tv_nsec)};
}

Duration between(const Duration& from, const Duration& to)
{
    return {to.wall - from.wall, to.processor - from.processor};
}

struct FrameTimes
{
    std::array<Duration, kStages> stages;
    Duration all;
    double points, clusters, tracks;
};

FrameTimes timedFrame(Tracker& tracker, const LadarFrame& frame)
{
    std::array<Duration, kStages + 1> begins;
    std::size_t entered = 0;
    tracker.onStage([&](const Stage*) { begins[entered++] = now(); });
    const FrameResult result = tracker.process(frame);
    FrameTimes times{};
    for (std::size_t k = 0; k < kStages; ++k) times.stages[k] = between(begins[k], begins[k + 1]);
    times.all = between(begins.front(), begins.back());
    times.points = static_cast<double>(result.points);
    times.clusters = static_cast<double>(result.clusters);
    times.tracks = static_cast<double>(result.tracks.size());
    return times;
}

template <class Value>
double medianOf(const std::vector<FrameTimes>& frames, const Value& value)
{
    std::vector<double> values;
    for (const FrameTimes& frame : frames) values.push_back(value(frame));
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

template <class Value>
Duration medianDuration(const std::vector<FrameTimes>& frames, const Value& value)
{
    return {medianOf(frames, [&](const FrameTimes& f) { return value(f).wall; }),
            medianOf(frames, [&](const FrameTimes& f) { return value(f).processor; })};
}
}  // namespace

SequenceTimes timedSequence(const FrameSource& source, int frames, int warmUp,
                            const TrackerOptions& options)
{
    Tracker tracker(options);
    std::vector<FrameTimes> all;
    for (int k = 0; k < frames; ++k)
    {
        const FrameTimes times = timedFrame(tracker, source(k));
        if (k >= warmUp) all.push_back(times);
    }
    SequenceTimes medians;
    medians.frames = all.size();
    medians.points = medianOf(all, [](const FrameTimes& f) { return f.points; });
    medians.clusters = medianOf(all, [](const FrameTimes& f) { return f.clusters; });
    medians.tracks = medianOf(all, [](const FrameTimes& f) { return f.tracks; });
    for (std::size_t k = 0; k < kStages; ++k)
        medians.stages[k] = medianDuration(all, [k](const FrameTimes& f) { return f.stages[k]; });
    medians.all = medianDuration(all, [](const FrameTimes& f) { return f.all; });
    return medians;
}

}  // namespace vdamf
