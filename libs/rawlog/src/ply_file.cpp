// SPDX-License-Identifier: BSD-3-Clause
// PLY: the Stanford polygon format 1.0, points alone.
#include <stdexcept>

#include "cloud_fields.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr std::int64_t kMostElements = 50'000'000;
constexpr std::size_t kMostProperties = 256;

struct PlyElement
{
    std::string name;
    std::size_t count = 0;
    std::vector<CloudField> fields;
    std::size_t stride = 0;
    bool hasList = false;
};

struct PlyHeader
{
    std::string format;
    std::vector<PlyElement> elements;
};

CloudField fieldOf(const TextCursor& cursor, std::string_view type, std::string_view name)
{
    struct Type
    {
        std::string_view name;
        char type;
        std::size_t size;
    };
    static constexpr Type kTypes[] = {
        {"char", 'I', 1},  {"int8", 'I', 1},    {"uchar", 'U', 1},  {"uint8", 'U', 1},
        {"short", 'I', 2}, {"int16", 'I', 2},   {"ushort", 'U', 2}, {"uint16", 'U', 2},
        {"int", 'I', 4},   {"int32", 'I', 4},   {"uint", 'U', 4},   {"uint32", 'U', 4},
        {"float", 'F', 4}, {"float32", 'F', 4}, {"double", 'F', 8}, {"float64", 'F', 8}};
    for (const Type& known : kTypes)
        if (known.name == type) return {std::string(name), known.type, known.size, 1, 0};
    cursor.fail("unknown type " + inQuotes(type));
}

void addElement(const TextCursor& cursor, const std::vector<std::string_view>& words,
                PlyHeader& header)
{
    const auto count = words.size() == 3 ? parseInteger(words[2]) : std::nullopt;
    if (!count || *count < 0 || *count > kMostElements)
        cursor.fail("expected 'element NAME COUNT' with a count up to " +
                    std::to_string(kMostElements));
    PlyElement element;
    element.name = words[1];
    element.count = static_cast<std::size_t>(*count);
    header.elements.push_back(std::move(element));
}

void addProperty(const TextCursor& cursor, const std::vector<std::string_view>& words,
                 PlyHeader& header)
{
    if (header.elements.empty()) cursor.fail("a property before any element");
    PlyElement& element = header.elements.back();
    if (words.size() == 5 && words[1] == "list")
    {
        element.hasList = true;
        return;
    }
    if (words.size() != 3) cursor.fail("expected 'property TYPE NAME'");
    if (element.fields.size() >= kMostProperties) cursor.fail("more than 256 properties");
    CloudField field = fieldOf(cursor, words[1], words[2]);
    field.offset = element.stride;
    element.stride += field.size;
    element.fields.push_back(std::move(field));
}

PlyHeader plyHeaderOf(TextCursor& cursor)
{
    PlyHeader header;
    std::string_view line;
    if (!cursor.nextLine(line) || line != "ply") cursor.fail("no PLY file: expected 'ply'");
    while (cursor.nextLine(line))
    {
        const auto words = wordsOf(line);
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
        if (words[0] == "end_header") return header;
        if (words[0] == "format" && words.size() == 3)
            header.format = words[1];
        else if (words[0] == "element")
            addElement(cursor, words, header);
        else if (words[0] == "property")
            addProperty(cursor, words, header);
        else
            cursor.fail("no PLY header: " + inQuotes(line));
    }
    cursor.fail("no PLY file: the line end_header is missing");
}

void readAscii(TextCursor& cursor, const PlyElement& element, CloudBuilder* builder)
{
    std::string_view line;
    for (std::size_t i = 0; i < element.count;)
    {
        if (!cursor.nextLine(line))
            cursor.fail("the file ends after " + std::to_string(i) + " of " +
                        std::to_string(element.count) + " of element '" + element.name + "'");
        const auto words = wordsOf(line);
        if (words.empty()) continue;
        ++i;
        if (builder == nullptr) continue;
        if (words.size() != element.fields.size())
            cursor.fail("expected " + std::to_string(element.fields.size()) + " numbers, found " +
                        std::to_string(words.size()));
        builder->add(
            [&](std::size_t field)
            {
                const auto number = numberFrom(words[field]);
                if (!number) cursor.fail("expected a number, found " + inQuotes(words[field]));
                return *number;
            });
    }
}

std::string_view elementBytes(std::string_view rest, const PlyElement& element,
                              const std::string& name)
{
    if (element.stride > 0 && element.count > rest.size() / element.stride)
        throw std::runtime_error(
            name + ": element '" + element.name + "' claims " + std::to_string(element.count) +
            " records of " + std::to_string(element.stride) + " bytes, " +
            std::to_string(rest.size()) + " bytes are there: the file is cut short");
    return rest.substr(0, element.count * element.stride);
}

void readBinary(std::string_view bytes, const PlyElement& element, bool bigEndian,
                CloudBuilder& builder)
{
    builder.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i)
    {
        const char* const record = bytes.data() + i * element.stride;
        builder.add(
            [&](std::size_t f)
            { return numberAt(record + element.fields[f].offset, element.fields[f], bigEndian); });
    }
}
}  // namespace

FileCloud parsePly(std::string_view bytes, const std::string& name, PointTime unit)
{
    TextCursor cursor(bytes, name);
    const PlyHeader header = plyHeaderOf(cursor);
    const bool ascii = header.format == "ascii";
    const bool bigEndian = header.format == "binary_big_endian";
    if (!ascii && !bigEndian && header.format != "binary_little_endian")
        throw std::runtime_error(name + ": format " + inQuotes(header.format) +
                                 ": expected ascii, binary_little_endian or binary_big_endian");
    std::string_view rest = cursor.rest();
    for (const PlyElement& element : header.elements)
    {
        const bool isVertex = element.name == "vertex";
        if (element.hasList && (isVertex || !ascii))
            throw std::runtime_error(name + ": element '" + element.name +
                                     "' has a list, behind which no vertices can be found");
        if (!isVertex)
        {
            if (ascii) readAscii(cursor, element, nullptr);
            rest.remove_prefix(ascii ? 0 : elementBytes(rest, element, name).size());
            continue;
        }
        CloudBuilder builder(element.fields, name, unit);
        if (ascii)
            readAscii(cursor, element, &builder);
        else
            readBinary(elementBytes(rest, element, name), element, bigEndian, builder);
        return std::move(builder).finish();
    }
    throw std::runtime_error(name + ": there is no element 'vertex'");
}

}  // namespace vdamf
