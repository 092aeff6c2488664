// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track under faults: pipes that end or stay silent, and what is left of its outputs.
#pragma once

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "apps/limited_process.h"
#include "apps/track_fixture.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/annotation.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
// What a program may take before it ends, whatever is wrong with its files.
inline constexpr double kLongest = 10.0;    // s
inline constexpr double kLargest = 1024.0;  // MB

/// The writing end of a named pipe.
class Feed
{
public:
    explicit Feed(const std::filesystem::path& path) : descriptor_(::open(path.c_str(), O_WRONLY))
    {
    }
    ~Feed() { close(); }
    Feed(const Feed&) = delete;
    Feed& operator=(const Feed&) = delete;

    void write(std::string_view bytes)
    {
        while (!bytes.empty())
        {
            const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
            if (count <= 0) return;
            bytes.remove_prefix(static_cast<std::size_t>(count));
        }
    }
    void close()
    {
        if (descriptor_ >= 0) ::close(descriptor_);
        descriptor_ = -1;
    }

private:
    int descriptor_;
};

class Faults : public TrackProgram
{
protected:
    std::filesystem::path makePipe(const std::string& name) const
    {
        ::mkfifo(at(name).c_str(), 0600);
        return at(name);
    }

    static std::string street()
    {
        std::ifstream file(kStreet, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    /// The first entries of the street, not compressed.
    static std::string plainStreet(std::size_t bytes)
    {
        RawlogReader reader(kStreet);
        std::string plain;
        while (plain.size() < bytes) plain += reader.next()->bytes;
        return plain;
    }

    std::vector<std::string> job(const std::string& input) const
    {
        return {"-i", input, "-o", path("a.rawlog"), "--tracks", path("t.csv"), "--quiet"};
    }

    bool grows(const std::string& name, std::uintmax_t bytes) const
    {
        std::error_code ignored;
        for (int i = 0; i < 3000; ++i)
        {
            const std::uintmax_t size = std::filesystem::file_size(at(name), ignored);
            if (!ignored && size >= bytes) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }

    /// Different times in a table of tracks, which must be whole up to its last line break.
    std::size_t framesIn(const std::string& table) const
    {
        const std::string text = contentOf(table);
        make("whole.csv", text.substr(0, text.rfind('\n') + 1));
        std::set<double> times;
        for (const TrackRow& row : readTracks(at("whole.csv"))) times.insert(row.time);
        return times.size();
    }
};

/// Scans of a rawlog that have their table behind them, read as far as it goes.
inline std::size_t annotatedScans(const Contents& log)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < log.entries.size(); ++i)
    {
        const auto observation = log.as<mrpt::obs::CObservation>(i);
        count += observation && observation->sensorLabel == "vdamf_tracks" ? 1 : 0;
    }
    return count;
}

/// Entries that did not read whole, but for one that the file ends in.
inline std::size_t brokenEntries(const Contents& log)
{
    const auto broken = [](const RawlogEntry& e) { return e.kind == RawlogEntry::Kind::Damaged; };
    const auto end = log.entries.end() - (log.truncated && !log.entries.empty() ? 1 : 0);
    return static_cast<std::size_t>(std::count_if(log.entries.begin(), end, broken));
}

}  // namespace vdamf
