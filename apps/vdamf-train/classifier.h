// SPDX-License-Identifier: BSD-3-Clause
// The job of `vdamf-train classifier`.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "recordings.h"
#include "vdamf/learning/train.h"
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
struct ClassifierJob
{
    std::vector<Recording> recordings;
    Configuration configuration;
    TrainingOptions training;
    DiscriminationGrid grid;
    std::filesystem::path model;        ///< to write
    std::filesystem::path plots;        ///< folder to write; empty: none
    std::filesystem::path heldOut;      ///< table to write; empty: none
    std::vector<std::string> leaveOut;  ///< recordings or scenes to train without once, and test on
    bool overwrite = false;
    bool quiet = false;
    std::string version;
};

/// All files that the job writes.
std::vector<std::filesystem::path> outputsOf(const ClassifierJob& job);

/// Throws std::runtime_error for a name to leave out that no recording to train on has, or all
/// have.
void checkLeaveOut(const ClassifierJob& job);

/// Runs the job and prints what came out. Throws std::runtime_error.
void trainClassifier(const ClassifierJob& job, const std::atomic<bool>& stop);

}  // namespace vdamf
