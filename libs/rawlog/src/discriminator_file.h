// SPDX-License-Identifier: BSD-3-Clause
// The model file that [discriminator] of a configuration names.
#pragma once

#include <memory>
#include <string>

#include "vdamf/tracking/discrimination/options.h"

namespace vdamf
{
/// Nothing where no file is named. A relative name is looked for in the folder of the configuration
/// file, then in the current one. Throws std::runtime_error where the file cannot be read or is no
/// model.
std::shared_ptr<const DiscriminatorModel> discriminatorFromFile(
    const DiscriminatorOptions& options, const std::string& configurationFile);

}  // namespace vdamf
