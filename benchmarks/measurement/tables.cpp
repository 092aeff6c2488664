// SPDX-License-Identifier: BSD-3-Clause
#include "measurement/tables.h"

#include <algorithm>
#include <cmath>

#include "measurement/columns.h"
#include "measurement/overview.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kMethodWidth = 20;

std::string padded(const std::string& text)
{
    return text + std::string(kMethodWidth - std::min(kMethodWidth, text.size()), ' ');
}

std::string rightAligned(const std::string& text, int width)
{
    const auto characters = static_cast<std::size_t>(width);
    return std::string(characters - std::min(characters, text.size()), ' ') + text;
}

std::string number(double value, int decimals)
{
    return std::isfinite(value) ? toFixedText(value, decimals) : "";
}

// Times of closeness, to compare with; nothing where it was not timed.
const TimingRow* yardstick(const Timing& timing)
{
    for (const TimingRow& row : timing.rows)
        if (row.method == "closeness") return &row;
    return nullptr;
}

// A time, with its ratio to the yardstick's.
std::string timeCell(const TimingRow& row, std::size_t i, const TimingRow* closeness)
{
    std::string text = number(row.microseconds[i], 1);
    if (closeness != nullptr)
        text += " (" + number(row.microseconds[i] / closeness->microseconds[i], 2) + ")";
    return text;
}

std::string markdownTiming(const Timing& timing)
{
    std::string page = "\n### Time of one estimate\n\nMicroseconds on one core";
    if (!timing.processor.empty()) page += " (" + timing.processor + ")";
    page += ", two faces of a car, all steps from the hits to box and covariance";
    const TimingRow* closeness = yardstick(timing);
    if (closeness != nullptr) page += "; in brackets: to closeness";
    page += ".\n\n| method |";
    for (const int hits : timing.hits) page += " " + std::to_string(hits) + " hits |";
    page += "\n|---|";
    for (std::size_t i = 0; i < timing.hits.size(); ++i) page += "---:|";
    page += "\n";
    for (const TimingRow& row : timing.rows)
    {
        page += "| " + row.method + " |";
        for (std::size_t i = 0; i < row.microseconds.size(); ++i)
            page += " " + timeCell(row, i, closeness) + " |";
        page += "\n";
    }
    return page;
}

std::string markdownHead(const CaseSummary& first)
{
    std::string head = "\n### " + first.condition + " (" + std::to_string(first.cases) +
                       " clusters, median " + number(first.medianHits, 0) + " hits)\n\n| method |";
    std::string line = "|---|";
    for (const Column& column : columns())
    {
        if (*column.heading == '\0') continue;
        head += std::string(" ") + column.heading + " |";
        line += "---:|";
    }
    return head + "\n" + line + "\n";
}
}  // namespace

std::string terminalBlock(const LabelledClusters& condition, const std::vector<CaseSummary>& rows)
{
    std::string block = "\n" + condition.name + ": " + condition.description;
    if (rows.empty()) return block + "\n";
    block += "; " + std::to_string(rows.front().cases) + " clusters, median " +
             number(rows.front().medianHits, 0) + " hits\n" + padded("");
    for (const Column& column : columns())
        if (*column.heading != '\0') block += rightAligned(column.heading, column.width);
    block += "\n";
    for (const CaseSummary& row : rows)
    {
        block += padded(row.method);
        for (const Column& column : columns())
        {
            if (*column.heading != '\0')
                block += cell(column.value(row), column.decimals, column.width);
        }
        block += "\n";
    }
    return block;
}

std::string legend()
{
    return "hdg: heading error to the nearest axis of the true box, deg; cross%: share taken "
           "across "
           "(length for width)\n"
           "corner: of the true corner nearest to the sensor, m; end, side: place of the face in "
           "view, m; +-: median\n"
           "of the signed error (outwards positive), |.|: median of its size; len, wid: where an "
           "end and a side are in view\n"
           "IoU: median and 10th percentile; NEES: mean by dimension, of heading and faces seen "
           "(1 is right, with its 95 % band); scale: factor\n"
           "on the covariance that makes its median right; 68% 95% 99%: share inside; iter: "
           "median; us: microseconds\n"
           "Our fits are told the sensor's range noise (10 cm in `noise`, 3 cm on other walls, "
           "2 cm on bodies and drives)\n"
           "and whether upright walls or bodies are in view (body_depth_m 0 or its default); "
           "+start: from a start with errors\n"
           "of 0.3 m in x, y, length, width and of 8 deg; others from the hits alone. nlopt_*: "
           "Table "
           "1 alone, as `paper`.\n"
           "NEES on the drives: with 6 cm and 1 deg for the errors of the labels. Times: of one "
           "thread on a processor\n";
}

std::string toCsv(const std::vector<CaseSummary>& rows)
{
    std::string table = "condition,method,clusters,hits_median";
    for (const Column& column : columns()) table += std::string(",") + column.name;
    table += "\n";
    for (const CaseSummary& row : rows)
    {
        table += row.condition + "," + row.method + "," + std::to_string(row.cases) + "," +
                 number(row.medianHits, 1);
        for (const Column& column : columns()) table += "," + number(column.value(row), 4);
        table += "\n";
    }
    return table;
}

std::string terminalTiming(const Timing& timing)
{
    constexpr int kWidth = 16;
    const TimingRow* closeness = yardstick(timing);
    std::string block = "\ntime of one estimate, us (in brackets: to closeness), by hits\n";
    block += padded("");
    for (const int hits : timing.hits) block += rightAligned(std::to_string(hits), kWidth);
    block += "\n";
    for (const TimingRow& row : timing.rows)
    {
        block += padded(row.method);
        for (std::size_t i = 0; i < row.microseconds.size(); ++i)
        {
            block += rightAligned(timeCell(row, i, closeness), kWidth);
        }
        block += "\n";
    }
    return block;
}

std::string timingCsv(const Timing& timing)
{
    std::string table = "method,hits,time_us\n";
    for (const TimingRow& row : timing.rows)
    {
        for (std::size_t i = 0; i < row.microseconds.size(); ++i)
            table += row.method + "," + std::to_string(timing.hits[i]) + "," +
                     number(row.microseconds[i], 3) + "\n";
    }
    return table;
}

std::string markdownPage(const std::vector<CaseSummary>& rows, const Timing& timing)
{
    std::string page = "## Measurement: fits and baselines\n\n```\n" + legend() + "```\n";
    page += overview(rows);
    std::string condition;
    for (const CaseSummary& row : rows)
    {
        if (row.condition != condition) page += markdownHead(row);
        condition = row.condition;
        page += "| " + row.method + " |";
        for (const Column& column : columns())
        {
            if (*column.heading != '\0')
                page += " " + number(column.value(row), column.decimals) + " |";
        }
        page += "\n";
    }
    if (!timing.rows.empty()) page += markdownTiming(timing);
    return page;
}

}  // namespace vdamf
