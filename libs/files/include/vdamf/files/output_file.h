// SPDX-License-Identifier: BSD-3-Clause
// An output file that appears under its name only when it is whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vdamf
{
/// Where the bytes for an output stand until it is whole: `<path>.partial`, beside the file that
/// the path leads to where it is a symbolic link; the path itself where it is written directly.
std::filesystem::path partialPathOf(const std::filesystem::path& path);

/// True where both names lead to one file, which need not exist.
bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b);

/// A file that is read, and what messages call it: "the input", "the configuration".
struct NamedInput
{
    std::filesystem::path path;  ///< empty: there is none
    std::string name;
};

/// Throws std::runtime_error where an output, or the `.partial` that it is written to, is an input
/// or another output. Several may go to a device like /dev/null.
void checkOutputPaths(const std::vector<std::filesystem::path>& outputs,
                      const std::vector<NamedInput>& inputs);

/// True for /dev/stdout and its other names: what is written there goes the way of printed text.
bool isStandardOutput(const std::filesystem::path& path);

/// Writes to partialPathOf(path) and renames that to the path on commit(). Every write and the
/// close are checked, and the bytes are on the disk before the name appears. A symbolic link
/// stays, the file that it leads to is replaced. An old `.partial` holds what an interrupted run
/// saved: it is refused like an existing file, unless it is empty, and one to be overwritten stays
/// until the first bytes are written; one that another process still
/// writes is refused always. A path that names a device, a pipe or a descriptor (/dev/null,
/// /dev/stdout, also when that is redirected to a file) is written directly. All errors are
/// std::runtime_error that name the file and the system's reason.
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
        /// Without commit() the `.partial` stays, for example after an interruption, unless nothing
        /// was written.
        Keep
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
    void dropOlder();

    std::filesystem::path path_;
    std::filesystem::path target_;       ///< the path without symbolic links
    std::filesystem::path partialPath_;  ///< the path itself where it is written directly
    Existing existing_;
    Unfinished unfinished_;
    bool committed_ = false;
    bool empty_ = true;
    bool holdsOlder_ = false;  ///< the partial, of an interrupted run
    int descriptor_ = -1;
};

}  // namespace vdamf
