// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/external_files.h"

#include <stdexcept>

namespace vdamf
{
namespace fs = std::filesystem;

ExternalFiles::ExternalFiles(const fs::path& rawlog)
{
    std::error_code ignored;
    const fs::path absolute = fs::absolute(rawlog, ignored);
    fs::path stem = absolute.filename();
    for (const char* ending : {".gz", ".rawlog"})
        if (stem.extension() == ending) stem.replace_extension();
    for (const char* ending : {"_Images", "_images", "_IMAGES"})
        folders_.push_back(absolute.parent_path() / (stem.string() + ending));
    folders_.push_back(absolute.parent_path());
    folders_.push_back(fs::current_path(ignored));
}

fs::path ExternalFiles::find(const std::string& name) const
{
    std::error_code ignored;
    if (fs::path(name).is_absolute() && fs::is_regular_file(name, ignored)) return name;
    // A name from elsewhere, perhaps from a system with other separators.
    const std::size_t slash = name.find_last_of("/\\");
    const std::string last = slash == std::string::npos ? name : name.substr(slash + 1);
    for (const std::string& one : {name, last})
        for (const fs::path& folder : folders_)
        {
            // Absolute names would leave the folder.
            const fs::path path = folder / fs::path(one).relative_path();
            if (!one.empty() && fs::is_regular_file(path, ignored)) return path;
        }
    if (folders_.empty() && fs::is_regular_file(name, ignored)) return fs::absolute(name, ignored);
    std::string searched;
    for (const fs::path& folder : folders_)
        if (fs::is_directory(folder, ignored))
            searched += (searched.empty() ? "" : ", ") + folder.string();
    throw std::runtime_error("its external file '" + name + "' is missing" +
                             (searched.empty() ? "" : "; searched in " + searched));
}

}  // namespace vdamf
