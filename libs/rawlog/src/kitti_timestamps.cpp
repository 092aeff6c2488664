// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/kitti_drive.h"

namespace vdamf
{
namespace
{
constexpr std::int64_t kTicksPerSecond = 10'000'000;
constexpr std::int64_t kNanosecondsPerTick = 100;
// From 1601-01-01, where MRPT's clock starts, to 1970-01-01.
constexpr std::int64_t kSecondsBeforeUnix = 11'644'473'600;

// Days since 1970-01-01 of a date in the Gregorian calendar: years start in March, so that the
// leap day is a year's last. The month behind December is the next January.
std::int64_t daysSinceUnix(std::int64_t year, std::int64_t month, std::int64_t day)
{
    const std::int64_t marchYear = month <= 2 ? year - 1 : year;
    const std::int64_t era = marchYear / 400;
    const std::int64_t yearOfEra = marchYear - era * 400;
    const std::int64_t marchMonth = (month + 9) % 12;
    const std::int64_t dayOfYear = (153 * marchMonth + 2) / 5 + day - 1;
    const std::int64_t dayOfEra = yearOfEra * 365 + yearOfEra / 4 - yearOfEra / 100 + dayOfYear;
    return era * 146'097 + dayOfEra - 719'468;
}

// The calendar knows the date; not 30 February.
bool isDate(std::int64_t year, std::int64_t month, std::int64_t day)
{
    return day <= daysSinceUnix(year, month + 1, 1) - daysSinceUnix(year, month, 1);
}

// Digits of a field at a fixed place, when they are a number from min to max.
std::optional<std::int64_t> field(std::string_view text, std::size_t from, std::size_t count,
                                  std::int64_t min, std::int64_t max)
{
    const std::string_view digits = text.substr(from, count);
    if (digits.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    const std::optional<std::int64_t> value = parseInteger(digits);
    if (!value || *value < min || *value > max) return std::nullopt;
    return value;
}

// Fraction of a second behind its point, in nanoseconds; 1 to 9 digits.
std::optional<std::int64_t> nanoseconds(std::string_view fraction)
{
    constexpr std::size_t kDigits = 9;
    if (fraction.empty() || fraction.size() > kDigits) return std::nullopt;
    std::string digits(fraction);
    digits.resize(kDigits, '0');
    return field(digits, 0, kDigits, 0, 999'999'999);
}

// `2011-09-26 13:02:25.963999987`
std::optional<mrpt::Clock::time_point> timeOf(std::string_view text)
{
    constexpr std::string_view kPattern = "dddd-dd-dd dd:dd:dd.";
    if (text.size() <= kPattern.size()) return std::nullopt;
    for (std::size_t i = 0; i < kPattern.size(); ++i)
    {
        if (kPattern[i] != 'd' && text[i] != kPattern[i]) return std::nullopt;
    }
    const auto year = field(text, 0, 4, 1970, 9999);
    const auto month = field(text, 5, 2, 1, 12);
    const auto day = field(text, 8, 2, 1, 31);
    const auto hour = field(text, 11, 2, 0, 23);
    const auto minute = field(text, 14, 2, 0, 59);
    const auto second = field(text, 17, 2, 0, 60);
    const auto fraction = nanoseconds(text.substr(kPattern.size()));
    if (!year || !month || !day || !hour || !minute || !second || !fraction) return std::nullopt;
    if (!isDate(*year, *month, *day)) return std::nullopt;
    const std::int64_t seconds = daysSinceUnix(*year, *month, *day) * 86'400 + *hour * 3'600 +
                                 *minute * 60 + *second + kSecondsBeforeUnix;
    const std::int64_t ticks = (*fraction + kNanosecondsPerTick / 2) / kNanosecondsPerTick;
    return mrpt::Clock::time_point(mrpt::Clock::duration(seconds * kTicksPerSecond + ticks));
}
}  // namespace

std::vector<mrpt::Clock::time_point> readKittiTimestamps(const std::filesystem::path& path)
{
    const std::string bytes = readTextFile(path);
    std::string_view rest = bytes;
    std::vector<mrpt::Clock::time_point> times;
    for (int line = 1; !rest.empty(); ++line)
    {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view text = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        // The data set's files end with a line break and some with an empty line.
        if (text.empty() && trimmed(rest).empty()) break;
        const std::optional<mrpt::Clock::time_point> time = timeOf(text);
        const std::string where = path.string() + ":" + std::to_string(line) + ": ";
        if (!time)
        {
            throw std::runtime_error(where + "expected a time like 2011-09-26 13:02:25.963999987" +
                                     ", found " + inQuotes(text));
        }
        if (!times.empty() && *time <= times.back())
        {
            throw std::runtime_error(where + "the time is not after that of the line before");
        }
        times.push_back(*time);
    }
    return times;
}

}  // namespace vdamf
