// SPDX-License-Identifier: BSD-3-Clause
// The subcommands.
#pragma once

#include <memory>

#include "import_command.h"

namespace vdamf
{
std::unique_ptr<ImportCommand> kittiRawCommand();
std::unique_ptr<ImportCommand> velodynePcapCommand();
std::unique_ptr<ImportCommand> cloudsCommand();

}  // namespace vdamf
