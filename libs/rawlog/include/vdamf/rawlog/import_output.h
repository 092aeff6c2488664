// SPDX-License-Identifier: BSD-3-Clause
// What all imports have in common: the rawlog that they write.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "vdamf/files/output_file.h"

namespace vdamf
{
struct ImportOutput
{
    std::filesystem::path rawlog;
    OutputFile::Existing existing = OutputFile::Existing::Refuse;
    int gzLevel = 1;  ///< 0: plain, 1..9
    /// Called after each scan with the scans done and the share of the work, 0..1; false stops the
    /// import, which then leaves nothing.
    std::function<bool(std::size_t, double)> progress;
};

}  // namespace vdamf
