// SPDX-License-Identifier: BSD-3-Clause
// Numbers of a table that must lie in a range.
#pragma once

#include <string>

#include "vdamf/files/csv.h"

namespace vdamf
{
/// Sizes of boxes, m: what is larger was written in another unit, or is no object.
inline double sizeIn(const CsvReader& reader, const char* column)
{
    constexpr double kLargest = 1000.0;
    const double value = reader.number(column);
    if (value > 0.0 && value <= kLargest) return value;
    reader.fail(column, "expected a number above 0, of at most 1000 m, found '" +
                            reader.text(column) + "'");
}

inline double varianceIn(const CsvReader& reader, const char* column)
{
    const double value = reader.number(column);
    if (value >= 0.0) return value;
    reader.fail(column, "a variance is not below 0, found '" + reader.text(column) + "'");
}

}  // namespace vdamf
