// SPDX-License-Identifier: BSD-3-Clause
// Names for content: equal bytes have equal digests, and others have another one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace vdamf
{
/// 128 bits (XXH3) as 32 hexadecimal digits, the same on every machine. No protection against
/// content that is made to collide.
std::string digestOf(std::string_view bytes);

/// Of a file's content, read piece by piece. Throws std::runtime_error that names the file.
std::string digestOfFile(const std::filesystem::path& path);

}  // namespace vdamf
