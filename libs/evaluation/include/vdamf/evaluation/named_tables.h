// SPDX-License-Identifier: BSD-3-Clause
// Errors of scoring that say which files they are about.
#pragma once

#include <filesystem>
#include <stdexcept>

namespace vdamf
{
/// What `score` throws, with the names of the truth and of what holds the tracks before it.
template <class Score>
auto namingTables(const std::filesystem::path& truth, const std::filesystem::path& tracks,
                  const Score& score)
{
    try
    {
        return score();
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error("truth " + truth.string() + ", tracks " + tracks.string() + ": " +
                                 error.what());
    }
}

}  // namespace vdamf
