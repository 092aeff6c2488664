// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/text_file.h"

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "vdamf/files/output_file.h"

namespace vdamf
{
std::string readBytes(const std::filesystem::path& path, std::size_t maxBytes)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
    {
        throw std::runtime_error(path.string() + ": this is a folder; name a file");
    }
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
    {
        throw std::runtime_error(path.string() +
                                 ": cannot read: " + std::system_category().message(errno));
    }
    std::string bytes;
    std::string chunk(64 << 10, '\0');
    while (file.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), file.gcount() > 0)
    {
        bytes.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
        if (bytes.size() > maxBytes)
        {
            throw std::runtime_error(path.string() + ": larger than " + std::to_string(maxBytes) +
                                     " bytes; this cannot be the text file that is expected");
        }
    }
    if (file.bad())
    {
        throw std::runtime_error(path.string() +
                                 ": cannot read: " + std::system_category().message(errno));
    }
    return bytes;
}

std::string readTextFile(const std::filesystem::path& path, std::size_t maxBytes)
{
    std::string text = readBytes(path, maxBytes);
    text.erase(0, text.size() - withoutByteOrderMark(text).size());
    return text;
}

std::string_view withoutByteOrderMark(std::string_view text)
{
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text.substr(0, kMark.size()) == kMark) text.remove_prefix(kMark.size());
    return text;
}

void writeTextFile(const std::filesystem::path& path, std::string_view text)
{
    OutputFile file(path, OutputFile::Existing::Overwrite, OutputFile::Unfinished::Discard);
    file.write(text);
    file.commit();
}

std::string printable(std::string_view text)
{
    std::string shown;
    for (const char c : text)
    {
        const auto code = static_cast<unsigned char>(c);
        shown += (code < 0x20 || code == 0x7F) ? '?' : c;
    }
    return shown;
}

std::string inQuotes(std::string_view text)
{
    constexpr std::size_t kLongest = 60;
    return "'" + printable(text.substr(0, kLongest)) + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace vdamf
