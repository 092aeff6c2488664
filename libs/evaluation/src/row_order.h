// SPDX-License-Identifier: BSD-3-Clause
// What all tables of frames have in common: rows by time, each identity once a time.
#pragma once

#include <limits>
#include <set>

#include "vdamf/files/csv.h"

namespace vdamf
{
template <class Id>
class RowOrder
{
public:
    /// Fails in the name of the reader's current row.
    void check(const CsvReader& reader, double time, const Id& id, const char* idColumn)
    {
        if (time < time_)
        {
            reader.fail("time_s", "the time goes back from " + toFixedText(time_, 6) +
                                      "; sort the table by time");
        }
        if (time > time_) ids_.clear();
        time_ = time;
        if (ids_.insert(id).second) return;
        reader.fail(idColumn, "'" + reader.text(idColumn) + "' stands a second time at " +
                                  reader.text("time_s") + " s; keep one of the rows");
    }

private:
    double time_ = -std::numeric_limits<double>::infinity();
    std::set<Id> ids_;
};

}  // namespace vdamf
