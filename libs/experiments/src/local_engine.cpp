// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <csignal>
#include <list>
#include <thread>

#include "vdamf/experiments/engine.h"
#include "vdamf/experiments/process.h"
#include "vdamf/experiments/run_task.h"

namespace vdamf
{
namespace
{
constexpr std::chrono::milliseconds kPoll{10};

struct Running
{
    std::size_t task;
    ChildProcess process;
};

std::string outcomeOf(const EngineTask& task, int exitCode)
{
    if (exitCode == 0 && std::filesystem::exists(task.result)) return "";
    if (const auto own = failureOf(task.folder)) return *own;
    const std::filesystem::path log = task.folder / kLogFile;
    const std::string words = lastWords(log);
    return "the run " + exitInWords(exitCode) + " (" + log.string() + ")" +
           (words.empty() ? "" : ": " + words);
}

ChildProcess started(const WorkerCommand& worker, const EngineTask& task)
{
    prepareAttempt(task.folder);
    WorkerCommand command = worker;
    command.push_back(task.folder.string());
    return {command, task.folder / kLogFile};
}

void endAll(std::list<Running>& running)
{
    for (Running& one : running) one.process.signal(SIGTERM);
    for (Running& one : running) one.process.wait();
}
}  // namespace

Engine localEngine(const WorkerCommand& worker, unsigned jobs)
{
    return [=](const std::vector<EngineTask>& tasks, const std::atomic<bool>& stop,
               const TaskListener& finished)
    {
        std::list<Running> running;
        std::size_t next = 0;
        while (!stop && (next < tasks.size() || !running.empty()))
        {
            for (; running.size() < jobs && next < tasks.size(); ++next)
                running.push_back({next, started(worker, tasks[next])});
            std::this_thread::sleep_for(kPoll);
            for (auto one = running.begin(); one != running.end();)
            {
                const std::optional<int> exitCode = one->process.poll();
                if (exitCode) finished(one->task, outcomeOf(tasks[one->task], *exitCode));
                one = exitCode ? running.erase(one) : std::next(one);
            }
        }
        endAll(running);
    };
}

}  // namespace vdamf
