// SPDX-License-Identifier: BSD-3-Clause
// The model file that [discriminator] of a configuration names.
#pragma once

#include <memory>

#include "vdamf/tracking/discrimination/options.h"

namespace vdamf
{
/// Nothing where no file is named. Throws std::runtime_error where the file cannot be read or is no
/// model.
std::shared_ptr<const DiscriminatorModel> discriminatorFromFile(
    const DiscriminatorOptions& options);

}  // namespace vdamf
