// SPDX-License-Identifier: BSD-3-Clause
// Runs vdamf-sweep on two short pieces of the street.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "apps/command_line.h"
#include "files/temporary_folder.h"

namespace vdamf
{
class SweepProgram : public TemporaryFolder
{
protected:
    /// Sections [sweep] and [vary], and more behind the recordings.
    void writeSweep(const std::string& sweep, const std::string& vary,
                    const std::string& more = "") const
    {
        const std::string street = VDAMF_SOURCE_DIR "/datasets/street/";
        const std::string recording =
            "rawlogs = " + street + "street.rawlog\ntruth = " + street + "truth.csv\n";
        make("sweep.ini", "[sweep]\nmetrics = hota.hota, errors.position_m.median\n" + sweep +
                              "\n[vary]\n" + vary + "\n[recordings]\n" + recording +
                              "first_frame = 20\nlast_frame = 28\n" + more);
    }

    std::string arguments(const std::string& folder) const
    {
        return "-c '" + at("sweep.ini").string() + "' -o '" + at(folder).string() + "'";
    }

    Outcome sweep(const std::string& folder, const std::string& more = "") const
    {
        return runApp("vdamf-sweep", arguments(folder) + " " + more);
    }

    std::size_t runsIn(const std::string& folder) const
    {
        std::error_code missing;
        const std::filesystem::directory_iterator runs(at(folder) / "runs", missing);
        return missing ? 0 : static_cast<std::size_t>(std::distance(begin(runs), end(runs)));
    }

    static bool waitFor(const std::function<bool()>& condition)
    {
        for (int i = 0; i < 3000 && !condition(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return condition();
    }

    /// The program in the background, its output in `out.txt`; its process.
    pid_t start(const std::string& folder, const std::string& more = "") const
    {
        const std::string command = "exec '" VDAMF_APPS_DIR "/vdamf-sweep' " + arguments(folder) +
                                    " " + more + " > '" + at("out.txt").string() + "' 2>&1";
        const pid_t process = ::fork();
        if (process == 0)
        {
            ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
            ::_exit(127);
        }
        return process;
    }

    static int waitForExit(pid_t process)
    {
        int status = 0;
        ::waitpid(process, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
};

}  // namespace vdamf
