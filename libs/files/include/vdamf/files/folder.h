// SPDX-License-Identifier: BSD-3-Clause
// Folders for outputs.
#pragma once

#include <filesystem>

namespace vdamf
{
/// With all above it; it may be there. Throws std::runtime_error that names it.
void makeFolder(const std::filesystem::path& folder);

}  // namespace vdamf
