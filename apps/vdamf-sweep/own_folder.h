// SPDX-License-Identifier: BSD-3-Clause
// Whose folder it is that a sweep is to work in: what is not a sweep's stays as it is.
#pragma once

#include <filesystem>
#include <vector>

#include "vdamf/files/output_file.h"

namespace vdamf
{
/// The file that makes a folder a sweep's own.
constexpr const char* kFolderMark = "vdamf-sweep.txt";

/// True where a sweep has made the folder its own: what it writes and removes there is a sweep's.
bool isOwnFolder(const std::filesystem::path& folder);

/// Throws std::runtime_error that names the first file or folder of those that a sweep writes or
/// removes, where it is there and the folder is not a sweep's own.
void checkFolder(const std::filesystem::path& folder);

/// Makes a folder that is there, and passes checkFolder(), a sweep's own.
void claimFolder(const std::filesystem::path& folder);

/// Throws std::runtime_error where an input lies in what a sweep removes in its own folder: the
/// tasks that it does, and the runs where it is to forget them.
void checkRemoved(const std::filesystem::path& folder, bool forgets,
                  const std::vector<NamedInput>& inputs);

/// Removes the runs and tasks of a sweep's own folder, by their names: other files stay.
void forgetRuns(const std::filesystem::path& folder);

}  // namespace vdamf
