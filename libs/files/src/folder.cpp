// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/folder.h"

#include <stdexcept>
#include <system_error>

namespace vdamf
{
void makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw std::runtime_error(folder.string() + ": cannot make this folder: " + error.message());
}

}  // namespace vdamf
