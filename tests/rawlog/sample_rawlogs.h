// SPDX-License-Identifier: BSD-3-Clause
// Where MRPT's sample rawlogs are: installed with its programs, or beside the recordings.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace vdamf::test
{
/// The path of a sample; empty where it is not installed.
inline std::filesystem::path sampleRawlog(const std::string& name)
{
    std::vector<std::filesystem::path> folders{"/usr/share/mrpt/datasets"};
    if (const char* data = std::getenv("VDAMF_DATA_DIR"))
    {
        folders.emplace_back(std::filesystem::path(data) / "mrpt_rawlogs");
    }
    for (const auto& folder : folders)
    {
        std::error_code ignored;
        if (std::filesystem::exists(folder / name, ignored)) return folder / name;
    }
    return {};
}

inline std::string whereSamplesAre()
{
    return "sample rawlogs not found: install mrpt-apps, or set VDAMF_DATA_DIR to a folder that "
           "holds them as mrpt_rawlogs/";
}

}  // namespace vdamf::test
