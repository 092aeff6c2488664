// SPDX-License-Identifier: BSD-3-Clause
// Whole small files, mostly of text, and words for error messages about them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace vdamf
{
/// The bytes of a file. Throws std::runtime_error that names it: missing, a folder, unreadable,
/// or larger than `maxBytes` (then it is not the file that was meant).
std::string readBytes(const std::filesystem::path& path, std::size_t maxBytes = 64 << 20);

/// The same without a byte order mark.
std::string readTextFile(const std::filesystem::path& path, std::size_t maxBytes = 64 << 20);

/// Without the byte order mark that some programs put before a text in UTF-8.
std::string_view withoutByteOrderMark(std::string_view text);

/// The file with this text in place of what it held: whole, or as it was. Throws
/// std::runtime_error that names the file.
void writeTextFile(const std::filesystem::path& path, std::string_view text);

/// With `?` for what would steer a terminal.
std::string printable(std::string_view text);

/// `'text'`, cut after 60 characters and with unprintable ones as `?`, to quote input in messages.
std::string inQuotes(std::string_view text);

}  // namespace vdamf
