// SPDX-License-Identifier: BSD-3-Clause
// sweep.ini: which recordings, which keys with which values, which plan, which metrics.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vdamf/experiments/run_input.h"
#include "vdamf/experiments/swept_key.h"
#include "vdamf/files/ini.h"

namespace vdamf
{
enum class PlanKind
{
    Grid,     ///< all settings
    Random,   ///< `count` settings, drawn
    Optimise  ///< `count` settings, each chosen by what those before came to
};

template <>
struct EnumNames<PlanKind>
{
    static std::vector<std::pair<PlanKind, const char*>> names()
    {
        return {{PlanKind::Grid, "grid"},
                {PlanKind::Random, "random"},
                {PlanKind::Optimise, "optimise"}};
    }
};

/// NLopt's algorithms that need no derivatives.
enum class SweepOptimiser
{
    Bobyqa,      ///< LN_BOBYQA: local, by a quadratic model; needs two keys or more
    NelderMead,  ///< LN_NELDERMEAD: local, by a simplex; bears noise
    Subplex,     ///< LN_SBPLX: the same in subspaces, for many keys
    Direct       ///< GN_DIRECT_L: global, by dividing boxes
};

template <>
struct EnumNames<SweepOptimiser>
{
    static std::vector<std::pair<SweepOptimiser, const char*>> names()
    {
        return {{SweepOptimiser::Bobyqa, "bobyqa"},
                {SweepOptimiser::NelderMead, "nelder_mead"},
                {SweepOptimiser::Subplex, "subplex"},
                {SweepOptimiser::Direct, "direct"}};
    }
};

/// Section [sweep].
struct SweepOptions
{
    std::string config;
    PlanKind plan = PlanKind::Grid;
    int count = 20;
    int seed = 1;
    SweepOptimiser optimiser = SweepOptimiser::NelderMead;
    std::string goal = "max hota.hota";
    std::string metrics = "hota.hota, identity.idf1, errors.position_m.median";
    int maxRuns = 1000;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.config, "config",
              "configuration that the settings change, beside this file; empty: built-in values");
        field(self.plan, "plan", "settings to run: all, some drawn ones, or a search");
        field(self.count, "count", 1, 1000000, "random, optimise: settings");
        field(self.seed, "seed", 0, 2147483647, "random: of the draw");
        field(self.optimiser, "optimiser", "optimise: algorithm of NLopt");
        field(self.goal, "goal", "'max' or 'min' and the metric that tells the best setting");
        field(self.metrics, "metrics", "metrics to keep, in this order");
        field(self.maxRuns, "max_runs", 1, 100000000,
              "most runs that the plan may come to: recordings times settings");
    }
};

/// Section [slurm]: how the runs are submitted to a cluster.
struct SlurmOptions
{
    std::string partition;
    int minutes = 60;
    int memoryMb = 2000;
    int cores = 1;
    int atOnce = 0;
    int retries = 1;
    int arraySize = 1000;
    double pollSeconds = 5.0;
    double patience = 600.0;
    std::string extra;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.partition, "partition", "to submit to; empty: the cluster's default");
        field(self.minutes, "time_min", 1, 100000, "limit of a run");
        field(self.memoryMb, "memory_mb", 1, 10000000, "of a run");
        field(self.cores, "cores", 1, 1024, "of a run");
        field(self.atOnce, "at_once", 0, 100000, "most runs at a time in an array; 0: no limit");
        field(self.retries, "retries", 0, 100,
              "how often a run is submitted again that was killed or lost");
        field(self.arraySize, "array_size", 1, 1000000,
              "runs in an array at most (the cluster's MaxArraySize - 1 or less)");
        field(self.pollSeconds, "poll_s", 0.05, 3600.0, "time between two looks at the queue");
        field(self.patience, "patience_s", 0.0, 1e6,
              "how long a controller may be out of reach before the sweep gives up");
        field(self.extra, "extra", "more options of sbatch, separated by blanks");
    }
};

/// Section [recordings <name>]: rawlogs that belong together.
struct RecordingGroup
{
    std::string name;
    std::string rawlogs;
    std::string truth = "{folder}/{stem}_truth.csv";
    std::string set;
    int setLine = 0;  ///< of `set`, in the sweep's file
    FrameRange frames;
    RunScoring score;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.rawlogs, "rawlogs", "rawlogs, beside this file: names or patterns with * and ?");
        field(self.truth, "truth",
              "their truth: {folder} and {stem} stand for those of the rawlog's name");
        field(self.set, "set",
              "section.key=value over the configuration for these recordings, by commas");
        FrameRange::visit(self.frames, field);
        RunScoring::visit(self.score, field);
    }
};

struct SweepGoal
{
    std::string metric;
    bool highest = true;
};

struct SweepFile
{
    std::filesystem::path path;
    SweepOptions sweep;
    SlurmOptions slurm;
    std::vector<RecordingGroup> groups;
    std::vector<SweptKey> keys;
    std::vector<std::string> metrics;  ///< of `sweep.metrics`, and that of the goal
    SweepGoal goal;

    /// A path of the file as seen from the working directory.
    std::filesystem::path resolved(const std::filesystem::path& named) const
    {
        return named.is_absolute() ? named : path.parent_path() / named;
    }
};

/// Reads and checks all that can be known without the recordings and the configuration. Throws
/// std::runtime_error that lists every problem with file, line and key.
SweepFile readSweepFile(const std::filesystem::path& path);

}  // namespace vdamf
