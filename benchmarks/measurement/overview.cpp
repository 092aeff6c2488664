// SPDX-License-Identifier: BSD-3-Clause
#include "measurement/overview.h"

#include <cmath>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr const char* kDefault = "face_lines+start";
constexpr const char* kCompared[] = {kDefault, "coarse_to_fine+start", "paper+start", "closeness",
                                     "variance"};

std::string toText(double value, int decimals)
{
    return std::isfinite(value) ? toFixedText(value, decimals) : "-";
}

const CaseSummary* rowOf(const std::vector<CaseSummary>& rows, const std::string& condition,
                         const std::string& method)
{
    for (const CaseSummary& row : rows)
        if (row.condition == condition && row.method == method) return &row;
    return nullptr;
}

std::string centimetres(const ErrorFigures& figures)
{
    return toText(100.0 * figures.median, 1) + " (" + toText(100.0 * figures.bias, 1) + ")";
}

std::string ofTheDefault(const CaseSummary& s)
{
    return " | " + centimetres(s.end) + " | " + centimetres(s.side) + " | " +
           toText(100.0 * s.length.median, 0) + " | " + toText(100.0 * s.width.median, 0) + " | " +
           toText(s.neesMean, 2) + " (" + toText(s.neesLow, 2) + "-" + toText(s.neesHigh, 2) +
           ") | " + toText(100.0 * s.within68, 0) + " / " + toText(100.0 * s.within95, 0) + " / " +
           toText(100.0 * s.within99, 0) + " |\n";
}
}  // namespace

std::string overview(const std::vector<CaseSummary>& rows)
{
    std::string head = "\n| |";
    std::string line = "|---|";
    for (const char* quantity : {"heading", "corner"})
    {
        for (const char* method : kCompared)
        {
            head += std::string(" ") + (method == kDefault ? quantity + std::string(": ") : "") +
                    method + " |";
            line += "---|";
        }
    }
    head += " end | side | length | width | NEES | inside 68 / 95 / 99 % |\n";
    line += "---|---|---|---|---|---|\n";
    std::string table = head + line;
    std::string condition;
    for (const CaseSummary& row : rows)
    {
        if (row.condition == condition) continue;
        condition = row.condition;
        table += "| " + condition;
        for (const char* method : kCompared)
        {
            const CaseSummary* s = rowOf(rows, condition, method);
            table += " | ";
            if (s != nullptr)
                table += toText(s->heading90.median, 2) + " / " + toText(s->heading90.p90, 1);
        }
        for (const char* method : kCompared)
        {
            const CaseSummary* s = rowOf(rows, condition, method);
            table += " | ";
            if (s != nullptr) table += toText(100.0 * s->corner.median, 1);
        }
        const CaseSummary* own = rowOf(rows, condition, kDefault);
        table += own != nullptr ? ofTheDefault(*own) : " | | | | | | |\n";
    }
    return table;
}

}  // namespace vdamf
