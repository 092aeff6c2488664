// SPDX-License-Identifier: BSD-3-Clause
#include "collect.h"

#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "vdamf/evaluation/named_tables.h"
#include "vdamf/learning/label.h"

namespace vdamf
{
namespace
{
using FrameKey = std::pair<std::uint64_t, long long>;  // track, time

FrameKey keyOf(std::uint64_t track, double time)
{
    return {track, std::llround(1e6 * time)};
}

struct Collected
{
    std::vector<TrackRow> rows;  ///< without features
    std::vector<ObjectSample> samples;
};

Configuration forTraining(Configuration configuration, const DiscriminationGrid& grid)
{
    DiscriminatorOptions& options = configuration.tracker.discriminator;
    options.model.clear();
    options.loaded = std::make_shared<const DiscriminatorModel>(untrainedModel(grid));
    options.keepFeatures = true;
    return configuration;
}

void take(Collected& all, const LadarFrame& frame, const FrameResult& result,
          std::uint64_t firstTrack)
{
    for (TrackReport report : result.tracks)
    {
        if (report.features.empty()) continue;
        ObjectSample sample;
        sample.track = firstTrack + report.id;
        sample.time = result.time;
        sample.range = (report.box.centre() - frame.sensor.head<2>()).norm();
        sample.hits = static_cast<std::size_t>(report.points);
        sample.features = toSparse(report.features);
        report.features.clear();
        all.samples.push_back(std::move(sample));
        all.rows.push_back({result.time, std::move(report)});
    }
}

Collected track(const Recording& recording, std::uint64_t firstTrack,
                const Configuration& configuration, const std::atomic<bool>& stop)
{
    TrackRawlogJob job;
    job.input = recording.rawlog;
    job.configuration = configuration;
    job.configuration.output.hindsight = false;  // as a tracker sees them
    Collected all;
    const TrackRawlogSummary summary =
        trackRawlog(job, stop,
                    [&](const LadarFrame& frame, const FrameResult& result, double)
                    { take(all, frame, result, firstTrack); });
    checkReadWhole(summary, recording.rawlog);
    return all;
}
}  // namespace

void checkReadWhole(const TrackRawlogSummary& run, const std::filesystem::path& rawlog)
{
    if (run.interrupted) throw std::runtime_error("interrupted");
    if (!run.readError.empty()) throw ReadError(run.readError);
    if (run.read.truncated)
        throw std::runtime_error(rawlog.string() + ": truncated: " + run.read.truncation +
                                 "; copy it again, or leave it out");
}

std::vector<TrackSamples> collectSamples(const Recording& recording, std::size_t index,
                                         const Configuration& configuration,
                                         const DiscriminationGrid& grid,
                                         const std::atomic<bool>& stop)
{
    const std::uint64_t firstTrack = static_cast<std::uint64_t>(index) << 32U;
    ScoringOptions scoring;
    scoring.regionFov = recording.options.regionFov;
    scoring.maxRange = recording.options.maxRange;
    scoring.minPoints = recording.options.minPoints;
    const std::vector<TruthRow> truth = readTruth(recording.truth);
    Collected all = track(recording, firstTrack, forTraining(configuration, grid), stop);
    std::map<FrameKey, LabelledRow> labels;
    std::vector<LabelledRow> rows = namingTables(
        recording.truth, recording.rawlog, [&] { return labelTracks(truth, all.rows, scoring); });
    for (LabelledRow& row : rows)
    {
        const FrameKey key = keyOf(firstTrack + row.track, row.time);
        labels.emplace(key, std::move(row));
    }
    for (ObjectSample& sample : all.samples)
    {
        const auto found = labels.find(keyOf(sample.track, sample.time));
        if (found == labels.end()) continue;
        sample.label = found->second.label;
        sample.object = found->second.object;
    }
    std::vector<TrackSamples> tracks =
        groupedByTrack(std::move(all.samples), index, recording.name, recording.options.scene);
    for (TrackSamples& one : tracks) one.weight = recording.options.weight;
    return tracks;
}

}  // namespace vdamf
