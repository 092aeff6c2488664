// SPDX-License-Identifier: BSD-3-Clause
#include "own_folder.h"

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
    std::vector<std::string> names = outputNames();
    for (const char* name : {kFolderMark, "runs", "tasks", "slurm"}) names.emplace_back(name);
    for (const std::string& name : names)
        if (isThere(folder / name))
            throw std::runtime_error((folder / name).string() +
                                     ": is there already, and not of a sweep (without a " +
                                     kFolderMark + " of its own " + folder.string() +
                                     " is no folder of vdamf-sweep); name another folder with -o");
}

void claimFolder(const fs::path& folder)
{
    if (isOwnFolder(folder)) return;
    checkFolder(folder);
    writeTextFile(folder / kFolderMark, std::string(kFirstLine) + kMarkText);
}

void forgetRuns(const fs::path& folder)
{
    if (!isOwnFolder(folder)) return;
    removeRunsOf(folder / "runs");
    removeRunsOf(folder / "tasks");
}

}  // namespace vdamf
