// SPDX-License-Identifier: BSD-3-Clause
// The numbers of an evaluation by name: where they stand in metrics.json, with dots between keys.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vdamf
{
/// All names, in their order: "hota.hota", "errors.position_m.median". The README of
/// vdamf-evaluate says what they mean.
const std::vector<std::string>& metricNames();

/// Throws std::runtime_error for a name that does not exist; it gives the nearest one.
void checkMetricName(const std::string& name);

/// The values of these metrics in a metrics.json; nothing: not known. Throws std::runtime_error
/// that names the file where it cannot be read or has no such key.
std::vector<std::optional<double>> readMetrics(const std::filesystem::path& file,
                                               const std::vector<std::string>& names);

}  // namespace vdamf
