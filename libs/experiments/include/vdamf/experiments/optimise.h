// SPDX-License-Identifier: BSD-3-Clause
// The plan that searches: each setting is chosen by what those before came to.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "vdamf/experiments/settings.h"
#include "vdamf/experiments/sweep_file.h"

namespace vdamf
{
/// What a setting came to, to be made as large as possible; nothing: it failed.
using SettingScore = std::function<std::optional<double>(const SweepSetting&)>;

/// Tries at most `count` different settings, from the middle of the keys' ranges; each is asked for
/// once. The same scores give the same settings. An exception of `score` ends the search and goes
/// on to the caller.
void optimiseSettings(const std::vector<SweptKey>& keys, SweepOptimiser algorithm,
                      std::size_t count, const SettingScore& score);

/// What keeps these keys from being searched, as std::runtime_error: values that are no numbers, or
/// too few keys for the algorithm.
void checkSearchable(const std::vector<SweptKey>& keys, SweepOptimiser algorithm);

}  // namespace vdamf
