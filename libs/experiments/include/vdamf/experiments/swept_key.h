// SPDX-License-Identifier: BSD-3-Clause
// A key of the configuration that a sweep changes, and the values that it takes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vdamf
{
/// Where the values of a key lie when any number between two ends will do.
struct SweptInterval
{
    double min = 0.0;
    double max = 0.0;
    bool logarithmic = false;
};

struct SweptKey
{
    std::string name;                       ///< section.key
    int line = 0;                           ///< in the sweep's file
    std::vector<std::string> values;        ///< as in the configuration; empty: an interval
    std::optional<SweptInterval> interval;  ///< instead of values
};

/// Reads what may stand behind a swept key:
///
///     a, b, c               these values
///     0.10 : 0.05 : 0.30    from, step, to (which is met or not)
///     0.1 : 0.3             any number between: for plans that draw or search
///     log 0.01 : 1 : 5      five numbers from 0.01 to 1 with equal ratios
///     log 0.01 : 1          any number between, equal ratios alike
///
/// Numbers have at most 10 significant digits, those of log ranges 4. Throws std::runtime_error
/// that says what is wrong: a part that is no number, an empty range, a value that stands twice
/// (numbers in any spelling), too many values.
SweptKey parseSweptKey(const std::string& name, std::string_view text, int line);

/// The number of the interval at a place from 0 to 1, as in the configuration: with 6 significant
/// digits.
std::string valueAt(const SweptInterval& interval, double place);

}  // namespace vdamf
