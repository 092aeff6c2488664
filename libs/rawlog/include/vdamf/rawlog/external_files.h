// SPDX-License-Identifier: BSD-3-Clause
// Where the files are that observations of a rawlog keep their points in.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace vdamf
{
/// Folders that are searched, the first one first. Observations name their files relative to a
/// folder that MRPT calls `<rawlog>_Images`.
class ExternalFiles
{
public:
    /// Bytes of one allocation while such a file is loaded.
    static constexpr std::size_t kLargestAllocation = std::size_t{256} << 20;

    ExternalFiles() = default;
    /// Of a rawlog: `<name>_Images`, `_images` and `_IMAGES` beside it (<name>: without .rawlog and
    /// .gz), its own folder, the current one.
    explicit ExternalFiles(const std::filesystem::path& rawlog);

    /// The file of that name, as an absolute path; only the last part of a name from another
    /// machine may be found. Throws std::runtime_error that says where it was searched.
    std::filesystem::path find(const std::string& name) const;

private:
    std::vector<std::filesystem::path> folders_;
};

}  // namespace vdamf
