// SPDX-License-Identifier: BSD-3-Clause
#include "regression/seeds.h"

#include <array>
#include <cstdio>
#include <utility>

#include "regression/groups.h"
#include "regression/variation.h"
#include "vdamf/evaluation/chi_square.h"

namespace vdamf
{
namespace
{
constexpr double kTail = 0.025;

struct Nees
{
    const char* title;
    const char* metric;
    int dimension;
};
constexpr std::array<Nees, 3> kNees{{{"pose", "nees_pose_mean", 3},
                                     {"speed", "nees_speed_mean", 1},
                                     {"size", "nees_size_mean", 2}}};

constexpr std::array<TitledMetric, 4> kErrors{{{"pos m", "position_rms_m"},
                                               {"head deg", "heading_rms_deg"},
                                               {"speed m/s", "speed_rms_mps"},
                                               {"yaw deg/s", "yaw_rate_rms_degps"}}};

struct Band
{
    double low = 0.0;
    double high = 0.0;
};

// Of the mean over independent runs, per degree of freedom.
Band bandOf(std::size_t runs, int dimension)
{
    const double freedom = static_cast<double>(runs) * dimension;
    return {chiSquareQuantile(kTail, freedom) / freedom,
            chiSquareQuantile(1.0 - kTail, freedom) / freedom};
}

std::string neesCell(const RegressionGroup& group, const Nees& nees)
{
    const std::vector<double> values = knownValues(group.second, nees.metric);
    if (values.empty()) return "               -";
    const Band band = bandOf(values.size(), nees.dimension);
    const double mean = meanOf(values);
    const char* mark = mean > band.high ? "*" : (mean < band.low ? "." : " ");
    return cell("%7.2f", mean) + mark + cell(" %3.2f", band.low) + cell("-%3.2f", band.high);
}

std::string lineOf(const RegressionGroup& group)
{
    std::array<char, 64> begin{};
    std::snprintf(begin.data(), begin.size(), "%-26.26s%4zu", group.first.c_str(),
                  group.second.size());
    std::string line = begin.data();
    for (const Nees& nees : kNees) line += neesCell(group, nees);
    for (const TitledMetric& error : kErrors)
    {
        const std::vector<double> values = knownValues(group.second, error.metric);
        line += values.empty() ? "         -" : cell("%10.3f", rmsOf(values));
    }
    return line + "\n";
}
}  // namespace

std::vector<RegressionScenario> withSeeds(const std::vector<RegressionScenario>& scenarios,
                                          int count)
{
    std::vector<RegressionScenario> all;
    for (const RegressionScenario& scenario : scenarios)
    {
        if (scenario.make.front() != "vdamf-simulate") continue;
        const IniDocument document = IniDocument::load(scenario.make[1]);
        for (int seed = 1; seed <= count; ++seed)
        {
            RegressionScenario one = scenario;
            one.name += "/seed_" + std::to_string(seed);
            one.make.insert(one.make.end(), {"--set", "scenario.seed=" + std::to_string(seed)});
            for (const std::string& assignment :
                 variationOf(document, static_cast<std::uint64_t>(seed)))
                one.make.insert(one.make.end(), {"--set", assignment});
            all.push_back(std::move(one));
        }
    }
    return all;
}

std::string seedsTable(const std::vector<RegressionRow>& rows)
{
    std::array<char, 192> heading{};
    std::snprintf(heading.data(), heading.size(), "%-26s%4s%8s%-9s%8s%-9s%8s%-9s%10s%10s%10s%10s\n",
                  "", "runs", kNees[0].title, "  95 %", kNees[1].title, "  95 %", kNees[2].title,
                  "  95 %", kErrors[0].title, kErrors[1].title, kErrors[2].title, kErrors[3].title);
    std::string table = "ANEES (1 is right; * too confident, . too cautious) and RMS errors\n";
    table += heading.data();
    const std::vector<RegressionGroup> groups = byScenario(rows);
    for (const RegressionGroup& group : groups) table += lineOf(group);
    if (groups.size() > 1) table += lineOf({"all, as one population", rows});
    return table;
}

}  // namespace vdamf
