// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <chrono>
#include <cstdio>
#include <functional>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "filter_clusters.h"
#include "held_out.h"
#include "outputs.h"
#include "program.h"
#include "vdamf/files/numbers.h"
#include "vdamf/rawlog/filter_file.h"
#include "vdamf/tracking/types/vehicle_type.h"

namespace vdamf
{
namespace
{
using Conditions = std::vector<LabelledClusters>;

struct ClusterCollection
{
    Conditions train;
    Conditions test;
    std::string names;  // of what is trained on
};

std::size_t countOf(const Conditions& conditions)
{
    std::size_t count = 0;
    for (const LabelledClusters& condition : conditions) count += condition.samples.size();
    return count;
}

void take(ClusterCollection& all, const FilterJob& job, const std::string& name, RecordingUse use,
          Conditions conditions)
{
    const bool isTest = use == RecordingUse::Test;
    if (!job.quiet)
        std::fprintf(stderr, "%s%s: %zu clusters\n", name.c_str(), isTest ? " (test)" : "",
                     countOf(conditions));
    if (!isTest) all.names += (all.names.empty() ? "" : " ") + name;
    Conditions& part = isTest ? all.test : all.train;
    std::move(conditions.begin(), conditions.end(), std::back_inserter(part));
}

ClusterCollection collectClusters(const FilterJob& job, const std::atomic<bool>& stop)
{
    ClusterCollection all;
    for (const SimulatedSource& source : job.sources.simulated)
        take(all, job, source.name, source.options.use, clustersOf(source));
    for (const FilterRecording& recording : job.sources.recordings)
        take(all, job, recording.name, recording.options.use,
             namingRecording(recording.name,
                             [&] { return clustersOf(recording, job.configuration, stop); }));
    if (all.train.empty()) throw std::runtime_error("nothing to train on: all is for testing");
    return all;
}

/// On stderr which types have no filter in the bank.
void warnOfRareTypes(const ClusterCollection& all, const FilterTrainingOptions& training)
{
    std::string rare;
    for (const TypeCount& one : rareTypes(all.train, training.leastOfType))
        rare += (rare.empty() ? "" : ", ") + std::string(toString(one.type)) + " (" +
                std::to_string(one.clusters) + ")";
    if (rare.empty()) return;
    std::fprintf(stderr,
                 "--bank: types with fewer than %d clusters have no filter of their own: %s\n",
                 training.leastOfType, rare.c_str());
}

/// A line on stderr that is written over, and the end of an interrupted training.
class Progress
{
public:
    Progress(bool quiet, const std::atomic<bool>& stop) : quiet_(quiet), stop_(stop) {}

    void operator()(const std::string& step, double share)
    {
        if (stop_) throw std::runtime_error("interrupted");
        const auto now = std::chrono::steady_clock::now();
        if (quiet_ || !isTerminal() || now - told_ < std::chrono::seconds(1)) return;
        told_ = now;
        const double passed = std::chrono::duration<double>(now - begin_).count();
        const double left = share > 0.0 ? passed * (1.0 - share) / share : 0.0;
        std::fprintf(stderr, "\r\033[K%s: %.0f %%, %.0f s left", step.c_str(), 100.0 * share, left);
        isOpen_ = true;
    }

    void end() const
    {
        if (isOpen_) std::fprintf(stderr, "\r\033[K");
    }

private:
    bool quiet_;
    const std::atomic<bool>& stop_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point told_ = begin_;
    bool isOpen_ = false;
};

FilterRecord recordOf(const FilterJob& job, const ClusterCollection& all,
                      const FilterTraining& training)
{
    const FilterTrainingOptions& o = job.training;
    std::ostringstream options;
    const MeasureOptions& measurement = job.configuration.tracker.measurement;
    for (const auto& [kind, name] : EnumNames<FilterKind>::names())
        if (kind == measurement.filter) options << name;
    options << ", evaluations " << o.globalEvaluations << " and " << o.localEvaluations
            << ", folds " << o.folds << ", seed " << o.seed;
    FilterRecord record;
    record.program = "vdamf-train " + job.version;
    record.data = std::to_string(countOf(all.train)) + " clusters under " +
                  std::to_string(all.train.size()) + " conditions of " + all.names;
    record.options = options.str();
    record.heldOut = training.heldOut.empty()
                         ? "not cross-validated"
                         : "against hand-set, " + scoreText(training.heldOut, "learned");
    return record;
}

void tell(const std::string& title, const std::vector<HeldOutCondition>& conditions, bool bank)
{
    if (conditions.empty()) return;
    std::printf("%s\n%slearned: %s\n", title.c_str(), heldOutText(conditions).c_str(),
                scoreText(conditions, "learned").c_str());
    if (bank) std::printf("bank: %s\n", scoreText(conditions, "bank").c_str());
}
}  // namespace

std::vector<std::filesystem::path> outputsOf(const FilterJob& job)
{
    std::vector<std::filesystem::path> outputs = {job.filters};
    if (!job.table.empty()) outputs.push_back(job.table);
    return outputs;
}

void trainFilter(const FilterJob& job, const std::atomic<bool>& stop)
{
    checkFiles(job.sources.recordings);
    Outputs outputs(outputsOf(job), job.overwrite);
    const ClusterCollection all = collectClusters(job, stop);
    if (job.training.bank) warnOfRareTypes(all, job.training);
    Progress progress(job.quiet, stop);
    const MeasureOptions& handSet = job.configuration.tracker.measurement;
    FilterTraining training = trainFilter(all.train, handSet, job.training, std::ref(progress));
    progress.end();
    training.bank.record = recordOf(job, all, training);
    const std::vector<HeldOutCondition> tested = comparedOn(all.test, handSet, training.bank);
    const bool isBank = training.bank.filters.size() > 1;
    std::printf("Trained on %s\nobjective %s, hand-set %s\n", training.bank.record.data.c_str(),
                toFixedText(training.after, 4).c_str(), toFixedText(training.before, 4).c_str());
    tell("\nCross-validation", training.heldOut, isBank);
    tell("\nTest, not trained on", tested, isBank);
    const std::string filters = toText(training.bank);
    parseFilterBank(filters, "the trained filters");  // throws where numbers are not finite
    outputs.write(job.filters, filters);
    if (job.table.empty()) return;
    outputs.write(job.table, heldOutHeader() + heldOutRows("fold", training.heldOut) +
                                 heldOutRows("test", tested));
}

}  // namespace vdamf
