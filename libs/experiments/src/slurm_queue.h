// SPDX-License-Identifier: BSD-3-Clause
// The jobs of one sweep in a Slurm cluster, through its programs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/experiments/engine.h"
#include "vdamf/experiments/sweep_file.h"

namespace vdamf
{
struct QueuedTask
{
    std::filesystem::path folder;  ///< of the task
    std::string job;               ///< "<array job>_<index>"
};

/// All that is known of the jobs stands in the queue (they have the sweep's name, and the name of
/// their list as comment) and in the lists of task folders, so that a sweep that was killed finds
/// its jobs again.
class SlurmQueue
{
public:
    SlurmQueue(WorkerCommand worker, SlurmOptions options, std::filesystem::path folder);

    /// In array jobs of at most the options' size. The jobs of the tasks, in their order: fewer
    /// where the controller could not be reached for the rest. Throws std::runtime_error with
    /// Slurm's words where a job is refused.
    std::vector<std::string> submit(const std::vector<std::filesystem::path>& tasks);

    /// What waits or runs; nothing: the controller cannot be reached.
    std::optional<std::vector<QueuedTask>> queued();

    /// "TIMEOUT", "CANCELLED" ... of a job that has left the queue; empty: Slurm forgot it.
    std::string endOf(const std::string& job);

    void cancel();

    /// What Slurm said last.
    const std::string& message() const { return message_; }

private:
    bool call(const std::vector<std::string>& command);
    bool submitArray(const std::vector<std::filesystem::path>& tasks);
    std::vector<std::string> sbatchCommand(const std::filesystem::path& list, std::size_t count);
    std::filesystem::path nextList() const;

    WorkerCommand worker_;
    SlurmOptions options_;
    std::filesystem::path folder_;
    std::string name_;
    std::string message_;
};

}  // namespace vdamf
