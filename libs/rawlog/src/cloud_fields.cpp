// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
using Names = std::vector<std::string_view>;

template <class Number>
double as(const std::array<char, 8>& bytes)
{
    Number number = 0;
    std::memcpy(&number, bytes.data(), sizeof(number));
    return static_cast<double>(number);
}

std::optional<std::size_t> find(const std::vector<CloudField>& fields, const Names& names)
{
    for (const std::string_view name : names)
        for (std::size_t i = 0; i < fields.size(); ++i)
            if (fields[i].name == name) return i;
    return std::nullopt;
}

std::size_t require(const std::vector<CloudField>& fields, const std::string& field,
                    const std::string& name)
{
    const auto is = [&field](const CloudField& f) { return f.name == field; };
    const auto found = std::find_if(fields.begin(), fields.end(), is);
    if (found == fields.end())
        throw std::runtime_error(name + ": there is no field '" + field + "'");
    if (std::find_if(found + 1, fields.end(), is) != fields.end())
        throw std::runtime_error(name + ": the field '" + field + "' is there twice");
    return static_cast<std::size_t>(found - fields.begin());
}

double secondsPer(PointTime unit, char type)
{
    constexpr double kNano = 1e-9;
    switch (unit)
    {
        case PointTime::Milliseconds:
            return 1e-3;
        case PointTime::Microseconds:
            return 1e-6;
        case PointTime::Nanoseconds:
            return kNano;
        case PointTime::Auto:
            return type == 'F' ? 1.0 : kNano;
        default:
            return 1.0;
    }
}

/// Sensors give 0..1, 0..255 or 0..65535.
void scaleToOne(std::vector<float>& values)
{
    constexpr float kByte = 255.0F;
    constexpr float kWord = 65535.0F;
    float largest = 0.0F;
    for (const float value : values) largest = std::max(largest, value);
    if (largest <= 1.0F) return;
    const float scale = largest <= kByte ? kByte : std::max(kWord, largest);
    for (float& value : values) value = std::max(0.0F, value / scale);
}
}  // namespace

double numberAt(const char* at, const CloudField& field, bool bigEndian)
{
    std::array<char, 8> bytes = {};
    std::memcpy(bytes.data(), at, field.size);
    if (bigEndian) std::reverse(bytes.begin(), bytes.begin() + static_cast<long>(field.size));
    if (field.type == 'F') return field.size == 4 ? as<float>(bytes) : as<double>(bytes);
    const bool isSigned = field.type == 'I';
    switch (field.size)
    {
        case 1:
            return isSigned ? as<std::int8_t>(bytes) : as<std::uint8_t>(bytes);
        case 2:
            return isSigned ? as<std::int16_t>(bytes) : as<std::uint16_t>(bytes);
        case 4:
            return isSigned ? as<std::int32_t>(bytes) : as<std::uint32_t>(bytes);
        default:
            return isSigned ? as<std::int64_t>(bytes) : as<std::uint64_t>(bytes);
    }
}

bool isNumberType(char type, std::size_t size)
{
    if (type == 'F') return size == 4 || size == 8;
    return (type == 'I' || type == 'U') && (size == 1 || size == 2 || size == 4 || size == 8);
}

CloudBuilder::CloudBuilder(const std::vector<CloudField>& fields, const std::string& name,
                           PointTime unit)
    : x_(require(fields, "x", name)), y_(require(fields, "y", name)), z_(require(fields, "z", name))
{
    intensity_ = find(fields, {"intensity", "i", "reflectivity", "remission"});
    if (unit != PointTime::None)
        time_ = find(fields, {"t", "time", "timestamp", "time_offset", "offset_time"});
    if (time_) secondsPerUnit_ = secondsPer(unit, fields[*time_].type);
}

void CloudBuilder::reserve(std::size_t points)
{
    for (auto* values : {&cloud_.points.x, &cloud_.points.y, &cloud_.points.z})
        values->reserve(points);
    if (intensity_) cloud_.points.intensity.reserve(points);
    if (time_) cloud_.times.reserve(points);
}

void CloudBuilder::append(double x, double y, double z, double intensity, double time)
{
    constexpr double kFarthest = 1e6;  // m
    const bool possible = std::abs(x) < kFarthest && std::abs(y) < kFarthest &&
                          std::abs(z) < kFarthest && std::isfinite(time);
    if (!possible)
    {
        ++cloud_.leftOut;
        return;
    }
    cloud_.points.x.push_back(static_cast<float>(x));
    cloud_.points.y.push_back(static_cast<float>(y));
    cloud_.points.z.push_back(static_cast<float>(z));
    if (intensity_)
        cloud_.points.intensity.push_back(std::isfinite(intensity) ? static_cast<float>(intensity)
                                                                   : 0.0F);
    if (time_) cloud_.times.push_back(time * secondsPerUnit_);
}

FileCloud CloudBuilder::finish() &&
{
    scaleToOne(cloud_.points.intensity);
    return std::move(cloud_);
}

bool TextCursor::nextLine(std::string_view& line)
{
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    return true;
}

void TextCursor::fail(const std::string& what) const
{
    throw std::runtime_error(where() + ": " + what);
}

std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    for (line = trimmed(line); !line.empty(); line = trimmed(line))
    {
        const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

std::optional<double> numberFrom(std::string_view word)
{
    for (const std::string_view none : {"nan", "-nan", "NaN", "inf", "-inf"})
        if (word == none) return std::numeric_limits<double>::quiet_NaN();
    return parseNumber(word);
}

}  // namespace vdamf
