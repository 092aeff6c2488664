// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "vdamf/files/numbers.h"
#include "write_signals.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what)
{
    throw std::runtime_error(path.string() + ": " + what);
}

[[noreturn]] void failWithErrno(const fs::path& path, const std::string& what, int error)
{
    std::string advice;
    if (error == ENOSPC || error == EDQUOT) advice = "; free some space or choose another disk";
    if (error == EACCES || error == EPERM || error == EROFS)
    {
        advice = "; choose a folder that you may write to";
    }
    fail(path, what + ": " + std::system_category().message(error) + advice);
}

bool isDevice(const fs::file_status& status)
{
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// Of an open file of this process: renaming something to such a name would replace the name.
std::optional<int> descriptorNamed(const fs::path& path)
{
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    const std::string folder = path.parent_path().string();
    if (folder != "/dev/fd" && folder != "/proc/self/fd") return std::nullopt;
    const std::optional<std::int64_t> number = parseInteger(path.filename().string());
    if (!number || *number < 0 || *number > std::numeric_limits<int>::max()) return std::nullopt;
    return static_cast<int>(*number);
}

// Like /dev/null: what two outputs write there is not mixed in a file, nor lost. The standard
// output is none, though it may be a terminal: nobody can tell two outputs in it apart.
bool takesSeveralOutputs(const fs::path& path)
{
    std::error_code ignored;
    return !descriptorNamed(path) && fs::is_character_file(fs::status(path, ignored));
}

// The file that a chain of symbolic links leads to, whether it exists or not.
fs::path withoutLinks(fs::path path)
{
    constexpr int kLongestChain = 40;  // as the system has it
    std::error_code error;
    for (int links = 0; fs::is_symlink(fs::symlink_status(path, error)); ++links)
    {
        if (links == kLongestChain) fail(path, "too many symbolic links");
        const fs::path next = fs::read_symlink(path, error);
        if (error) fail(path, "cannot follow the link: " + error.message());
        path = path.parent_path() / next;  // `next` alone where it is absolute
    }
    return path;
}

void checkTarget(const fs::path& path, OutputFile::Existing existing)
{
    std::error_code ignored;
    if (path.empty()) throw std::runtime_error("the name of the output file is empty");
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status) || !path.has_filename())
    {
        fail(path, "cannot write: this is a folder; name a file in it");
    }
    const fs::path folder = path.parent_path();
    if (!folder.empty() && !fs::is_directory(folder, ignored))
    {
        fail(path, "cannot write: there is no folder " + folder.string() + "; create it first");
    }
    if (existing == OutputFile::Existing::Refuse && fs::exists(status) && !isDevice(status))
    {
        fail(path, "exists already; use --overwrite to replace it, or another name");
    }
}

int openRetrying(const fs::path& path, int flags)
{
    int descriptor = -1;
    do
    {
        descriptor = ::open(path.c_str(), flags | O_WRONLY | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0) failWithErrno(path, "cannot open for writing", errno);
    return descriptor;
}

bool isStillNamed(int descriptor, const fs::path& path)
{
    struct stat ofDescriptor = {};
    struct stat ofPath = {};
    return ::fstat(descriptor, &ofDescriptor) == 0 && ::lstat(path.c_str(), &ofPath) == 0 &&
           ofDescriptor.st_ino == ofPath.st_ino && ofDescriptor.st_dev == ofPath.st_dev;
}

bool holdsBytes(int descriptor)
{
    struct stat status = {};
    return ::fstat(descriptor, &status) == 0 && status.st_size > 0;
}

// The lock keeps a second process from emptying a file that the first is about to rename. Between
// our open and our lock the first may have renamed it: then the descriptor is not ours to empty.
int openPartial(const fs::path& partial, OutputFile::Existing existing)
{
    for (;;)
    {
        const int descriptor = openRetrying(partial, O_CREAT | O_NOFOLLOW);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        {
            ::close(descriptor);
            fail(partial, "another run is writing this file; wait for it or use another name");
        }
        if (isStillNamed(descriptor, partial))
        {
            if (existing == OutputFile::Existing::Refuse && holdsBytes(descriptor))
            {
                ::close(descriptor);
                fail(partial,
                     "holds what an interrupted run saved; rename or remove it, or use --overwrite "
                     "to replace it");
            }
            return descriptor;
        }
        ::close(descriptor);
    }
}

void syncChecked(int descriptor, const fs::path& path)
{
    int result = 0;
    do
    {
        result = ::fsync(descriptor);
    } while (result != 0 && errno == EINTR);
    // Devices and pipes have nothing to bring to a disk.
    if (result != 0 && errno != EINVAL && errno != EROFS)
        failWithErrno(path, "cannot write", errno);
}

void renameChecked(const fs::path& from, const fs::path& to, OutputFile::Existing existing)
{
    int result = -1;
    if (existing == OutputFile::Existing::Refuse)
    {
        // The file may have come into being since the constructor looked.
        result = ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE);
        if (result == 0) return;
        if (errno == EEXIST) fail(to, "exists already; use --overwrite to replace it");
        if (errno != EINVAL && errno != ENOSYS) failWithErrno(to, "cannot rename to it", errno);
    }
    if (::rename(from.c_str(), to.c_str()) != 0) failWithErrno(to, "cannot rename to it", errno);
}
}  // namespace

fs::path partialPathOf(const fs::path& path)
{
    std::error_code ignored;
    if (descriptorNamed(path) || isDevice(fs::status(path, ignored))) return path;
    fs::path partial = withoutLinks(path);
    partial += ".partial";
    return partial;
}

bool sameFile(const fs::path& a, const fs::path& b)
{
    std::error_code error;
    if (fs::equivalent(a, b, error)) return true;
    const auto place = [&](const fs::path& path)
    { return fs::weakly_canonical(fs::absolute(withoutLinks(path), error), error); };
    return place(a) == place(b);
}

void checkOutputPaths(const std::vector<fs::path>& outputs, const std::vector<NamedInput>& inputs)
{
    for (std::size_t i = 0; i < outputs.size(); ++i)
    {
        const std::string name = outputs[i].string();
        const fs::path partial = partialPathOf(outputs[i]);
        for (const NamedInput& input : inputs)
        {
            if (input.path.empty()) continue;
            if (sameFile(outputs[i], input.path))
                throw std::runtime_error(name + ": is " + input.name + "; choose another output");
            if (sameFile(partial, input.path))
                throw std::runtime_error(name + ": is written by way of " + partial.string() +
                                         ", which is " + input.name + "; choose another output");
        }
        if (takesSeveralOutputs(outputs[i])) continue;
        for (std::size_t j = 0; j < i; ++j)
            if (sameFile(outputs[i], outputs[j]) || sameFile(partial, outputs[j]) ||
                sameFile(outputs[i], partialPathOf(outputs[j])))
                throw std::runtime_error(name + ": is named for two outputs");
    }
}

bool isStandardOutput(const fs::path& path)
{
    return descriptorNamed(path) == STDOUT_FILENO;
}

OutputFile::OutputFile(fs::path path, Existing existing, Unfinished unfinished)
    : path_(std::move(path)), existing_(existing), unfinished_(unfinished)
{
    if (const std::optional<int> named = descriptorNamed(path_))
    {
        partialPath_ = path_;
        descriptor_ = ::fcntl(*named, F_DUPFD_CLOEXEC, 0);
        if (descriptor_ < 0) failWithErrno(path_, "cannot open for writing", errno);
        return;
    }
    checkTarget(path_, existing_);
    partialPath_ = partialPathOf(path_);
    if (partialPath_ == path_)
    {
        descriptor_ = openRetrying(path_, 0);
        return;
    }
    target_ = withoutLinks(path_);
    checkTarget(target_, existing_);
    descriptor_ = openPartial(partialPath_, existing_);
    holdsOlder_ = holdsBytes(descriptor_);
}

OutputFile::~OutputFile()
{
    const bool ownsPartial = !committed_ && partialPath_ != path_;
    // Removed while the lock is still held, so that it cannot be the file of another run.
    if (ownsPartial && !holdsOlder_ && (empty_ || unfinished_ == Unfinished::Discard))
        ::unlink(partialPath_.c_str());
    if (descriptor_ >= 0) ::close(descriptor_);
}

// What an interrupted run saved stays until there is something to put in its place.
void OutputFile::dropOlder()
{
    if (holdsOlder_ && ::ftruncate(descriptor_, 0) != 0)
        failWithErrno(partialPath_, "cannot empty", errno);
    holdsOlder_ = false;
}

void OutputFile::write(std::string_view bytes)
{
    if (bytes.empty()) return;
    empty_ = false;
    dropOlder();
    const WriteSignalsHeld held;
    while (!bytes.empty())
    {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) failWithErrno(partialPath_, "cannot write", errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void OutputFile::commit()
{
    dropOlder();
    syncChecked(descriptor_, partialPath_);
    if (partialPath_ != path_) renameChecked(partialPath_, target_, existing_);
    committed_ = true;
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0 && errno != EINTR) failWithErrno(path_, "cannot close", errno);
}

}  // namespace vdamf
