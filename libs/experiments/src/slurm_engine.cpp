// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <stdexcept>
#include <thread>

#include "slurm_queue.h"
#include "split.h"
#include "vdamf/experiments/engine.h"
#include "vdamf/experiments/process.h"
#include "vdamf/experiments/run_task.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// A result may be seen late where the folders are shared over a network.
constexpr int kLooksUntilLost = 2;

struct Progress
{
    bool isTold = false;
    int attempts = 0;  ///< submitted, or found in the queue
    int looksWithout = 0;
    std::string job;  ///< the latest
};

class Supervisor
{
public:
    Supervisor(SlurmQueue& queue, const SlurmOptions& options, const std::vector<EngineTask>& tasks,
               const TaskListener& finished, const std::function<void(const std::string&)>& warn)
        : queue_(queue),
          options_(options),
          tasks_(tasks),
          finished_(finished),
          warn_(warn),
          progress_(tasks.size())
    {
    }

    bool isDone() const { return told_ == tasks_.size(); }

    /// One look at the queue, and what follows from it.
    void look()
    {
        const auto queued = queue_.queued();
        if (!queued) return wait();
        lastAnswer_ = Clock::now();
        isWaiting_ = false;
        std::map<fs::path, std::string> jobs;
        for (const QueuedTask& task : *queued) jobs[task.folder] = task.job;
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < tasks_.size(); ++i)
        {
            if (progress_[i].isTold) continue;
            const auto job = jobs.find(tasks_[i].folder);
            if (isToSubmit(i, job == jobs.end() ? "" : job->second)) open.push_back(i);
        }
        submit(open);
    }

private:
    void wait()
    {
        const auto now = Clock::now();
        if (std::chrono::duration<double>(now - lastAnswer_).count() > options_.patience)
            throw std::runtime_error(
                "Slurm's controller has not answered for " + toText(options_.patience) +
                " s: " + queue_.message() +
                (hasJobs() ? "; its jobs go on, start the sweep again to collect them"
                           : "; no job was submitted"));
        if (isWaiting_) return;
        isWaiting_ = true;
        warn_("Slurm's controller does not answer (" + split(queue_.message(), '\n').front() +
              "); it is asked again for " + toText(options_.patience) + " s (slurm.patience_s)");
    }

    bool hasJobs() const
    {
        return std::any_of(progress_.begin(), progress_.end(),
                           [](const Progress& one) { return !one.isTold && one.attempts > 0; });
    }

    bool isToSubmit(std::size_t i, const std::string& job)
    {
        Progress& progress = progress_[i];
        if (fs::exists(tasks_[i].result))
        {
            tell(i, "");
            return false;
        }
        if (!job.empty())
        {
            progress.job = job;
            progress.attempts = std::max(1, progress.attempts);
            progress.looksWithout = 0;
            return false;
        }
        if (progress.attempts == 0) return true;
        if (++progress.looksWithout < kLooksUntilLost) return false;
        return isToRetry(i);
    }

    // Of a task that left the queue without a result.
    bool isToRetry(std::size_t i)
    {
        if (const auto own = failureOf(tasks_[i].folder))
        {
            tell(i, *own);
            return false;
        }
        if (progress_[i].attempts <= options_.retries) return true;
        const fs::path log = tasks_[i].folder / kLogFile;
        const std::string end = queue_.endOf(progress_[i].job);
        const std::string words = fs::exists(log) ? lastWords(log) : "";
        tell(i, "job " + progress_[i].job + " ended" + (end.empty() ? "" : " as " + end) +
                    " without a result, attempt " + std::to_string(progress_[i].attempts) + " of " +
                    std::to_string(options_.retries + 1) + " (" + log.string() + ")" +
                    (words.empty() ? "" : ": " + words));
        return false;
    }

    void submit(const std::vector<std::size_t>& open)
    {
        if (open.empty()) return;
        std::vector<fs::path> folders;
        for (const std::size_t i : open)
        {
            prepareAttempt(tasks_[i].folder);
            folders.push_back(tasks_[i].folder);
        }
        const std::vector<std::string> jobs = queue_.submit(folders);
        for (std::size_t k = 0; k < jobs.size(); ++k)
        {
            Progress& progress = progress_[open[k]];
            ++progress.attempts;
            progress.looksWithout = 0;
            progress.job = jobs[k];
        }
    }

    void tell(std::size_t i, const std::string& failure)
    {
        progress_[i].isTold = true;
        ++told_;
        finished_(i, failure);
    }

    SlurmQueue& queue_;
    const SlurmOptions& options_;
    const std::vector<EngineTask>& tasks_;
    const TaskListener& finished_;
    const std::function<void(const std::string&)>& warn_;
    std::vector<Progress> progress_;
    std::size_t told_ = 0;
    Clock::time_point lastAnswer_ = Clock::now();
    bool isWaiting_ = false;  // for an answer, and has said so
};

// So that an interruption does not wait for the next look.
void sleepUnlessStopped(double seconds, const std::atomic<bool>& stop)
{
    constexpr std::chrono::milliseconds kStep{50};
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (!stop && Clock::now() < end) std::this_thread::sleep_for(kStep);
}
}  // namespace

Engine slurmEngine(const WorkerCommand& worker, const SlurmOptions& options, const fs::path& folder,
                   const std::function<void(const std::string& line)>& warn)
{
    return [=](const std::vector<EngineTask>& tasks, const std::atomic<bool>& stop,
               const TaskListener& finished)
    {
        SlurmQueue queue(worker, options, folder);
        Supervisor supervisor(queue, options, tasks, finished, warn);
        for (supervisor.look(); !stop && !supervisor.isDone(); supervisor.look())
            sleepUnlessStopped(options.pollSeconds, stop);
        if (stop) queue.cancel();
    };
}

}  // namespace vdamf
