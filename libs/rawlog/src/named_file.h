// SPDX-License-Identifier: BSD-3-Clause
// Files that a configuration names.
#pragma once

#include <filesystem>
#include <string>

namespace vdamf
{
/// A relative path is as seen from the configuration's folder, or, where there is no such file, as
/// given. Empty for an empty name.
std::filesystem::path namedFile(const std::string& name,
                                const std::filesystem::path& configurationFile);

}  // namespace vdamf
