// SPDX-License-Identifier: BSD-3-Clause
// The configuration that a setting amounts to.
#pragma once

#include <string>
#include <vector>

#include "vdamf/experiments/settings.h"
#include "vdamf/experiments/sweep_file.h"
#include "vdamf/files/output_file.h"

namespace vdamf
{
/// The file that `[sweep] config` names, or the built-in configuration.
IniDocument baseDocument(const SweepFile& file);

/// Throws std::runtime_error that lists, by line of the sweep's file, every swept key that the
/// configuration does not have (with the nearest one), every value that it does not take, and every
/// key that the recordings set as well.
void checkKeys(const SweepFile& file, const IniDocument& base);

/// The effective configuration as ini: the base, what the recordings set, and the setting's values.
/// Throws std::runtime_error that names the setting where its values do not go together.
std::string configurationOf(const SweepFile& file, const IniDocument& base,
                            const RecordingGroup& group, const SweepSetting& setting);

/// Throws as configurationOf() does where any group of recordings is refused with the setting.
void checkSetting(const SweepFile& file, const IniDocument& base, const SweepSetting& setting);

/// The models and filters that any of its configurations names, each with its key. Of keys that
/// passed checkKeys().
std::vector<NamedInput> filesOfSweep(const SweepFile& file, const IniDocument& base);

/// "measurement.sigma_m = 0.2, clustering.gap_m = 0.4"
std::string inWords(const SweepFile& file, const SweepSetting& setting);

}  // namespace vdamf
