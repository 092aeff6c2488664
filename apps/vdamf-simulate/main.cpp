// SPDX-License-Identifier: BSD-3-Clause
// vdamf-simulate: a rawlog with exact truth from a scenario file.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "program.h"
#include "simulation_run.h"
#include "vdamf/rawlog/annotation.h"

namespace
{
struct CommandLine
{
    std::filesystem::path scenario;
    vdamf::SimulationOutputs outputs;
    bool overwrite = false;
    bool quiet = false;
    std::optional<int> seed;
    std::vector<std::string> set;
};

void declare(CLI::App& app, CommandLine& line)
{
    app.add_option("scenario", line.scenario, "Scenario file (ini)")->required();
    app.add_option("-o,--output", line.outputs.rawlog, "Rawlog to write")->required();
    app.add_option("--truth", line.outputs.truth, "Truth table to write (csv)");
    app.add_option("--set", line.set, "section.key=value over the scenario (repeatable)")
        ->allow_extra_args(false);
    app.add_flag("--overwrite", line.overwrite, "Replace existing outputs");
    app.add_flag("-q,--quiet", line.quiet, "No progress, no summary");
    app.add_option("--gz-level", line.outputs.gzLevel, "Compression, 0 (none) to 9")
        ->check(CLI::Range(0, 9));
    app.add_option("--seed", line.seed, "Instead of the scenario's seed")
        ->check(CLI::Range(0, 2147483647));
}

/// What the section [traffic] names.
std::vector<vdamf::NamedInput> trafficInputs(const vdamf::IniDocument& document)
{
    std::vector<vdamf::NamedInput> inputs;
    const vdamf::IniSection* const traffic = document.find("traffic");
    if (traffic == nullptr) return inputs;
    for (const vdamf::IniEntry& entry : traffic->entries)
    {
        const std::filesystem::path path = document.fileOf("traffic", entry.key, entry.value);
        if (entry.key == "table") inputs.push_back({path, "the traffic's table"});
        if (entry.key != "argoverse_log") continue;
        for (const char* file : {"annotations.csv", "city_SE3_egovehicle.csv"})
            inputs.push_back({path / file, "the traffic's log"});
    }
    return inputs;
}

/// Throws std::runtime_error where an output would be written over an input or another output.
void checkPaths(const CommandLine& line)
{
    vdamf::IniDocument document = vdamf::IniDocument::load(line.scenario);
    for (const std::string& assignment : line.set) document.set(assignment);
    std::vector<vdamf::NamedInput> inputs = trafficInputs(document);
    inputs.push_back({line.scenario, "the scenario"});
    std::vector<std::filesystem::path> outputs{line.outputs.rawlog};
    if (!line.outputs.truth.empty()) outputs.push_back(line.outputs.truth);
    vdamf::checkOutputPaths(outputs, inputs);
}

vdamf::Scenario scenarioOf(const CommandLine& line)
{
    vdamf::IniDocument document = vdamf::IniDocument::load(line.scenario);
    for (const std::string& assignment : line.set) document.set(assignment);
    vdamf::Scenario scenario = vdamf::readScenario(document);
    for (const vdamf::SimulatedSensor& sensor : scenario.sensors)
        vdamf::checkSensorLabel(sensor.label,
                                line.scenario.string() + ": [sensor " + sensor.label + "]");
    if (line.seed) scenario.run.seed = *line.seed;
    return scenario;
}

void showProgress(int done, int all)
{
    std::fprintf(stderr, "\rframe %d of %d%s", done, all, done == all ? "\n" : "");
}

void summarise(const vdamf::Scenario& scenario, const CommandLine& line,
               const vdamf::SimulationTotals& totals, double seconds)
{
    std::size_t vehicles = 0;
    for (const auto& object : scenario.scene.objects)
    {
        vehicles += vdamf::isVehicle(object.objectClass) ? 1 : 0;
    }
    const bool isPiped =
        vdamf::isStandardOutput(line.outputs.rawlog) || vdamf::isStandardOutput(line.outputs.truth);
    std::FILE* const to = isPiped ? stderr : stdout;
    const int frames = scenario.frames();
    std::fprintf(to, "%s\n", line.outputs.rawlog.string().c_str());
    std::fprintf(to, "  frames      %d (%g s at %g Hz)\n", frames, scenario.run.duration,
                 scenario.frameRate());
    std::fprintf(to, "  scans       %zu of %zu sensors\n", totals.scans, scenario.sensors.size());
    std::fprintf(to, "  returns     %zu a frame\n",
                 totals.returns / static_cast<std::size_t>(frames));
    std::fprintf(to, "  poses       %zu\n", totals.poses);
    std::fprintf(to, "  objects     %zu, of which %zu vehicles\n", scenario.scene.objects.size(),
                 vehicles);
    if (std::filesystem::is_regular_file(line.outputs.rawlog))  // it may be a device
    {
        std::fprintf(to, "  size        %.1f MB\n",
                     static_cast<double>(std::filesystem::file_size(line.outputs.rawlog)) / 1e6);
    }
    std::fprintf(to, "  time taken  %.1f s (%.1f frames/s)\n", seconds, frames / seconds);
}

int run(const CommandLine& line, const vdamf::Scenario& scenario)
{
    const std::atomic<bool>& interrupted = vdamf::catchSignals();
    const bool progress = !line.quiet && vdamf::isTerminal();
    const auto goOn = [&](int done, int all)
    {
        if (progress) showProgress(done, all);
        return !interrupted;
    };
    const auto begin = std::chrono::steady_clock::now();
    const vdamf::SimulationTotals totals = vdamf::runSimulation(scenario, line.outputs, goOn);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    if (!line.quiet) summarise(scenario, line, totals, taken.count());
    return vdamf::kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    CommandLine line;
    vdamf::Scenario scenario;
    const auto prepare = [&]
    {
        if (line.overwrite) line.outputs.existing = vdamf::OutputFile::Existing::Overwrite;
        checkPaths(line);
        scenario = scenarioOf(line);
        for (const std::string& warning : scenario.warnings)
            std::fprintf(stderr, "%s\n", warning.c_str());
    };
    return vdamf::runProgram(
        argc, argv,
        {"vdamf-simulate",
         "Simulates LADARs on a driving platform: a rawlog with scans and poses, and the truth of "
         "all road users.",
         "Example:\n  vdamf-simulate datasets/street/scenario.ini -o street.rawlog "
         "--truth truth.csv",
         [&](CLI::App& app) { declare(app, line); }, prepare, [&] { return run(line, scenario); }});
}
