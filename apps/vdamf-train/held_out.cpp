// SPDX-License-Identifier: BSD-3-Clause
#include "held_out.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
struct Figure
{
    const char* name;
    int decimals;
    double (*of)(const CaseSummary&);
    /// Distance from what is best.
    double (*off)(double);
};

double asItIs(double value)
{
    return value;
}

// Too large and too small by the same factor are as bad.
double fromOne(double value)
{
    return std::isfinite(value) ? std::abs(std::log(std::max(1e-6, value))) : value;
}

constexpr Figure kFigures[] = {
    {"heading_deg", 2, [](const CaseSummary& s) { return s.heading90.median; }, asItIs},
    {"heading_p90_deg", 2, [](const CaseSummary& s) { return s.heading90.p90; }, asItIs},
    {"corner_m", 3, [](const CaseSummary& s) { return s.corner.median; }, asItIs},
    {"corner_p90_m", 3, [](const CaseSummary& s) { return s.corner.p90; }, asItIs},
    {"length_m", 3, [](const CaseSummary& s) { return s.length.median; }, asItIs},
    {"length_p90_m", 3, [](const CaseSummary& s) { return s.length.p90; }, asItIs},
    {"width_m", 3, [](const CaseSummary& s) { return s.width.median; }, asItIs},
    {"width_p90_m", 3, [](const CaseSummary& s) { return s.width.p90; }, asItIs},
    {"nees", 2, [](const CaseSummary& s) { return s.neesMean; }, fromOne},
    {"within_95", 3, [](const CaseSummary& s) { return s.within95; },
     [](double value) { return std::abs(value - 0.95); }}};

std::string padded(const std::string& text, std::size_t width)
{
    return text + std::string(width - std::min(width - 1, text.size()), ' ');
}

std::string figureText(const Figure& figure, const CaseSummary& summary)
{
    const double value = figure.of(summary);
    return std::isfinite(value) ? toFixedText(value, figure.decimals) : std::string();
}
}  // namespace

std::string heldOutText(const std::vector<HeldOutCondition>& conditions)
{
    std::ostringstream out;
    out << padded("", 24) << padded("", 10) << "clusters  heading /  p90   corner /  p90    length"
        << " /  p90    width /  p90     NEES  95 %\n";
    for (const HeldOutCondition& condition : conditions)
        for (const CaseSummary& s : condition.methods)
        {
            out << padded(condition.name, 24) << padded(s.method, 10)
                << padded(std::to_string(s.cases), 10);
            for (const Figure& figure : kFigures) out << padded(figureText(figure, s), 9);
            out << '\n';
        }
    return out.str();
}

std::string heldOutHeader()
{
    std::string text = "held_out,condition,filter,clusters";
    for (const Figure& figure : kFigures) text += ',' + std::string(figure.name);
    return text + '\n';
}

std::string heldOutRows(const std::string& how, const std::vector<HeldOutCondition>& conditions)
{
    std::string text;
    for (const HeldOutCondition& condition : conditions)
        for (const CaseSummary& s : condition.methods)
        {
            text += how + ',' + condition.name + ',' + s.method + ',' + std::to_string(s.cases);
            for (const Figure& figure : kFigures) text += ',' + figureText(figure, s);
            text += '\n';
        }
    return text;
}

std::string scoreText(const std::vector<HeldOutCondition>& conditions, const std::string& method)
{
    constexpr double kEqual = 0.02;
    int better = 0;
    int equal = 0;
    int worse = 0;
    for (const HeldOutCondition& condition : conditions)
        for (const CaseSummary& s : condition.methods)
        {
            if (s.method != method) continue;
            for (const Figure& figure : kFigures)
            {
                const double before = figure.off(figure.of(condition.methods.front()));
                const double after = figure.off(figure.of(s));
                if (!std::isfinite(before) || !std::isfinite(after)) continue;
                const bool isEqual = std::abs(after - before) <= kEqual * std::max(before, 1e-3);
                ++(isEqual ? equal : after < before ? better : worse);
            }
        }
    return "better in " + std::to_string(better) + ", equal in " + std::to_string(equal) +
           ", worse in " + std::to_string(worse) + " of " + std::to_string(better + equal + worse) +
           " figures";
}

}  // namespace vdamf
