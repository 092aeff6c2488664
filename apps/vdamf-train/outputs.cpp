// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

namespace vdamf
{
Outputs::Outputs(const std::vector<std::filesystem::path>& paths, bool overwrite)
{
    const auto existing =
        overwrite ? OutputFile::Existing::Overwrite : OutputFile::Existing::Refuse;
    for (const std::filesystem::path& path : paths)
        files_.try_emplace(path, path, existing, OutputFile::Unfinished::Discard);
}

void Outputs::write(const std::filesystem::path& path, const std::string& text)
{
    OutputFile& file = files_.at(path);
    file.write(text);
    file.commit();
}

}  // namespace vdamf
