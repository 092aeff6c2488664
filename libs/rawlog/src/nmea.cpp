// SPDX-License-Identifier: BSD-3-Clause
#include "nmea.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
using Fields = std::vector<std::string_view>;

/// The fields of a sentence of a kind ("RMC"); none where there is none with a right check sum.
Fields fieldsOf(std::string_view text, std::string_view kind)
{
    constexpr std::size_t kTalker = 3;  // "$GP"
    if (text.size() < kTalker + kind.size() || text[0] != '$' ||
        text.substr(kTalker, kind.size()) != kind)
        return {};
    const std::size_t star = text.find('*');
    if (star == std::string_view::npos || text.size() < star + 3) return {};
    unsigned told = 0;
    const char* const end = text.data() + star + 3;
    if (std::from_chars(text.data() + star + 1, end, told, 16).ptr != end) return {};
    unsigned sum = 0;
    for (const char c : text.substr(1, star - 1)) sum ^= static_cast<unsigned char>(c);
    if (sum != told) return {};
    Fields fields;
    for (std::size_t from = 0; from <= star;)
    {
        const std::size_t to = std::min(text.find(',', from), star);
        fields.push_back(text.substr(from, to - from));
        from = to + 1;
    }
    return fields;
}

/// "ddmm.mmm" or "dddmm.mmm" and a hemisphere, deg.
std::optional<double> angleFrom(std::string_view text, std::string_view hemisphere)
{
    const auto number = parseNumber(text);
    if (!number || *number < 0.0 || hemisphere.size() != 1) return std::nullopt;
    const double degrees = std::floor(*number / 100.0);
    const double minutes = *number - 100.0 * degrees;
    if (minutes >= 60.0 || degrees > 180.0) return std::nullopt;
    const double value = degrees + minutes / 60.0;
    const bool negative = hemisphere == "S" || hemisphere == "W";
    return negative ? -value : value;
}

/// "hhmmss.ss".
std::optional<mrpt::obs::gnss::UTC_time> timeFrom(std::string_view text)
{
    const auto number = parseNumber(text);
    if (!number || *number < 0.0 || *number >= 240000.0) return std::nullopt;
    mrpt::obs::gnss::UTC_time time;
    time.hour = static_cast<std::uint8_t>(*number / 1e4);
    time.minute = static_cast<std::uint8_t>(std::fmod(*number / 100.0, 100.0));
    time.sec = std::fmod(*number, 100.0);
    return time;
}
}  // namespace

std::optional<mrpt::obs::gnss::Message_NMEA_RMC> rmcIn(std::string_view text)
{
    // $GPRMC,time,status,latitude,N,longitude,E,knots,course,date,...
    const Fields fields = fieldsOf(text, "RMC");
    if (fields.size() < 10) return std::nullopt;
    const auto latitude = angleFrom(fields[3], fields[4]);
    const auto longitude = angleFrom(fields[5], fields[6]);
    const auto time = timeFrom(fields[1]);
    if (!latitude || !longitude || !time || fields[2].size() != 1) return std::nullopt;
    mrpt::obs::gnss::Message_NMEA_RMC message;
    message.fields.UTCTime = *time;
    message.fields.validity_char = static_cast<std::int8_t>(fields[2][0]);
    message.fields.latitude_degrees = *latitude;
    message.fields.longitude_degrees = *longitude;
    message.fields.speed_knots = parseNumber(fields[7]).value_or(0.0);
    message.fields.direction_degrees = parseNumber(fields[8]).value_or(0.0);
    if (const auto date = parseInteger(fields[9]); date && *date >= 0 && *date < 1000000)
    {
        message.fields.date_day = static_cast<std::uint8_t>(*date / 10000);
        message.fields.date_month = static_cast<std::uint8_t>(*date / 100 % 100);
        message.fields.date_year = static_cast<std::uint8_t>(*date % 100);
    }
    return message;
}

std::optional<mrpt::obs::gnss::Message_NMEA_GGA> ggaIn(std::string_view text)
{
    // $GPGGA,time,latitude,N,longitude,E,quality,satellites,hdop,altitude,M,geoid,M,...
    const Fields fields = fieldsOf(text, "GGA");
    if (fields.size() < 12) return std::nullopt;
    const auto latitude = angleFrom(fields[2], fields[3]);
    const auto longitude = angleFrom(fields[4], fields[5]);
    const auto time = timeFrom(fields[1]);
    const auto altitude = parseNumber(fields[9]);
    const auto quality = parseInteger(fields[6]);
    if (!latitude || !longitude || !time || !altitude || !quality) return std::nullopt;
    mrpt::obs::gnss::Message_NMEA_GGA message;
    message.fields.UTCTime = *time;
    message.fields.latitude_degrees = *latitude;
    message.fields.longitude_degrees = *longitude;
    message.fields.fix_quality = static_cast<std::uint8_t>(*quality & 0xff);
    message.fields.altitude_meters = *altitude;
    message.fields.orthometric_altitude = *altitude;
    message.fields.geoidal_distance = parseNumber(fields[11]).value_or(0.0);
    message.fields.corrected_orthometric_altitude = *altitude + message.fields.geoidal_distance;
    const auto satellites = parseInteger(fields[7]);
    message.fields.satellitesUsed = static_cast<std::uint32_t>(satellites.value_or(0) & 0xff);
    message.fields.HDOP = static_cast<float>(parseNumber(fields[8]).value_or(0.0));
    return message;
}

}  // namespace vdamf
