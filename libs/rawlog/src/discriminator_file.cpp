// SPDX-License-Identifier: BSD-3-Clause
#include "discriminator_file.h"

#include <filesystem>
#include <stdexcept>

#include "named_file.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
std::shared_ptr<const DiscriminatorModel> discriminatorFromFile(
    const DiscriminatorOptions& options, const std::string& configurationFile)
{
    if (options.model.empty() || options.isOff()) return nullptr;
    constexpr std::size_t kLargest = std::size_t{16} << 20;
    const std::filesystem::path path = namedFile(options.model, configurationFile);
    try
    {
        return std::make_shared<const DiscriminatorModel>(
            parseDiscriminatorModel(readTextFile(path, kLargest), path.string()));
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error("discriminator.model: " + std::string(error.what()));
    }
}

}  // namespace vdamf
