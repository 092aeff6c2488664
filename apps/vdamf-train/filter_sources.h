// SPDX-License-Identifier: BSD-3-Clause
// What filters are learned from: an ini file with sections [recording NAME] and [simulated NAME].
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recordings.h"

namespace vdamf
{
/// Section [recording NAME]: what the discriminator's has, and what filters need beside.
struct FilterRecordingOptions : RecordingKeys
{
    double rangeNoise = 0.02;   ///< m
    double labelPlace = 0.0;    ///< m
    double labelHeading = 0.0;  ///< rad
    int mostClusters = 300;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        RecordingKeys::visit(self, field);
        field(self.rangeNoise, "range_noise_m", 0.0, 1.0, "standard deviation of its ranges");
        field(self.labelPlace, "label_place_m", 0.0, 1.0, "error of the place of a labelled face");
        field(self.labelHeading, "label_heading_deg", 0.0, 20.0, "error of a labelled heading");
        field(self.mostClusters, "most_clusters", 1, 1000000, "evenly taken from all");
    }
};

using FilterRecording = RecordingWith<FilterRecordingOptions>;

/// Section [simulated NAME].
struct SimulatedOptions
{
    std::string kind;
    int clusters = 100;
    int seed = 1;
    RecordingUse use = RecordingUse::Train;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.kind, "kind", "condition; empty: all of them, a condition each");
        field(self.clusters, "clusters", 1, 1000000, "of each condition");
        field(self.seed, "seed", 0, 2147483647, "of what is drawn at random");
        field(self.use, "use", "what it is for");
    }
};

struct SimulatedSource
{
    std::string name;
    SimulatedOptions options;
};

struct FilterSources
{
    std::vector<FilterRecording> recordings;
    std::vector<SimulatedSource> simulated;
};

/// Throws IniError or std::runtime_error that names file and section.
FilterSources readFilterSources(const IniDocument& document);

}  // namespace vdamf
