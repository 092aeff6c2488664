// SPDX-License-Identifier: BSD-3-Clause
// PCD: the Point Cloud Library's file format 0.7.
#include <liblzf/lzf.h>

#include <cstring>
#include <optional>
#include <stdexcept>

#include "cloud_fields.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kMostFields = 64;
constexpr std::size_t kMostPoints = 50'000'000;
constexpr std::size_t kLargestCloud = std::size_t{1} << 30;

struct PcdHeader
{
    std::vector<CloudField> fields;
    std::optional<std::size_t> width;
    std::optional<std::size_t> height;
    std::size_t points = 0;
    std::size_t stride = 0;
    std::string data;
};

std::size_t countFrom(const TextCursor& cursor, std::string_view word, std::size_t least,
                      std::size_t most)
{
    const auto number = parseInteger(word);
    if (!number || *number < static_cast<std::int64_t>(least) ||
        *number > static_cast<std::int64_t>(most))
        cursor.fail("expected a whole number from " + std::to_string(least) + " to " +
                    std::to_string(most) + ", found " + inQuotes(word));
    return static_cast<std::size_t>(*number);
}

/// Lines with one word for each field.
void readFieldLine(const TextCursor& cursor, const std::vector<std::string_view>& words,
                   std::vector<CloudField>& fields)
{
    if (words[0] == "FIELDS")
    {
        fields.clear();
        fields.resize(std::min(words.size() - 1, kMostFields + 1));
    }
    if (fields.size() > kMostFields) cursor.fail("more than 64 fields");
    if (words.size() - 1 != fields.size())
        cursor.fail(std::string(words[0]) + " has " + std::to_string(words.size() - 1) +
                    " values, FIELDS has " + std::to_string(fields.size()));
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
        const std::string_view word = words[i + 1];
        if (words[0] == "FIELDS") fields[i].name = word;
        if (words[0] == "SIZE") fields[i].size = countFrom(cursor, word, 1, 8);
        if (words[0] == "COUNT") fields[i].count = countFrom(cursor, word, 1, 100000);
        if (words[0] == "TYPE") fields[i].type = word.size() == 1 ? word[0] : '?';
    }
}

void checkFields(const TextCursor& cursor, PcdHeader& header)
{
    if (header.fields.empty()) cursor.fail("there is no line FIELDS before DATA");
    for (CloudField& field : header.fields)
    {
        if (!isNumberType(field.type, field.size))
            cursor.fail("field '" + field.name + "' has the type " + field.type + " of " +
                        std::to_string(field.size) + " bytes, which is none");
        field.offset = header.stride;
        header.stride += field.bytes();
    }
    if (header.points > kLargestCloud / header.stride)
        cursor.fail("claims more than 1 GB of points");
}

void checkCounts(const TextCursor& cursor, const PcdHeader& header)
{
    if (!header.width || !header.height || *header.width * *header.height == header.points) return;
    cursor.fail("WIDTH " + std::to_string(*header.width) + " x HEIGHT " +
                std::to_string(*header.height) + " are not the " + std::to_string(header.points) +
                " of POINTS");
}

PcdHeader pcdHeaderOf(TextCursor& cursor)
{
    PcdHeader header;
    bool counted = false;
    std::string_view line;
    while (cursor.nextLine(line))
    {
        const auto words = wordsOf(line);
        if (words.empty() || words[0].front() == '#') continue;
        const std::string_view key = words[0];
        if (key == "FIELDS" || key == "SIZE" || key == "TYPE" || key == "COUNT")
            readFieldLine(cursor, words, header.fields);
        else if (key == "POINTS" && words.size() == 2)
        {
            header.points = countFrom(cursor, words[1], 0, kMostPoints);
            counted = true;
        }
        else if ((key == "WIDTH" || key == "HEIGHT") && words.size() == 2)
            (key == "WIDTH" ? header.width : header.height) =
                countFrom(cursor, words[1], 0, kMostPoints);
        else if (key == "DATA" && words.size() == 2)
        {
            header.data = words[1];
            if (!counted) cursor.fail("there is no line POINTS before DATA");
            checkCounts(cursor, header);
            checkFields(cursor, header);
            return header;
        }
        else if (key != "VERSION" && key != "VIEWPOINT")
            cursor.fail("no PCD header: " + inQuotes(line));
    }
    cursor.fail("no PCD file: the line DATA is missing");
}

void readAscii(TextCursor& cursor, const PcdHeader& header, CloudBuilder& builder)
{
    std::vector<std::size_t> firstWord;
    std::size_t words = 0;
    for (const CloudField& field : header.fields)
    {
        firstWord.push_back(words);
        words += field.count;
    }
    // Each number takes a digit and a blank.
    builder.reserve(std::min(header.points, cursor.rest().size() / (2 * words) + 1));
    std::string_view line;
    for (std::size_t i = 0; i < header.points;)
    {
        if (!cursor.nextLine(line))
            cursor.fail("the file ends after " + std::to_string(i) + " of " +
                        std::to_string(header.points) + " points");
        const auto all = wordsOf(line);
        if (all.empty()) continue;
        if (all.size() != words)
            cursor.fail("expected " + std::to_string(words) + " numbers, found " +
                        std::to_string(all.size()));
        builder.add(
            [&](std::size_t field)
            {
                const std::string_view word = all[firstWord[field]];
                const auto number = numberFrom(word);
                if (!number) cursor.fail("expected a number, found " + inQuotes(word));
                return *number;
            });
        ++i;
    }
    while (cursor.nextLine(line))
        if (!line.empty())
            cursor.fail("expected the end behind " + std::to_string(header.points) +
                        " points, found " + inQuotes(line));
}

void checkSize(const std::string& name, const PcdHeader& header, std::size_t bytes)
{
    const std::size_t expected = header.points * header.stride;
    if (bytes >= expected) return;
    throw std::runtime_error(name + ": its data has " + std::to_string(bytes) + " bytes, " +
                             std::to_string(header.points) + " points of " +
                             std::to_string(header.stride) + " bytes take " +
                             std::to_string(expected) + ": the file is cut short");
}

void readBinary(std::string_view bytes, const PcdHeader& header, CloudBuilder& builder)
{
    builder.reserve(header.points);
    for (std::size_t i = 0; i < header.points; ++i)
    {
        const char* const record = bytes.data() + i * header.stride;
        builder.add(
            [&](std::size_t f)
            { return numberAt(record + header.fields[f].offset, header.fields[f], false); });
    }
}

/// Two sizes, then all values of the first field, of the second, ... compressed with LZF.
std::string inflated(std::string_view bytes, const std::string& name, const PcdHeader& header)
{
    std::uint32_t sizes[2] = {};
    if (bytes.size() < sizeof(sizes))
        throw std::runtime_error(name + ": the file ends before its compressed data");
    std::memcpy(sizes, bytes.data(), sizeof(sizes));
    if (sizes[0] > bytes.size() - sizeof(sizes))
        throw std::runtime_error(name + ": claims " + std::to_string(sizes[0]) +
                                 " bytes of compressed data, " +
                                 std::to_string(bytes.size() - sizeof(sizes)) + " are there");
    if (sizes[1] > kLargestCloud || sizes[1] / 300 > sizes[0])
        throw std::runtime_error(name + ": claims a size beyond all reason");
    checkSize(name, header, sizes[1]);
    std::string data(sizes[1], '\0');
    const unsigned got = sizes[1] == 0 ? 0
                                       : lzf_decompress(bytes.data() + sizeof(sizes), sizes[0],
                                                        data.data(), sizes[1]);
    if (got != sizes[1]) throw std::runtime_error(name + ": its compressed data is damaged");
    return data;
}

void readFieldByField(const std::string& data, const PcdHeader& header, CloudBuilder& builder)
{
    builder.reserve(header.points);
    for (std::size_t i = 0; i < header.points; ++i)
        builder.add(
            [&](std::size_t f)
            {
                const CloudField& field = header.fields[f];
                const char* const column = data.data() + field.offset * header.points;
                return numberAt(column + i * field.bytes(), field, false);
            });
}
}  // namespace

FileCloud parsePcd(std::string_view bytes, const std::string& name, PointTime unit)
{
    TextCursor cursor(bytes, name);
    const PcdHeader header = pcdHeaderOf(cursor);
    CloudBuilder builder(header.fields, name, unit);
    if (header.data == "ascii")
        readAscii(cursor, header, builder);
    else if (header.data == "binary")
    {
        checkSize(name, header, cursor.rest().size());
        readBinary(cursor.rest(), header, builder);
    }
    else if (header.data == "binary_compressed")
        readFieldByField(inflated(cursor.rest(), name, header), header, builder);
    else
        cursor.fail("DATA " + inQuotes(header.data) +
                    ": expected ascii, binary or binary_compressed");
    return std::move(builder).finish();
}

}  // namespace vdamf
