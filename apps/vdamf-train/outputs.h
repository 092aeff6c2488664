// SPDX-License-Identifier: BSD-3-Clause
// The files that a training writes: refused before the work, not after it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "vdamf/files/output_file.h"

namespace vdamf
{
class Outputs
{
public:
    /// Opens all. Throws std::runtime_error that names a file which is
    /// there already, unless `overwrite`, or cannot be written.
    Outputs(const std::vector<std::filesystem::path>& paths, bool overwrite);

    /// The whole of one of them, which appears now.
    void write(const std::filesystem::path& path, const std::string& text);

private:
    std::map<std::filesystem::path, OutputFile> files_;
};

}  // namespace vdamf
