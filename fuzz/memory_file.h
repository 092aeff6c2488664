// SPDX-License-Identifier: BSD-3-Clause
// Bytes under a file name, without a disk.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace vdamf::fuzz
{
inline std::string_view textOf(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

/// A file in memory that holds the bytes and is gone with the object.
class MemoryFile
{
public:
    explicit MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC))
    {
        if (descriptor_ < 0) throw std::logic_error("cannot make a file in memory");
        while (!bytes.empty())
        {
            const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
            if (count <= 0) throw std::logic_error("cannot fill a file in memory");
            bytes.remove_prefix(static_cast<std::size_t>(count));
        }
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    /// Each who opens it reads from its begin.
    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

}  // namespace vdamf::fuzz
