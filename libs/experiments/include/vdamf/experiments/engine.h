// SPDX-License-Identifier: BSD-3-Clause
// What carries out the runs of a sweep.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "vdamf/experiments/sweep_file.h"

namespace vdamf
{
struct EngineTask
{
    std::filesystem::path folder;  ///< with the order (run_task.h)
    std::filesystem::path result;  ///< exists when the run is done
};

/// Told of each task once, when it is done or given up; `failure` is empty when it is done.
using TaskListener = std::function<void(std::size_t task, const std::string& failure)>;

/// Carries out all tasks in any order and returns when each has been told of, or soon after `stop`
/// is set: then runs in progress are ended, and are not told of. A task that fails does not stop
/// the others. Throws std::runtime_error where no task can be carried out any more.
using Engine = std::function<void(const std::vector<EngineTask>& tasks,
                                  const std::atomic<bool>& stop, const TaskListener& finished)>;

/// The program that performs a task: its words, to which the task folder is added.
using WorkerCommand = std::vector<std::string>;

/// Runs `jobs` processes of the worker at a time on this machine. A process that crashes is one
/// failed run.
Engine localEngine(const WorkerCommand& worker, unsigned jobs);

/// Runs the worker in array jobs of a Slurm cluster that sees the same folders. `folder`: for lists
/// of tasks and what tasks print, kept between sweeps. Tasks that are in the queue already, because
/// an earlier sweep in the same folder was killed, are waited for and not submitted again. A task
/// that is killed or lost is submitted again as often as the options say; one whose run fails by
/// itself is not, it would fail again. When the controller does not answer, `warn` is told once,
/// and it is asked again until the options' patience is over. `stop` cancels the jobs.
Engine slurmEngine(const WorkerCommand& worker, const SlurmOptions& options,
                   const std::filesystem::path& folder,
                   const std::function<void(const std::string& line)>& warn);

}  // namespace vdamf
