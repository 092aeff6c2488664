// SPDX-License-Identifier: BSD-3-Clause
// A folder with the street twice, cut to its first frames by the sweeps that use it.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/command_line.h"
#include "files/temporary_folder.h"
#include "vdamf/experiments/sweep.h"

namespace vdamf
{
class SweepFolder : public TemporaryFolder
{
protected:
    SweepFolder()
    {
        const std::filesystem::path street = VDAMF_SOURCE_DIR "/datasets/street";
        for (const std::string name : {"one", "two"})
        {
            std::filesystem::create_directories(at("data"));
            std::filesystem::create_symlink(street / "street.rawlog",
                                            at("data/" + name + ".rawlog"));
            std::filesystem::create_symlink(street / "truth.csv",
                                            at("data/" + name + "_truth.csv"));
        }
    }

    /// A sweep's file of sections that differ from test to test.
    std::filesystem::path sweepFile(const std::string& sweep, const std::string& vary,
                                    const std::string& recordings = kRecordings) const
    {
        return make("sweep.ini", "[sweep]\n" + sweep + "\n[vary]\n" + vary + "\n[recordings]\n" +
                                     recordings + "\n");
    }

    std::string problemOf(const std::filesystem::path& file) const
    {
        return errorOf([&] { prepareSweep(file); });
    }

    static constexpr const char* kRecordings =
        "rawlogs = data/*.rawlog\ntruth = {folder}/{stem}_truth.csv\nlast_frame = 12";
};

}  // namespace vdamf
