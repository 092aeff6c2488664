// SPDX-License-Identifier: BSD-3-Clause
// Runs vdamf-track in a folder of its own and looks into rawlogs.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command_line.h"
#include "files/temporary_folder.h"
#include "vdamf/rawlog/rawlog_reader.h"

namespace vdamf
{
inline const std::string kStreet = VDAMF_SOURCE_DIR "/datasets/street/street.rawlog";

class TrackProgram : public TemporaryFolder
{
protected:
    Outcome track(const std::string& arguments) const { return runApp("vdamf-track", arguments); }
    std::string path(const std::string& name) const { return at(name).string(); }
    std::string in(const std::string& name) const { return " -i " + path(name); }
    std::string out(const std::string& name) const { return " -o " + path(name); }
};

struct Contents
{
    std::vector<RawlogEntry> entries;

    explicit Contents(const std::filesystem::path& file)
    {
        RawlogReader reader(file);
        while (auto entry = reader.next()) entries.push_back(std::move(*entry));
        truncated = reader.summary().truncated;
    }
    template <class T>
    std::shared_ptr<T> as(std::size_t i) const
    {
        return std::dynamic_pointer_cast<T>(entries[i].object);
    }
    bool truncated = false;
};

}  // namespace vdamf
