// SPDX-License-Identifier: BSD-3-Clause
// Accuracy and time of the measurement, ours and published ones, side by side in one run.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "measurement/case_table.h"
#include "measurement/dot_plot.h"
#include "measurement/recorded.h"
#include "measurement/tables.h"
#include "program.h"
#include "vdamf/files/folder.h"
#include "vdamf/files/ini.h"
#include "vdamf/files/text_file.h"
#include "vdamf/learning/clusters/simulated_clusters.h"
#include "vdamf/rawlog/filter_file.h"

namespace
{
namespace fs = std::filesystem;

struct Cli
{
    int clusters = 200;
    std::uint64_t seed = 1;
    std::string data;
    std::string out;
    std::vector<std::string> only;
    std::vector<std::string> fits;
    std::vector<std::string> set;
    std::string filters;
    bool noTiming = false;
};

void declare(CLI::App& app, Cli& cli)
{
    app.add_option("--clusters", cli.clusters, "clusters a condition")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    app.add_option("--seed", cli.seed, "seed of everything drawn at random")->capture_default_str();
    app.add_option("--data", cli.data, "folder with unpacked KITTI raw drives with tracklets");
    app.add_option("--out", cli.out,
                   "folder for measurement.csv, .md, .svg, cases.csv, timing.csv");
    app.add_option("--only", cli.only, "conditions to run, by commas")->delimiter(',');
    app.add_option("--fits", cli.fits, "methods to run, by commas")->delimiter(',');
    app.add_option("--set", cli.set, "measurement.key=value for all our fits (repeatable)")
        ->allow_extra_args(false);
    app.add_option("--filters", cli.filters,
                   "file of vdamf-train filter, for the rows learned and bank");
    app.add_flag("--no-timing", cli.noTiming, "leave out the table of times by number of hits");
}

bool wanted(const std::vector<std::string>& names, const std::string& name)
{
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

// Throws where a name of the command line is not among those that exist.
void requireKnown(const std::vector<std::string>& asked, const std::vector<std::string>& known,
                  const std::string& option)
{
    for (const std::string& name : asked)
    {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        std::string list;
        for (const std::string& one : known) list += " " + one;
        throw std::invalid_argument(option + " " + name + ": unknown; there are" + list);
    }
}

std::vector<vdamf::Method> methodsOf(const Cli& cli)
{
    vdamf::IniDocument document = vdamf::IniDocument::parse("", "built-in configuration");
    for (const std::string& assignment : cli.set) document.set(assignment);
    vdamf::MeasureOptions options;
    vdamf::IniReader reader(document);
    reader.read("measurement", options);
    reader.finish();
    std::shared_ptr<const vdamf::FilterBank> bank;
    if (!cli.filters.empty())
        bank = std::make_shared<const vdamf::FilterBank>(
            vdamf::parseFilterBank(vdamf::readTextFile(cli.filters), cli.filters));
    std::vector<vdamf::Method> methods;
    std::vector<std::string> names;
    for (vdamf::Method& method : vdamf::allMethods(options, bank))
    {
        names.push_back(method.name);
        if (wanted(cli.fits, method.name)) methods.push_back(std::move(method));
    }
    requireKnown(cli.fits, names, "--fits");
    return methods;
}

std::vector<vdamf::LabelledClusters> conditionsOf(const Cli& cli)
{
    std::vector<std::string> names = {"drive_label", "drive_cluster"};
    for (const vdamf::SimulatedKind& kind : vdamf::simulatedKinds()) names.push_back(kind.name);
    requireKnown(cli.only, names, "--only");
    std::vector<vdamf::LabelledClusters> all;
    for (const vdamf::SimulatedKind& kind : vdamf::simulatedKinds())
    {
        if (wanted(cli.only, kind.name))
            all.push_back(vdamf::simulatedCondition(kind, cli.clusters, cli.seed));
    }
    if (!wanted(cli.only, names[0]) && !wanted(cli.only, names[1])) return all;
    if (cli.data.empty())
    {
        std::printf("no real drives: --data names a folder with unpacked KITTI raw drives\n");
        return all;
    }
    for (vdamf::LabelledClusters& condition :
         vdamf::recordedConditions(cli.data, cli.clusters, cli.seed))
        if (wanted(cli.only, condition.name)) all.push_back(std::move(condition));
    return all;
}

// Results of a run, for the files.
struct Results
{
    std::vector<vdamf::CaseSummary> rows;
    std::string cases = vdamf::casesHeader();
};

vdamf::CaseSummary measured(const vdamf::LabelledClusters& condition, const vdamf::Method& method,
                            Results& results)
{
    std::vector<vdamf::CaseErrors> errors;
    std::vector<double> hits;
    for (const vdamf::LabelledCluster& sample : condition.samples)
    {
        errors.push_back(vdamf::errorsOf(method.estimate(sample), sample));
        hits.push_back(static_cast<double>(sample.cluster.size()));
        results.cases +=
            vdamf::caseLine(condition.name, method.name, errors.size() - 1, sample, errors.back());
    }
    vdamf::CaseSummary summary = vdamf::summaryOf(errors);
    summary.condition = condition.name;
    summary.method = method.name;
    summary.medianHits = vdamf::quantile(hits, 0.5);
    summary.microseconds = vdamf::microsecondsPerEstimate(method, condition.samples, 0.0);
    return summary;
}

// What the picture has room for: the filters and the first two baselines.
std::vector<vdamf::CaseSummary> pictured(const std::vector<vdamf::CaseSummary>& rows)
{
    const auto isLeftOut = [](const vdamf::CaseSummary& row)
    {
        const bool isVariant =
            row.method.rfind("nlopt_", 0) == 0 || row.method.find("+sizes") != std::string::npos;
        return isVariant || row.method == "minimum_area" || row.method == "pca";
    };
    std::vector<vdamf::CaseSummary> kept;
    std::remove_copy_if(rows.begin(), rows.end(), std::back_inserter(kept), isLeftOut);
    return kept;
}

int run(const Cli& cli)
{
    const std::vector<vdamf::Method> methods = methodsOf(cli);
    if (!cli.out.empty()) vdamf::makeFolder(cli.out);
    std::printf("%s", vdamf::legend().c_str());
    Results results;
    for (const vdamf::LabelledClusters& condition : conditionsOf(cli))
    {
        std::vector<vdamf::CaseSummary> block;
        for (const vdamf::Method& method : methods)
            block.push_back(measured(condition, method, results));
        std::printf("%s", vdamf::terminalBlock(condition, block).c_str());
        std::fflush(stdout);
        results.rows.insert(results.rows.end(), block.begin(), block.end());
    }
    vdamf::Timing timing;
    if (!cli.noTiming)
    {
        timing = vdamf::timed(methods, {30, 100, 300, 1000, 3000}, cli.seed);
        std::printf("%s", vdamf::terminalTiming(timing).c_str());
    }
    if (cli.out.empty()) return vdamf::kDone;
    const fs::path out = cli.out;
    vdamf::writeTextFile(out / "measurement.csv", vdamf::toCsv(results.rows));
    vdamf::writeTextFile(out / "measurement.md", vdamf::markdownPage(results.rows, timing));
    vdamf::writeTextFile(out / "measurement.svg", vdamf::dotPlot(pictured(results.rows)));
    vdamf::writeTextFile(out / "cases.csv", results.cases);
    if (!cli.noTiming) vdamf::writeTextFile(out / "timing.csv", vdamf::timingCsv(timing));
    return vdamf::kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    Cli cli;
    return vdamf::runProgram(
        argc, argv,
        {"vdamf_benchmark_measurement",
         "Accuracy and time of the measurement, beside published ways to fit a box.",
         "Example:\n  vdamf_benchmark_measurement --only clean,car --fits "
         "coarse_to_fine,closeness",
         [&](CLI::App& app) { declare(app, cli); }, nullptr, [&] { return run(cli); }});
}
