// SPDX-License-Identifier: BSD-3-Clause
// An output file that appears under its name only when it is whole.
#pragma once

#include <filesystem>
#include <string_view>

namespace vdamf
{
/// Writes to `<path>.partial` and renames it to `<path>` on commit(). Every write and the close
/// are checked, and the bytes are on the disk before the name appears. An old `.partial` is
/// replaced, one that another process still writes is not. A path that names a device or a pipe
/// (/dev/stdout, /dev/null) is written directly. All errors are std::runtime_error that name the
/// file and the system's reason.
class OutputFile
{
public:
    enum class Existing
    {
        Refuse,
        Overwrite
    };
    enum class Unfinished
    {
        Discard,  ///< without commit() nothing stays behind
        Keep      ///< without commit() `<path>.partial` stays, for example after an interruption
    };

    OutputFile(std::filesystem::path path, Existing existing, Unfinished unfinished);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);
    void commit();
    /// Nothing stays behind if commit() does not follow, whatever the constructor was told.
    void discard() { unfinished_ = Unfinished::Discard; }

    const std::filesystem::path& path() const { return path_; }
    const std::filesystem::path& partialPath() const { return partialPath_; }

private:
    std::filesystem::path path_;
    std::filesystem::path partialPath_;  ///< the path itself where it is a device
    Existing existing_;
    Unfinished unfinished_;
    bool committed_ = false;
    int descriptor_ = -1;
};

}  // namespace vdamf
