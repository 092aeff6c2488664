// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include "vdamf/experiments/digest.h"
#include "vdamf/experiments/optimise.h"
#include "vdamf/experiments/setting_configuration.h"
#include "vdamf/experiments/sweep.h"

namespace vdamf
{
namespace
{
[[noreturn]] void fail(const SweepFile& file, const std::string& what)
{
    throw std::runtime_error(file.path.string() + ": " + what);
}

double plannedSettings(const SweepFile& file)
{
    if (file.sweep.plan != PlanKind::Grid) return file.sweep.count;
    const double count = countOfSettings(file.keys);
    // Without a step there is no grid; gridSettings() says which key.
    return std::isfinite(count) ? count : 0.0;
}

void checkSize(const PreparedSweep& sweep)
{
    const double settings = plannedSettings(sweep.file);
    const double runs = settings * static_cast<double>(sweep.recordings.size());
    if (runs <= sweep.file.sweep.maxRuns) return;
    const auto whole = [](double number) { return std::to_string(std::llround(number)); };
    fail(sweep.file, "the plan comes to " + whole(runs) + " runs (" + whole(settings) +
                         " settings, " + std::to_string(sweep.recordings.size()) +
                         " recordings), more than max_runs = " +
                         std::to_string(sweep.file.sweep.maxRuns) + "; vary less, or raise it");
}

std::vector<SweepSetting> settingsOf(const SweepFile& file)
{
    const auto count = static_cast<std::size_t>(file.sweep.count);
    try
    {
        switch (file.sweep.plan)
        {
            case PlanKind::Grid:
                return gridSettings(file.keys);
            case PlanKind::Random:
                return randomSettings(file.keys, count,
                                      static_cast<std::uint64_t>(file.sweep.seed));
            case PlanKind::Optimise:
                checkSearchable(file.keys, file.sweep.optimiser);
                return {};
        }
    }
    catch (const std::runtime_error& error)
    {
        fail(file, error.what());
    }
    return {};
}
}  // namespace

PreparedSweep prepareSweep(const std::filesystem::path& path)
{
    const SweepFile file = readSweepFile(path);
    PreparedSweep sweep{file, baseDocument(file), {}, {}, {}, {}, 0};
    checkKeys(file, sweep.base);
    sweep.recordings = findRecordings(file);
    checkSize(sweep);
    sweep.settings = settingsOf(file);
    for (const SweepSetting& setting : sweep.settings) checkSetting(file, sweep.base, setting);
    sweep.runs = static_cast<std::size_t>(plannedSettings(file)) * sweep.recordings.size();
    for (const SweepRecording& recording : sweep.recordings)
    {
        sweep.rawlogDigests.push_back(digestOfFile(recording.rawlog));
        sweep.truthDigests.push_back(digestOfFile(recording.truth));
    }
    return sweep;
}

}  // namespace vdamf
