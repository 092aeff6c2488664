// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include <cstdio>
#include <string>
#include <vector>

#include "vdamf/experiments/setting_configuration.h"
#include "vdamf/experiments/sweep_page.h"
#include "vdamf/files/output_file.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* kTable = "table.csv";
constexpr const char* kTimes = "times.csv";
constexpr const char* kPage = "report.html";
constexpr const char* kBest = "best.ini";

std::string inWords(std::optional<double> value)
{
    char text[40] = "-";
    if (value) std::snprintf(text, sizeof text, "%.4g", *value);
    return text;
}
}  // namespace

std::vector<std::string> outputNames()
{
    return {kSweepCopy, kTable, kTimes, kPage, kBest};
}

std::vector<NamedInput> inputsOf(const PreparedSweep& sweep)
{
    std::vector<NamedInput> inputs = filesOfSweep(sweep.file, sweep.base);
    inputs.push_back({sweep.file.path, "the sweep's file"});
    if (!sweep.file.sweep.config.empty())
        inputs.push_back({sweep.file.resolved(sweep.file.sweep.config), "the configuration"});
    for (const SweepRecording& recording : sweep.recordings)
    {
        inputs.push_back({recording.rawlog, "a recording"});
        inputs.push_back({recording.truth, "a truth"});
    }
    return inputs;
}

void checkOutputs(const PreparedSweep& sweep, const fs::path& folder)
{
    std::vector<fs::path> outputs;
    for (const std::string& name : outputNames()) outputs.push_back(folder / name);
    checkOutputPaths(outputs, inputsOf(sweep));
}

void writeSweepCopy(const PreparedSweep& sweep, const fs::path& folder)
{
    writeTextFile(folder / kSweepCopy, readTextFile(sweep.file.path));
}

void writeOutputs(const PreparedSweep& sweep, const SweepResults& results, const fs::path& folder)
{
    writeTextFile(folder / kTable, tableCsv(results));
    writeTextFile(folder / kTimes, timesCsv(results));
    writeTextFile(folder / kPage, sweepPage(results, sweep.file.path.stem().string()));
    const std::optional<std::size_t> best = bestSetting(results);
    if (best)
        writeTextFile(folder / kBest, settingIni(sweep, results, *best));
    else
        fs::remove(folder / kBest);
}

void printOutcome(const PreparedSweep& sweep, const SweepResults& results, std::size_t skipped,
                  const fs::path& folder)
{
    const auto counted = [](std::size_t count, const std::string& what)
    { return std::to_string(count) + " " + what + (count == 1 ? "" : "s"); };
    std::printf("%s, %s, %s", counted(results.settings.size(), "setting").c_str(),
                counted(results.recordings.size(), "recording").c_str(),
                counted(results.rows.size(), "run").c_str());
    if (skipped > 0) std::printf(" (%zu were done before)", skipped);
    std::printf("\n");
    for (const std::string& name : silentRecordings(results))
        std::printf("%s has no %s with any setting, and does not count\n", name.c_str(),
                    results.goal.metric.c_str());
    const std::optional<std::size_t> best = bestSetting(results);
    if (best)
    {
        const SettingSummary summary = summaries(results)[*best];
        std::printf("best   setting %zu: %s\n", *best + 1,
                    inWords(sweep.file, results.settings[*best]).c_str());
        for (std::size_t k = 0; k < results.metrics.size(); ++k)
            std::printf("       %-32s %s\n", results.metrics[k].c_str(),
                        inWords(summary.means[k]).c_str());
    }
    else
    {
        std::printf("no setting has %s in all recordings: there is no best one\n",
                    results.goal.metric.c_str());
    }
    std::printf("page   %s\n", (folder / kPage).c_str());
    std::printf("table  %s\n", (folder / kTable).c_str());
    if (best) std::printf("best   %s\n", (folder / kBest).c_str());
}

}  // namespace vdamf
