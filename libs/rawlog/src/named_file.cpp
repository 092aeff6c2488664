// SPDX-License-Identifier: BSD-3-Clause
#include "named_file.h"

namespace vdamf
{
std::filesystem::path namedFile(const std::string& name,
                                const std::filesystem::path& configurationFile)
{
    if (name.empty()) return {};
    const std::filesystem::path beside = configurationFile.parent_path() / name;
    return std::filesystem::exists(beside) ? beside : std::filesystem::path(name);
}

}  // namespace vdamf
