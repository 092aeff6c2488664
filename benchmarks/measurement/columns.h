// SPDX-License-Identifier: BSD-3-Clause
// The columns of all tables: one list for terminal, CSV and Markdown.
#pragma once

#include <string>
#include <vector>

#include "vdamf/learning/clusters/case_summary.h"

namespace vdamf
{
struct Column
{
    const char* name;     ///< in the CSV file, with unit
    const char* heading;  ///< in tables for people; empty: in the CSV file only
    int width;            ///< characters in tables for people
    int decimals;
    double (*value)(const CaseSummary&);
};

const std::vector<Column>& columns();

/// A number for people, blank where there is none, in `width` characters.
std::string cell(double value, int decimals, int width);

}  // namespace vdamf
