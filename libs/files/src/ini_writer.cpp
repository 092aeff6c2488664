// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <charconv>
#include <limits>

#include "degrees.h"
#include "vdamf/files/ini.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
std::string withDigits(double value, int digits)
{
    std::array<char, 64> buffer = {};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                      std::chars_format::general, digits);
    return std::string(buffer.data(), result.ptr);
}

// Shortest text of degrees that reads back as this angle. An angle that never was a number of
// degrees may have none (degrees are coarser than radians by up to one bit): then the nearest.
std::string textOfDegrees(double angle)
{
    const double nearest = degrees(angle);
    for (int digits = 1; digits <= std::numeric_limits<double>::digits10; ++digits)
    {
        const std::string text = withDigits(nearest, digits);
        const auto read = parseNumber(text);
        if (read && radians(*read) == angle) return toText(*read);
    }
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double towards : {-infinity, infinity})
    {
        const double neighbour = std::nextafter(nearest, towards);
        if (radians(neighbour) == angle) return toText(neighbour);
    }
    return toText(nearest);
}

std::string rangeText(const std::string& min, const std::string& max)
{
    return " (" + min + " to " + max + ")";
}
}  // namespace

void IniWriter::beginSection(const std::string& section, const std::string& comment)
{
    if (!text_.empty()) text_ += '\n';
    if (!comment.empty()) text_ += "# " + comment + '\n';
    text_ += '[' + section + "]\n";
}

void IniWriter::writeEntry(const char* key, const std::string& value, const std::string& comment)
{
    text_ += "# " + comment + '\n' + key + " =" + (value.empty() ? "" : " ") + value + '\n';
}

void IniWriter::operator()(const double& v, const char* key, double min, double max,
                           const char* comment)
{
    writeEntry(key, keyIsInDegrees(key) ? textOfDegrees(v) : toText(v),
               comment + rangeText(toText(min), toText(max)));
}

void IniWriter::operator()(const int& v, const char* key, int min, int max, const char* comment)
{
    writeEntry(key, std::to_string(v),
               comment + rangeText(std::to_string(min), std::to_string(max)));
}

void IniWriter::operator()(const bool& v, const char* key, const char* comment)
{
    writeEntry(key, v ? "true" : "false", std::string(comment) + " (true | false)");
}

void IniWriter::operator()(const std::string& v, const char* key, const char* comment)
{
    if (!standsInIni(v))
    {
        throw std::runtime_error("the text of '" + std::string(key) +
                                 "' cannot stand in an ini file: " + v);
    }
    writeEntry(key, v, comment);
}

}  // namespace vdamf
