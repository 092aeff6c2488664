// SPDX-License-Identifier: BSD-3-Clause
#include "filter_clusters.h"

#include <algorithm>
#include <stdexcept>

#include "collect.h"
#include "vdamf/evaluation/named_tables.h"
#include "vdamf/evaluation/sequence.h"
#include "vdamf/learning/clusters/label_hits.h"
#include "vdamf/learning/clusters/simulated_clusters.h"
#include "vdamf/tracking/preprocessing/clustering.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kLeastHits = 10;  // as in the tracker
constexpr double kSameTime = 1e-3;      // s
constexpr std::uint64_t kStartSeed = 1;

VehicleType typeOf(const std::string& objectClass)
{
    if (objectClass == "Car") return VehicleType::Car;
    if (objectClass == "Van") return VehicleType::Van;
    if (objectClass == "Truck" || objectClass == "Bus") return VehicleType::Truck;
    return VehicleType::Any;
}

class Collector
{
public:
    Collector(const FilterRecording& recording, const Configuration& configuration)
        : recording_(recording), configuration_(configuration)
    {
        ScoringOptions scoring;
        scoring.regionFov = recording.options.regionFov;
        scoring.maxRange = recording.options.maxRange;
        scoring.minPoints = recording.options.minPoints;
        const std::vector<TruthRow> truth = readTruth(recording.truth);
        truth_ = namingTables(recording.truth, recording.rawlog,
                              [&] { return makeSequence(truth, {}, scoring).frames; });
        inLabel_ = {recording.name + " label", "hits in the label's box", {}};
        whole_ = {recording.name + " cluster", "whole cluster", {}};
    }

    void take(const LadarFrame& frame)
    {
        const auto scored =
            std::lower_bound(truth_.begin(), truth_.end(), frame.time - kSameTime,
                             [](const ScoredFrame& one, double time) { return one.time < time; });
        if (scored == truth_.end() || scored->time > frame.time + kSameTime) return;
        const AboveGround above = removeGround(frame, configuration_.tracker.ground);
        const std::vector<Cluster> clusters =
            clusterPoints(frame, above, configuration_.tracker.clustering);
        for (std::size_t i = 0; i < scored->truth.size(); ++i)
        {
            if (!scored->counts[i]) continue;
            LabelledCluster one = labelled(frame, scored->truth[i]);
            one.cluster = hitsInLabel(frame, above, one.truth);
            add(inLabel_, one);
            one.cluster = clusterOnLabel(clusters, one.truth);
            add(whole_, one);
        }
    }

    std::vector<LabelledClusters> conditions() const { return {evenly(inLabel_), evenly(whole_)}; }

private:
    LabelledCluster labelled(const LadarFrame& frame, const TruthRow& row) const
    {
        const FilterRecordingOptions& options = recording_.options;
        LabelledCluster one;
        one.sensor = (frame.sensor - frame.origin).head<2>();
        one.truth = row.box;
        one.truth.x -= frame.origin.x();
        one.truth.y -= frame.origin.y();
        one.height = row.height;
        one.type = typeOf(row.objectClass);
        one.group = options.scene.empty() ? recording_.name + ' ' + row.objectId : options.scene;
        one.rangeNoise = options.rangeNoise;
        one.truthPlace = options.labelPlace;
        one.truthHeading = options.labelHeading;
        return one;
    }

    static void add(LabelledClusters& condition, const LabelledCluster& cluster)
    {
        if (cluster.cluster.size() >= kLeastHits) condition.samples.push_back(cluster);
    }

    LabelledClusters evenly(const LabelledClusters& all) const
    {
        LabelledClusters some{all.name, all.description, {}};
        const std::size_t count = all.samples.size();
        const std::size_t wanted =
            std::min(count, static_cast<std::size_t>(recording_.options.mostClusters));
        for (std::size_t k = 0; k < wanted; ++k)
        {
            LabelledCluster one = all.samples[k * count / wanted];
            one.start = perturbed(one.truth, kStartSeed, k);
            one.inView = facesInView(one.cluster, one.truth, one.sensor);
            some.samples.push_back(std::move(one));
        }
        return some;
    }

    const FilterRecording& recording_;
    const Configuration& configuration_;
    std::vector<ScoredFrame> truth_;
    LabelledClusters inLabel_;
    LabelledClusters whole_;
};
}  // namespace

std::vector<LabelledClusters> clustersOf(const FilterRecording& recording,
                                         const Configuration& configuration,
                                         const std::atomic<bool>& stop)
{
    TrackRawlogJob job;
    job.input = recording.rawlog;
    job.configuration = configuration;
    job.configuration.output.hindsight = false;  // as a tracker sees them
    job.configuration.tracker.discriminator.model = "none";
    Collector collector(recording, configuration);
    const TrackRawlogSummary summary = trackRawlog(
        job, stop,
        [&](const LadarFrame& frame, const FrameResult&, double) { collector.take(frame); });
    checkReadWhole(summary, recording.rawlog);
    std::vector<LabelledClusters> conditions = collector.conditions();
    if (conditions[0].samples.empty())
        throw std::runtime_error(recording.truth.string() +
                                 ": has no vehicle with ten hits at a time of a scan of " +
                                 recording.rawlog.string());
    return conditions;
}

std::vector<LabelledClusters> clustersOf(const SimulatedSource& source)
{
    std::vector<LabelledClusters> conditions;
    const auto seed = static_cast<std::uint64_t>(source.options.seed);
    for (const SimulatedKind& kind : simulatedKinds())
    {
        if (!source.options.kind.empty() && kind.name != source.options.kind) continue;
        LabelledClusters all = simulatedCondition(kind, source.options.clusters, seed);
        all.name = source.name + ' ' + kind.name;
        for (LabelledCluster& cluster : all.samples)
            cluster.group = source.name + ' ' + cluster.group;
        conditions.push_back(std::move(all));
    }
    return conditions;
}

}  // namespace vdamf
