// SPDX-License-Identifier: BSD-3-Clause
// The settings that a plan tries: one value for each swept key.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "vdamf/experiments/swept_key.h"

namespace vdamf
{
struct SweepSetting
{
    std::vector<std::string> values;  ///< by swept key
};

/// How many settings there are of the keys' values, as far as they can be counted; infinity where
/// a key has an interval.
double countOfSettings(const std::vector<SweptKey>& keys);

/// All of them; the last key changes fastest. Throws std::runtime_error where a key has an interval
/// in place of values.
std::vector<SweepSetting> gridSettings(const std::vector<SweptKey>& keys);

/// `count` different settings, drawn from the keys' values and intervals; with the same seed the
/// same ones. Throws std::runtime_error where there are not as many.
std::vector<SweepSetting> randomSettings(const std::vector<SweptKey>& keys, std::size_t count,
                                         std::uint64_t seed);

/// The setting at a point of the unit cube, one coordinate a key: the nearest value, or the number
/// of its interval.
SweepSetting settingAt(const std::vector<SweptKey>& keys, const std::vector<double>& point);

}  // namespace vdamf
