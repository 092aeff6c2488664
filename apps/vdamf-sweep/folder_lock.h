// SPDX-License-Identifier: BSD-3-Clause
// One sweep at a time in a folder.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace vdamf
{
/// Held until its end, also by a process that is killed: the system takes it back.
class FolderLock
{
public:
    /// Throws std::runtime_error where another process holds it.
    explicit FolderLock(const std::filesystem::path& folder)
        : descriptor_(::open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644))
    {
        if (descriptor_ < 0)
            throw std::runtime_error((folder / "lock").string() +
                                     ": cannot write: " + std::system_category().message(errno));
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
        ::close(descriptor_);
        throw std::runtime_error(folder.string() +
                                 ": another vdamf-sweep works in this folder; wait for it, or "
                                 "name another one with -o");
    }
    ~FolderLock() { ::close(descriptor_); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_;
};

}  // namespace vdamf
