// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/swept_key.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "split.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr int kDigits = 10;
constexpr int kLogDigits = 4;
constexpr double kMostValues = 10000;

[[noreturn]] void fail(std::string_view text, const std::string& what)
{
    throw std::runtime_error(inQuotes(text) + ": " + what);
}

// Sums of steps end in digits that nobody wrote.
std::string rounded(double value, int digits)
{
    std::array<char, 40> text = {};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    return toText(std::strtod(text.data(), nullptr));
}

std::vector<double> numbersOf(std::string_view whole, std::string_view range)
{
    std::vector<double> numbers;
    for (const std::string& part : split(range, ':'))
    {
        const std::optional<double> number = parseNumber(part);
        if (!number) fail(whole, "expected a number, found " + inQuotes(part));
        numbers.push_back(*number);
    }
    return numbers;
}

SweptInterval intervalOf(std::string_view whole, double min, double max, bool logarithmic)
{
    if (min >= max) fail(whole, "the range is empty: its end must be above its start");
    if (logarithmic && min <= 0.0) fail(whole, "a log range must start above 0");
    return {min, max, logarithmic};
}

std::vector<std::string> steps(std::string_view whole, double from, double step, double to)
{
    if (step == 0.0 || (to - from) / step < 0.0)
        fail(whole, "the range is empty: this step does not lead from its start to its end");
    // The end counts as met where only rounding keeps it out.
    const double last = std::floor((to - from) / step + 1e-9);
    if (last >= kMostValues) fail(whole, "more than " + toText(kMostValues) + " values");
    std::vector<std::string> values;
    for (int i = 0; i <= static_cast<int>(last); ++i)
        values.push_back(rounded(from + i * step, kDigits));
    return values;
}

std::vector<std::string> ratios(std::string_view whole, const SweptInterval& range, double count)
{
    if (count != std::floor(count) || count < 2.0 || count > kMostValues)
        fail(whole,
             "expected 'log from : to : count' with a count from 2 to " + toText(kMostValues));
    std::vector<std::string> values;
    for (int i = 0; i < static_cast<int>(count); ++i)
    {
        const double place = i / (count - 1.0);
        values.push_back(rounded(range.min * std::pow(range.max / range.min, place), kLogDigits));
    }
    return values;
}

void readLogRange(std::string_view text, SweptKey& key)
{
    const std::vector<double> numbers = numbersOf(text, text.substr(4));
    if (numbers.size() < 2 || numbers.size() > 3)
        fail(text, "expected 'log from : to : count' or 'log from : to'");
    const SweptInterval range = intervalOf(text, numbers[0], numbers[1], true);
    if (numbers.size() == 2)
        key.interval = range;
    else
        key.values = ratios(text, range, numbers[2]);
}

void readRange(std::string_view text, SweptKey& key)
{
    const std::vector<double> numbers = numbersOf(text, text);
    if (numbers.size() > 3) fail(text, "expected 'from : step : to' or 'from : to'");
    if (numbers.size() == 2)
        key.interval = intervalOf(text, numbers[0], numbers[1], false);
    else
        key.values = steps(text, numbers[0], numbers[1], numbers[2]);
}

// What tells a value from others: numbers are what they say, 0.2 and 2e-1 the same.
std::string meaningOf(const std::string& value)
{
    const std::optional<double> number = parseNumber(value);
    return number ? toText(*number + 0.0) : value;  // no negative zero
}

void readList(std::string_view text, SweptKey& key)
{
    key.values = split(text, ',');
    std::map<std::string, std::string> known;
    for (const std::string& value : key.values)
    {
        if (value.empty()) fail(text, "a value is missing");
        const auto [same, isNew] = known.try_emplace(meaningOf(value), value);
        if (isNew) continue;
        if (same->second == value) fail(text, "the value " + inQuotes(value) + " stands twice");
        fail(text, "the values " + inQuotes(same->second) + " and " + inQuotes(value) +
                       " are the same number");
    }
}
}  // namespace

SweptKey parseSweptKey(const std::string& name, std::string_view text, int line)
{
    SweptKey key;
    key.name = name;
    key.line = line;
    if (text.substr(0, 4) == "log ")
        readLogRange(text, key);
    else if (text.find(':') != std::string_view::npos)
        readRange(text, key);
    else
        readList(text, key);
    return key;
}

std::string valueAt(const SweptInterval& interval, double place)
{
    constexpr int kIntervalDigits = 6;
    const double value = interval.logarithmic
                             ? interval.min * std::pow(interval.max / interval.min, place)
                             : interval.min + place * (interval.max - interval.min);
    return rounded(std::clamp(value, interval.min, interval.max), kIntervalDigits);
}

}  // namespace vdamf
