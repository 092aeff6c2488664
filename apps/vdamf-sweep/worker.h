// SPDX-License-Identifier: BSD-3-Clause
// The part of a worker process: one run of a sweep.
#pragma once

#include <filesystem>

namespace vdamf
{
/// Performs the task of a folder; what there is to say goes to stdout and stderr, which the engine
/// leads to the task's log. The exit code.
int work(const std::filesystem::path& taskFolder);

}  // namespace vdamf
