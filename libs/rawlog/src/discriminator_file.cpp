// SPDX-License-Identifier: BSD-3-Clause
#include "discriminator_file.h"

#include <stdexcept>

#include "vdamf/files/text_file.h"

namespace vdamf
{
std::shared_ptr<const DiscriminatorModel> discriminatorFromFile(const DiscriminatorOptions& options)
{
    if (options.model.empty() || options.isOff()) return nullptr;
    constexpr std::size_t kLargest = std::size_t{16} << 20;
    try
    {
        return std::make_shared<const DiscriminatorModel>(
            parseDiscriminatorModel(readTextFile(options.model, kLargest), options.model));
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error("discriminator.model: " + std::string(error.what()));
    }
}

}  // namespace vdamf
