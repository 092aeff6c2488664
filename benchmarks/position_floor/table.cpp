// SPDX-License-Identifier: BSD-3-Clause
#include "position_floor/table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>

#include "regression/groups.h"

namespace vdamf
{
namespace
{
std::vector<double> positionsOf(const std::vector<RegressionRow>& rows)
{
    return knownValues(rows, "position_rms_m");
}

// Rows of the same runs; those that the table has.
std::vector<RegressionRow> sameRuns(const std::vector<RegressionRow>& rows,
                                    const std::vector<RegressionRow>& table)
{
    std::vector<RegressionRow> same;
    for (const RegressionRow& row : rows)
        if (const RegressionRow* found = findRow(table, row.scenario)) same.push_back(*found);
    return same;
}

std::string cells(const std::vector<double>& values, double limit)
{
    const auto above =
        std::count_if(values.begin(), values.end(), [&](double value) { return value > limit; });
    return cell("%9.3f", rmsOf(values)) + cell("%8.0f", static_cast<double>(above));
}

class Table
{
public:
    Table(const FloorRows& floor, const std::vector<RegressionRow>& tracked, double limit)
        : floor_(floor), tracked_(tracked), limit_(limit)
    {
        const std::string above = cell("> %.2f", limit);
        std::array<char, 128> heading{};
        std::snprintf(heading.data(), heading.size(), "%-24s%6s%11s%9s%8s%9s%8s", "", "runs",
                      "hindsight", "floor", above.c_str(), "alike", above.c_str());
        text_ = heading.data();
        if (!tracked.empty())
        {
            std::snprintf(heading.data(), heading.size(), "%9s%8s", "tracker", above.c_str());
            text_ += heading.data();
        }
        text_ += "\n";
    }

    void add(const RegressionGroup& group)
    {
        const std::vector<RegressionRow>& runs = group.second;
        std::array<char, 64> begin{};
        std::snprintf(begin.data(), begin.size(), "%-24.24s%6zu", group.first.c_str(), runs.size());
        text_ += begin.data() +
                 cell("%11.3f", rmsOf(positionsOf(sameRuns(runs, floor_.hindsight)))) +
                 cells(positionsOf(runs), limit_) +
                 cells(positionsOf(sameRuns(runs, floor_.alike)), limit_);
        if (!tracked_.empty())
        {
            const std::vector<double> values = positionsOf(sameRuns(runs, tracked_));
            text_ += values.size() == runs.size() ? cells(values, limit_) : "        -       -";
        }
        text_ += "\n";
    }

    const std::string& text() const { return text_; }

private:
    const FloorRows& floor_;
    const std::vector<RegressionRow>& tracked_;
    double limit_;
    std::string text_;
};
}  // namespace

std::string floorTable(const FloorRows& floor, const std::vector<RegressionRow>& tracked,
                       double limit)
{
    Table table(floor, tracked, limit);
    const std::vector<RegressionGroup> groups = byScenario(floor.online);
    for (const RegressionGroup& group : groups) table.add(group);
    if (groups.size() > 1) table.add({"all", floor.online});
    return "RMS of positions, m, of who knows all but how large each vehicle is;\n"
           "alike: and takes trucks and buses for the same\n" +
           table.text();
}

}  // namespace vdamf
