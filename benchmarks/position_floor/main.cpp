// SPDX-License-Identifier: BSD-3-Clause
// How well positions in the simulated scenarios can be known, beside how well they are tracked.
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "position_floor/floor.h"
#include "position_floor/table.h"
#include "program.h"
#include "regression/catalogue.h"
#include "regression/seeds.h"
#include "regression/side_by_side.h"
#include "regression/tables.h"
#include "vdamf/files/ini.h"

namespace
{
namespace fs = std::filesystem;

struct Cli
{
    std::string source = VDAMF_SOURCE_DIR;
    std::string tracked;
    std::vector<std::string> only;
    int seeds = 24;
    double limit = 0.12;
    unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
};

void declare(CLI::App& app, Cli& cli)
{
    app.add_option("--seeds", cli.seeds, "runs of each scenario; default: 24")
        ->check(CLI::Range(1, 10000));
    app.add_option("--only", cli.only, "scenarios, by commas")->delimiter(',');
    app.add_option("--tracked", cli.tracked,
                   "regression.csv of vdamf_regression with as many seeds: shown beside")
        ->check(CLI::ExistingFile);
    app.add_option("--limit", cli.limit, "count runs with a larger RMS, m; default: 0.12")
        ->check(vdamf::within(0.0, 100.0));
    app.add_option("--source", cli.source, "source tree with datasets/")
        ->check(CLI::ExistingDirectory);
    app.add_option("--jobs", cli.jobs, "runs at once; default: one a core")
        ->check(CLI::Range(1, 1024));
}

// One who knows the class of each vehicle, and one who takes trucks and buses for the same.
struct Floors
{
    vdamf::PositionFloor known;
    vdamf::PositionFloor alike;
};

Floors floorsOf(const vdamf::RegressionScenario& run)
{
    const std::vector<std::string>& arguments = run.make;  // of vdamf-simulate
    const vdamf::IniDocument usual = vdamf::IniDocument::load(arguments[1]);
    vdamf::IniDocument varied = usual;
    for (std::size_t i = 2; i + 1 < arguments.size(); ++i)
        if (arguments[i] == "--set") varied.set(arguments[i + 1]);
    const vdamf::Scenario scenario = vdamf::readScenario(varied);
    const vdamf::Scenario ofUsual = vdamf::readScenario(usual);
    const vdamf::SeenBoxes seen = vdamf::seenBoxes(scenario);
    return {vdamf::positionFloor(seen, scenario, ofUsual),
            vdamf::positionFloor(seen, scenario, vdamf::withHeaviesAlike(ofUsual))};
}

vdamf::RegressionRow rowOf(const std::string& run, double position)
{
    vdamf::RegressionRow row{run, vdamf::MetricValues(vdamf::metrics().size())};
    row.values[*vdamf::metricIndex("position_rms_m")] = position;
    return row;
}

std::vector<Floors> floorsOf(const std::vector<vdamf::RegressionScenario>& runs, unsigned jobs)
{
    std::vector<Floors> floors(runs.size());
    std::atomic<std::size_t> done{0};
    vdamf::sideBySide(runs.size(), jobs,
                      [&](std::size_t i)
                      {
                          floors[i] = floorsOf(runs[i]);
                          std::fprintf(stderr, "[%zu/%zu] %s\n", ++done, runs.size(),
                                       runs[i].name.c_str());
                      });
    return floors;
}

int run(const std::vector<vdamf::RegressionScenario>& runs,
        const std::vector<vdamf::RegressionRow>& tracked, const Cli& cli)
{
    const std::vector<Floors> floors = floorsOf(runs, cli.jobs);
    vdamf::FloorRows rows;
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
        if (floors[i].known.boxes == 0) continue;
        rows.online.push_back(rowOf(runs[i].name, floors[i].known.online));
        rows.alike.push_back(rowOf(runs[i].name, floors[i].alike.online));
        rows.hindsight.push_back(rowOf(runs[i].name, floors[i].known.hindsight));
    }
    std::printf("%s", vdamf::floorTable(rows, tracked, cli.limit).c_str());
    return vdamf::kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    Cli cli;
    std::vector<vdamf::RegressionScenario> runs;
    std::vector<vdamf::RegressionRow> tracked;
    const auto prepare = [&]
    {
        const vdamf::Catalogue catalogue =
            vdamf::catalogueOf(fs::path(cli.source) / "datasets", {});
        runs = vdamf::withSeeds(vdamf::chosenFrom(catalogue, cli.only, false), cli.seeds);
        if (!cli.tracked.empty()) tracked = vdamf::readRegressionTable(cli.tracked);
    };
    return vdamf::runProgram(
        argc, argv,
        {"vdamf_position_floor",
         "Tells how well positions can be known: ends that no hit has shown yet are somewhere.",
         "Example:\n  vdamf_regression --seeds 24 --out seeds\n"
         "  vdamf_position_floor --seeds 24 --tracked seeds/regression.csv",
         [&](CLI::App& app) { declare(app, cli); }, prepare,
         [&] { return run(runs, tracked, cli); }});
}
