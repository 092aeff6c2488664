// SPDX-License-Identifier: BSD-3-Clause
#include "worker.h"

#include <sys/prctl.h>

#include <csignal>
#include <cstdio>
#include <exception>

#include "summary.h"
#include "vdamf/experiments/run_task.h"

namespace vdamf
{
int work(const std::filesystem::path& taskFolder)
{
    // A sweep that is killed takes its runs along; Ctrl-C and a closed terminal are for the sweep,
    // which ends them.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::signal(SIGINT, SIG_IGN);
    std::signal(SIGHUP, SIG_IGN);
    try
    {
        performTask(taskFolder,
                    [](const TrackRawlogSummary& summary, const RunTask& task)
                    {
                        warn(summary, task.rawlog);
                        printSummary(stdout, summary);
                    });
        return 0;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

}  // namespace vdamf
