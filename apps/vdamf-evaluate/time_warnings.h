// SPDX-License-Identifier: BSD-3-Clause
// What vdamf-evaluate says where the times of both tables do not meet: such frames count, and their
// numbers would pass for those of the tracker.
#pragma once

#include <string>
#include <vector>

#include "vdamf/evaluation/tables.h"

namespace vdamf
{
/// The tables and where they come from.
struct ScoredTables
{
    std::vector<TruthRow> truth;
    std::vector<TrackRow> tracks;
    std::string truthName;
    std::string tracksName;
};

/// On stderr, each where it is met: frames of the tracks that the truth has no row of, frames of
/// the truth outside of the tracks' times, and frames of both that lie beside each other.
void warnOfTimes(const ScoredTables& tables, double tolerance);

}  // namespace vdamf
