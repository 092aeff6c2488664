// SPDX-License-Identifier: BSD-3-Clause
// Takes a page apart again, as the browser does.
#pragma once

#include <zlib.h>

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vdamf::test
{
inline std::string fromBase64(std::string_view text)
{
    constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char letter : text)
    {
        if (letter == '=') break;
        const std::size_t value = kLetters.find(letter);
        if (value == std::string_view::npos) throw std::runtime_error("no base64");
        bits = bits << 6U | static_cast<std::uint32_t>(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
    }
    return bytes;
}

inline std::string unzipped(std::string packed)
{
    z_stream stream = {};
    if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::runtime_error("no zlib");
    std::string bytes(std::size_t{1} << 24U, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    const int status = inflate(&stream, Z_FINISH);
    bytes.resize(stream.total_out);
    inflateEnd(&stream);
    if (status != Z_STREAM_END) throw std::runtime_error("no gz");
    return bytes;
}

/// The content of a data element, unpacked.
inline std::string dataOf(const std::string& page, const std::string& id)
{
    const std::string mark = "id=\"" + id + "\">";
    const std::size_t begin = page.find(mark);
    if (begin == std::string::npos) throw std::runtime_error("the page has no " + id);
    const std::size_t from = begin + mark.size();
    return unzipped(fromBase64(page.substr(from, page.find('<', from) - from)));
}

inline nlohmann::json runOf(const std::string& page)
{
    return nlohmann::json::parse(dataOf(page, "run"));
}

struct DecodedGroup
{
    std::uint32_t track = 0;
    std::vector<Eigen::Vector3d> hits;  ///< m
};

/// What encoded() wrote.
inline std::vector<DecodedGroup> decoded(const std::string& bytes)
{
    const auto byte = [&](std::size_t i)
    { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(i))); };
    const auto word = [&](std::size_t i)
    { return byte(i) | byte(i + 1) << 8U | byte(i + 2) << 16U | byte(i + 3) << 24U; };
    std::vector<DecodedGroup> groups(word(0));
    std::size_t count = 0;
    for (std::size_t g = 0; g < groups.size(); ++g)
    {
        groups[g].hits.resize(word(4 + 8 * g));
        groups[g].track = word(8 + 8 * g);
        count += groups[g].hits.size();
    }
    const std::size_t planes = 4 + 8 * groups.size();
    if (bytes.size() != planes + 6 * count) throw std::runtime_error("wrong number of bytes");
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
        std::size_t i = planes + 2 * static_cast<std::size_t>(axis) * count;
        std::uint32_t sum = 0;
        for (DecodedGroup& group : groups)
            for (Eigen::Vector3d& hit : group.hits)
            {
                sum = (sum + (byte(i) | byte(i + count) << 8U)) & 0xFFFFU;
                ++i;
                hit(axis) = 0.01 * static_cast<std::int16_t>(static_cast<std::uint16_t>(sum));
            }
    }
    return groups;
}

}  // namespace vdamf::test
