// SPDX-License-Identifier: BSD-3-Clause
#include "slurm_queue.h"

#include <map>
#include <stdexcept>

#include "split.h"
#include "vdamf/experiments/digest.h"
#include "vdamf/experiments/process.h"
#include "vdamf/files/folder.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

// Line of the list by the task's index in the array, then the worker's words.
constexpr const char* kScript =
    "#!/bin/sh\n"
    "list=$1; shift\n"
    "task=$(sed -n \"$((SLURM_ARRAY_TASK_ID + 1))p\" \"$list\")\n"
    "[ -n \"$task\" ] && [ -d \"$task\" ] || exit 0  # done by an earlier attempt\n"
    "exec \"$@\" \"$task\" > \"$task/log.txt\" 2>&1\n";

std::vector<std::string> linesOf(const fs::path& list)
{
    std::error_code ignored;
    return fs::exists(list, ignored) ? split(readTextFile(list), '\n') : std::vector<std::string>();
}
}  // namespace

SlurmQueue::SlurmQueue(WorkerCommand worker, SlurmOptions options, fs::path folder)
    : worker_(std::move(worker)),
      options_(std::move(options)),
      folder_(fs::absolute(folder)),
      name_("vdamf-sweep-" + digestOf(folder_.string()).substr(0, 12))
{
    makeFolder(folder_);
    writeTextFile(folder_ / "task.sh", kScript);
}

bool SlurmQueue::call(const std::vector<std::string>& command)
{
    const fs::path answer = folder_ / "answer.txt";
    fs::remove(answer);
    const int exitCode = ChildProcess(command, answer).wait();
    message_ = std::string(trimmed(readTextFile(answer)));
    return exitCode == 0;
}

fs::path SlurmQueue::nextList() const
{
    for (int number = 1;; ++number)
    {
        const fs::path list = folder_ / ("list-" + std::to_string(number) + ".txt");
        if (!fs::exists(list)) return list;
    }
}

std::vector<std::string> SlurmQueue::sbatchCommand(const fs::path& list, std::size_t count)
{
    const std::string limit = options_.atOnce > 0 ? "%" + std::to_string(options_.atOnce) : "";
    std::vector<std::string> command = {"sbatch",
                                        "--parsable",
                                        "--job-name=" + name_,
                                        "--comment=" + list.filename().string(),
                                        "--array=0-" + std::to_string(count - 1) + limit,
                                        "--time=" + std::to_string(options_.minutes),
                                        "--mem=" + std::to_string(options_.memoryMb) + "M",
                                        "--cpus-per-task=" + std::to_string(options_.cores),
                                        "--open-mode=append",
                                        "--output=" + (folder_ / "messages.txt").string()};
    if (!options_.partition.empty()) command.push_back("--partition=" + options_.partition);
    for (const std::string& word : split(options_.extra, ' '))
        if (!word.empty()) command.push_back(word);
    command.insert(command.end(), {(folder_ / "task.sh").string(), list.string()});
    command.insert(command.end(), worker_.begin(), worker_.end());
    return command;
}

bool SlurmQueue::submitArray(const std::vector<fs::path>& tasks)
{
    std::string lines;
    for (const fs::path& task : tasks) lines += task.string() + "\n";
    const fs::path list = nextList();
    writeTextFile(list, lines);
    if (call(sbatchCommand(list, tasks.size()))) return true;
    const std::string refusal = message_;
    fs::remove(list);
    if (queued())  // it answers: the job itself is what it does not take
        throw std::runtime_error("sbatch: " + refusal + "; see [slurm] in the sweep's file");
    message_ = refusal;
    return false;
}

std::vector<std::string> SlurmQueue::submit(const std::vector<fs::path>& tasks)
{
    const auto size = static_cast<std::size_t>(options_.arraySize);
    std::vector<std::string> jobs;
    for (std::size_t begin = 0; begin < tasks.size(); begin += size)
    {
        const std::size_t end = std::min(tasks.size(), begin + size);
        const auto at = [&tasks](std::size_t i)
        { return tasks.begin() + static_cast<std::ptrdiff_t>(i); };
        if (!submitArray({at(begin), at(end)})) break;
        const std::string array = split(message_, ';').front();  // "<job>" or "<job>;<cluster>"
        for (std::size_t i = begin; i < end; ++i)
            jobs.push_back(array + "_" + std::to_string(i - begin));
    }
    return jobs;
}

std::optional<std::vector<QueuedTask>> SlurmQueue::queued()
{
    if (!call({"squeue", "-h", "-r", "--name=" + name_, "-o", "%k|%F|%K"})) return std::nullopt;
    std::map<std::string, std::vector<std::string>> lists;
    std::vector<QueuedTask> tasks;
    for (const std::string& line : split(message_, '\n'))
    {
        const std::vector<std::string> parts = split(line, '|');
        const auto index = parts.size() == 3 ? parseInteger(parts[2]) : std::nullopt;
        if (!index) continue;
        const auto known = lists.try_emplace(parts[0]).first;
        if (known->second.empty()) known->second = linesOf(folder_ / parts[0]);
        const auto place = static_cast<std::size_t>(*index);
        if (place >= known->second.size()) continue;
        tasks.push_back({known->second[place], parts[1] + "_" + parts[2]});
    }
    return tasks;
}

std::string SlurmQueue::endOf(const std::string& job)
{
    if (!call({"scontrol", "-o", "show", "job", job})) return "";
    const std::string mark = "JobState=";
    const std::size_t begin = message_.find(mark);
    if (begin == std::string::npos) return "";
    const std::size_t end = message_.find(' ', begin);
    return message_.substr(begin + mark.size(), end - begin - mark.size());
}

void SlurmQueue::cancel()
{
    call({"scancel", "--name=" + name_});
}

}  // namespace vdamf
