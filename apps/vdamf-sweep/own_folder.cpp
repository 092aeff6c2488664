// SPDX-License-Identifier: BSD-3-Clause
#include "own_folder.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "outputs.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* kFirstLine = "This is a folder of vdamf-sweep.";
constexpr const char* kMarkText =
    "\nEach sweep in it replaces sweep.ini, table.csv, times.csv, report.html and best.ini, and\n"
    "--no-resume removes the runs. Without this file vdamf-sweep leaves the folder alone.\n";

bool isThere(const fs::path& path)
{
    std::error_code unknown;
    return fs::exists(fs::symlink_status(path, unknown));
}

// The names that runId() gives.
bool isRunName(const std::string& name)
{
    constexpr std::size_t kDigits = 32;
    return name.size() == kDigits &&
           name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

// By its name or, where that is a link, by the file that it leads to.
bool liesIn(const fs::path& folder, const fs::path& file)
{
    const fs::path place = fs::weakly_canonical(fs::absolute(folder));
    const fs::path name = fs::absolute(file).lexically_normal();
    for (const fs::path& path :
         {fs::weakly_canonical(name.parent_path()), fs::weakly_canonical(name).parent_path()})
    {
        const auto common = std::mismatch(place.begin(), place.end(), path.begin(), path.end());
        if (common.first == place.end()) return true;
    }
    return false;
}

void removeRunsOf(const fs::path& folder)
{
    if (!fs::is_directory(folder)) return;
    std::vector<fs::path> runs;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (isRunName(entry.path().filename().string())) runs.push_back(entry.path());
    for (const fs::path& run : runs) fs::remove_all(run);
}
}  // namespace

bool isOwnFolder(const fs::path& folder)
{
    std::string line;
    std::ifstream mark(folder / kFolderMark);
    return std::getline(mark, line) && line == kFirstLine;
}

void checkFolder(const fs::path& folder)
{
    if (isOwnFolder(folder)) return;
    std::vector<fs::path> paths;
    for (const std::string& name : outputNames())
        for (const fs::path& path : {folder / name, partialPathOf(folder / name)})
            paths.push_back(path);
    for (const char* name : {kFolderMark, "runs", "tasks", "slurm"}) paths.push_back(folder / name);
    const auto found = std::find_if(paths.begin(), paths.end(), isThere);
    if (found == paths.end()) return;
    throw std::runtime_error(found->string() + ": is there already, and " + folder.string() +
                             " is no folder of a sweep (none has written a " + kFolderMark +
                             " there); name another folder with -o");
}

void claimFolder(const fs::path& folder)
{
    if (isOwnFolder(folder)) return;
    checkFolder(folder);
    writeTextFile(folder / kFolderMark, std::string(kFirstLine) + kMarkText);
}

void checkRemoved(const fs::path& folder, bool forgets, const std::vector<NamedInput>& inputs)
{
    for (const NamedInput& input : inputs)
    {
        if (input.path.empty()) continue;
        const bool isRemoved = liesIn(folder / "tasks", input.path) ||
                               (forgets && liesIn(folder / "runs", input.path));
        if (isRemoved)
            throw std::runtime_error(input.path.string() + ": is " + input.name +
                                     ", and would be removed; copy it to another folder than " +
                                     folder.string());
    }
}

void forgetRuns(const fs::path& folder)
{
    if (!isOwnFolder(folder)) return;
    removeRunsOf(folder / "runs");
    removeRunsOf(folder / "tasks");
}

}  // namespace vdamf
