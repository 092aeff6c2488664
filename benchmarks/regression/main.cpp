// SPDX-License-Identifier: BSD-3-Clause
// The regression bench: every scenario simulated or imported, tracked and scored with the
// project's programs; one table of what came out, held against bounds and an earlier table.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "program.h"
#include "regression/bounds.h"
#include "regression/comparison.h"
#include "regression/run.h"
#include "regression/scene_settings.h"
#include "regression/seeds.h"
#include "regression/starts.h"
#include "regression/tables.h"
#include "vdamf/files/folder.h"
#include "vdamf/files/text_file.h"

namespace
{
namespace fs = std::filesystem;

struct Cli
{
    std::string source = VDAMF_SOURCE_DIR;
    std::string apps = VDAMF_APPS_DIR;
    std::string tracker;
    std::string data;
    std::string out;
    std::string config;
    std::string bounds;
    std::string compare;
    std::vector<std::string> only;
    std::vector<std::string> set;
    std::vector<std::string> scene;
    unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
    int seeds = 0;
    int starts = 0;
    bool fast = false;
    bool keep = false;
};

void declare(CLI::App& app, Cli& cli)
{
    CLI::Option* only =
        app.add_option("--only", cli.only, "scenarios to run, by commas")->delimiter(',');
    app.add_flag("--fast", cli.fast, "a few scenarios, in half a minute")->excludes(only);
    CLI::Option* seeds =
        app.add_option("--seeds", cli.seeds,
                       "each simulated scenario with so many seeds: ANEES with its 95 % band")
            ->check(CLI::Range(1, 10000));
    app.add_option("--starts", cli.starts,
                   "each scenario from so many of its first frames on: means and their spread, and "
                   "with --compare which changes are more than chance")
        ->check(CLI::Range(1, 1000))
        ->excludes(seeds);
    app.add_option("--data", cli.data,
                   "folder with recordings: KITTI raw drives, av2_samples of Argoverse 2")
        ->check(CLI::ExistingDirectory);
    app.add_option("--compare", cli.compare, "an earlier regression.csv: print what changed")
        ->check(CLI::ExistingFile);
    app.add_option("--set", cli.set, "section.key=value for vdamf-track (repeatable)")
        ->allow_extra_args(false);
    app.add_option("--scene", cli.scene,
                   "section.key=value for vdamf-simulate (repeatable), as sensor.model=HDL-64E: "
                   "simulated scenarios alone, without bounds")
        ->allow_extra_args(false);
    app.add_option("-c,--config", cli.config, "configuration of vdamf-track; default: config.ini")
        ->check(CLI::ExistingFile);
    app.add_option("--bounds", cli.bounds, "table of bounds; default: that of the source tree")
        ->check(CLI::ExistingFile);
    app.add_option("--out", cli.out, "folder for all outputs; default: results/regression");
    app.add_option("--apps", cli.apps, "folder of the programs; default: those of the build");
    app.add_option("--tracker", cli.tracker,
                   "another program, called as vdamf-track is (-c, -i, --tracks, --set, "
                   "--overwrite), to compare with; has no bounds")
        ->check(CLI::ExistingFile);
    app.add_option("--source", cli.source, "source tree with datasets/ and config.ini")
        ->check(CLI::ExistingDirectory);
    app.add_option("--jobs", cli.jobs, "runs at once; default: one a core")
        ->check(CLI::Range(1, 1024));
    app.add_flag("--keep", cli.keep, "keep the rawlogs");
}

Cli completed(Cli cli)
{
    const fs::path source = cli.source;
    if (cli.config.empty()) cli.config = (source / "config.ini").string();
    if (cli.bounds.empty())
        cli.bounds = (source / "benchmarks" / "regression" / "bounds.csv").string();
    if (cli.out.empty()) cli.out = (source / "results" / "regression").string();
    if (!cli.tracker.empty()) cli.tracker = fs::absolute(cli.tracker).string();
    return cli;
}

std::string list(const std::string& title, const std::vector<std::string>& items)
{
    if (items.empty()) return "";
    std::string text = "\n" + title + "\n";
    for (const std::string& item : items) text += "- " + item + "\n";
    return text;
}

struct Results
{
    std::vector<vdamf::RegressionRow> rows;
    std::vector<std::string> failures;
};

Results resultsOf(const std::vector<vdamf::RegressionScenario>& scenarios, const Cli& cli)
{
    const vdamf::RegressionOptions options{cli.apps, cli.tracker, cli.config, cli.set,
                                           cli.out,  cli.keep,    cli.jobs};
    std::size_t count = 0;
    const auto told = [&](const vdamf::RunOutcome& run)
    {
        std::fprintf(stderr, "[%zu/%zu] %s: %s, %.1f s\n", ++count, scenarios.size(),
                     run.row.scenario.c_str(), run.failure.empty() ? "done" : "FAILED",
                     run.seconds);
    };
    Results results;
    for (const vdamf::RunOutcome& run : vdamf::runScenarios(scenarios, options, told))
    {
        if (run.failure.empty())
            results.rows.push_back(run.row);
        else
            results.failures.push_back(run.row.scenario + ": " + run.failure);
    }
    return results;
}

// What is run, and what its results are held against.
struct Plan
{
    std::vector<vdamf::RegressionScenario> scenarios;
    std::vector<std::string> notes;  // on what is left out
    std::vector<vdamf::Bound> bounds;
    std::vector<vdamf::RegressionRow> before;
};

Plan planOf(const Cli& cli)
{
    const vdamf::Catalogue catalogue =
        vdamf::catalogueOf(fs::path(cli.source) / "datasets", cli.data);
    Plan plan;
    plan.scenarios = vdamf::chosenFrom(catalogue, cli.only, cli.fast);
    if (!cli.scene.empty()) plan.scenarios = vdamf::withSceneSettings(plan.scenarios, cli.scene);
    if (cli.seeds > 0) plan.scenarios = vdamf::withSeeds(plan.scenarios, cli.seeds);
    if (cli.starts > 0) plan.scenarios = vdamf::withStarts(plan.scenarios, cli.starts);
    if (!cli.fast && cli.only.empty() && cli.scene.empty()) plan.notes = catalogue.notes;
    if (cli.tracker.empty() && cli.scene.empty()) plan.bounds = vdamf::readBounds(cli.bounds);
    // Before the run: it may be the table that is about to be replaced.
    if (!cli.compare.empty()) plan.before = vdamf::readRegressionTable(cli.compare);
    return plan;
}

int run(const Cli& cli, const Plan& plan)
{
    for (const std::string& note : plan.notes) std::printf("%s\n", note.c_str());
    const fs::path out = cli.out;
    vdamf::makeFolder(out);
    const Results results = resultsOf(plan.scenarios, cli);
    const std::vector<std::string> broken = vdamf::violations(plan.bounds, results.rows);
    const std::string problems =
        list("Failed:", results.failures) + list("Bounds violated (" + cli.bounds + "):", broken);
    vdamf::writeTextFile(out / "regression.csv", vdamf::toCsv(results.rows));
    vdamf::writeTextFile(out / "regression.md", "# Regression\n\n" +
                                                    vdamf::markdownTable(results.rows) + "\n" +
                                                    vdamf::tableLegend() + problems);
    if (cli.seeds > 0)
        std::printf("%s", vdamf::seedsTable(results.rows).c_str());
    else if (cli.starts > 0)
        std::printf("%s", vdamf::startsTable(results.rows, plan.before).c_str());
    else
        std::printf("%s%s", vdamf::terminalTable(results.rows).c_str(),
                    vdamf::tableLegend().c_str());
    if (!cli.compare.empty() && cli.starts == 0)
        std::printf("\nCompared with %s:\n%s", cli.compare.c_str(),
                    vdamf::inWords(vdamf::compared(plan.before, results.rows)).c_str());
    std::printf("%s\ntable: %s\n", problems.c_str(), (out / "regression.csv").c_str());
    return problems.empty() ? vdamf::kDone : vdamf::kFailed;
}
}  // namespace

int main(int argc, char** argv)
{
    Cli cli;
    Plan plan;
    const auto prepare = [&]
    {
        cli = completed(cli);
        plan = planOf(cli);
    };
    return vdamf::runProgram(
        argc, argv,
        {"vdamf_regression", "Tracks and scores every scenario, and says what changed.",
         "Example:\n  vdamf_regression --fast --compare before/regression.csv\n"
         "Exit codes: 0 done; 1 a run failed or left its bounds; 2 bad command line.",
         [&](CLI::App& app) { declare(app, cli); }, prepare, [&] { return run(cli, plan); }});
}
