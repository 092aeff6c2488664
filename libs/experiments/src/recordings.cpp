// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/recordings.h"

#include <glob.h>

#include <algorithm>
#include <stdexcept>

#include "split.h"
#include "vdamf/files/csv.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

std::vector<fs::path> filesOf(const fs::path& pattern)
{
    ::glob_t found = {};
    std::vector<fs::path> files;
    if (::glob(pattern.c_str(), 0, nullptr, &found) == 0)
        for (std::size_t i = 0; i < found.gl_pathc; ++i)
            if (fs::is_regular_file(found.gl_pathv[i])) files.emplace_back(found.gl_pathv[i]);
    ::globfree(&found);
    return files;
}

// Without extensions: "a.rawlog.gz" is "a".
std::string stemOf(const fs::path& rawlog)
{
    const fs::path stem = rawlog.stem();
    return (stem.extension() == ".rawlog" ? stem.stem() : stem).string();
}

std::string replaced(std::string text, const std::string& mark, const std::string& value)
{
    for (std::size_t at = text.find(mark); at != std::string::npos;
         at = text.find(mark, at + value.size()))
        text.replace(at, mark.size(), value);
    return text;
}

fs::path truthOf(const SweepFile& file, const RecordingGroup& group, const fs::path& rawlog)
{
    const std::string named = replaced(group.truth, "{folder}", rawlog.parent_path().string());
    return fs::absolute(file.resolved(replaced(named, "{stem}", stemOf(rawlog))))
        .lexically_normal();
}

// The stem behind the names of so many folders.
std::string nameWith(const fs::path& rawlog, int folders)
{
    std::string name = stemOf(rawlog);
    fs::path folder = rawlog.parent_path();
    for (int i = 0; i < folders && folder.has_filename(); ++i, folder = folder.parent_path())
        name = folder.filename().string() + "/" + name;
    return name;
}

bool areUnique(std::vector<SweepRecording> recordings)
{
    const auto byName = [](const SweepRecording& a, const SweepRecording& b)
    { return a.name < b.name; };
    std::sort(recordings.begin(), recordings.end(), byName);
    const auto same = [](const SweepRecording& a, const SweepRecording& b)
    { return a.name == b.name; };
    return std::adjacent_find(recordings.begin(), recordings.end(), same) == recordings.end();
}

// As few folders as tell all of them apart.
void giveNames(std::vector<SweepRecording>& recordings)
{
    constexpr int kMostFolders = 20;
    for (int folders = 0; folders <= kMostFolders; ++folders)
    {
        for (SweepRecording& recording : recordings)
            recording.name = cellText(nameWith(recording.rawlog, folders));
        if (areUnique(recordings)) return;
    }
}

class Finder
{
public:
    explicit Finder(const SweepFile& file) : file_(file) {}

    void find(std::size_t index)
    {
        for (const std::string& pattern : split(file_.groups[index].rawlogs, ','))
        {
            const std::vector<fs::path> files = filesOf(file_.resolved(pattern));
            if (files.empty())
                note(file_.groups[index],
                     "rawlogs: no file is called " + file_.resolved(pattern).string());
            for (const fs::path& rawlog : files) add(rawlog, index);
        }
    }

    std::vector<SweepRecording> recordings() &&
    {
        if (!problems_.empty()) throw std::runtime_error(problems_);
        giveNames(recordings_);
        return std::move(recordings_);
    }

private:
    void note(const RecordingGroup& group, const std::string& problem)
    {
        problems_ += (problems_.empty() ? "" : "\n") + file_.path.string() + ": [recordings" +
                     (group.name.empty() ? "" : " " + group.name) + "] " + problem;
    }

    void add(const fs::path& named, std::size_t index)
    {
        const RecordingGroup& group = file_.groups[index];
        const fs::path rawlog = fs::absolute(named).lexically_normal();
        for (const SweepRecording& other : recordings_)
            if (other.rawlog == rawlog)
                return note(group, "rawlogs: " + rawlog.string() + " is found twice");
        const fs::path truth = truthOf(file_, group, rawlog);
        if (!fs::is_regular_file(truth))
            return note(group, "truth: " + rawlog.string() + " has none: " + truth.string() +
                                   " does not exist");
        recordings_.push_back({"", rawlog, truth, index, fs::file_size(rawlog)});
    }

    const SweepFile& file_;
    std::vector<SweepRecording> recordings_;
    std::string problems_;
};
}  // namespace

std::vector<SweepRecording> findRecordings(const SweepFile& file)
{
    Finder finder(file);
    for (std::size_t g = 0; g < file.groups.size(); ++g) finder.find(g);
    return std::move(finder).recordings();
}

}  // namespace vdamf
