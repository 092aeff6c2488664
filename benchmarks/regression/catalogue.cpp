// SPDX-License-Identifier: BSD-3-Clause
#include "regression/catalogue.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "vdamf/files/ini.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

// Few, short, and unlike each other.
const std::set<std::string> kFast = {
    "constant_curvature", "crossing_occlusion", "lane_change", "parked_row",
    "roundabout",         "stop_and_reverse",   "street"};

std::vector<fs::path> sortedEntries(const fs::path& folder)
{
    std::error_code error;
    std::vector<fs::path> entries;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        entries.push_back(entry.path());
    if (error) throw std::runtime_error(folder.string() + ": " + error.message());
    std::sort(entries.begin(), entries.end());
    return entries;
}

// Of several sensors the first one is tracked on: the truth holds for the times of its scans.
std::vector<std::string> trackArguments(const fs::path& scenario)
{
    const std::string prefix = "sensor ";
    const IniDocument document = IniDocument::load(scenario);
    for (const IniSection& section : document.sections())
        if (section.name.rfind(prefix, 0) == 0)
            return {"--set", "scan.label=" + section.name.substr(prefix.size())};
    return {};
}

RegressionScenario simulated(const std::string& name, const fs::path& file)
{
    RegressionScenario scenario;
    scenario.name = name;
    scenario.make = {"vdamf-simulate", file.string(), "-q"};
    scenario.track = trackArguments(file);
    scenario.score = {"--min-points", "20", "--max-range-m", "60"};
    scenario.fast = kFast.count(name) > 0;
    return scenario;
}

RegressionScenario kittiDrive(const fs::path& drive, const std::string& day)
{
    const std::string folder = drive.filename().string();
    const std::string number = folder.substr(folder.find("_drive_") + 7, 4);
    RegressionScenario scenario;
    scenario.name = "kitti_" + day.substr(day.find('_') + 1) + "_" + number;
    scenario.make = {"vdamf-import", "kitti-raw", drive.string()};
    scenario.score = {"--min-points", "20", "--max-range-m", "60", "--region-fov-deg", "80"};
    return scenario;
}

std::vector<RegressionScenario> kittiDrives(const fs::path& data)
{
    std::vector<RegressionScenario> all;
    for (const fs::path& day : sortedEntries(data))
    {
        if (!fs::is_regular_file(day / "calib_imu_to_velo.txt")) continue;
        for (const fs::path& drive : sortedEntries(day))
        {
            const bool isLabelled = fs::is_regular_file(drive / "tracklet_labels.xml");
            if (isLabelled && drive.string().find("_drive_") != std::string::npos)
                all.push_back(kittiDrive(drive, day.filename().string()));
        }
    }
    return all;
}

std::vector<RegressionScenario> argoverseLogs(const fs::path& scenario, const fs::path& data)
{
    std::vector<RegressionScenario> all;
    if (!fs::is_directory(data / "av2_samples")) return all;
    for (const fs::path& log : sortedEntries(data / "av2_samples"))
    {
        if (!fs::is_regular_file(log / "annotations.csv")) continue;
        all.push_back(simulated("argoverse_" + log.filename().string(), scenario));
        all.back().make.insert(all.back().make.end(),
                               {"--set", "traffic.argoverse_log=" + log.string()});
    }
    return all;
}

void addRecordings(Catalogue& catalogue, const fs::path& argoverse, const fs::path& data)
{
    std::vector<RegressionScenario> drives;
    std::vector<RegressionScenario> logs;
    if (!data.empty())
    {
        drives = kittiDrives(data);
        logs = argoverseLogs(argoverse, data);
    }
    if (drives.empty())
        catalogue.notes.emplace_back(
            "no KITTI drives: --data names a folder with <day>/<day>_drive_NNNN_sync and their "
            "tracklet_labels.xml");
    if (logs.empty())
        catalogue.notes.emplace_back(
            "no logs of Argoverse 2: --data names a folder with av2_samples/<log>/annotations.csv");
    for (const auto& more : {drives, logs})
        catalogue.scenarios.insert(catalogue.scenarios.end(), more.begin(), more.end());
}
}  // namespace

Catalogue catalogueOf(const fs::path& datasets, const fs::path& data)
{
    Catalogue catalogue;
    catalogue.scenarios.push_back(simulated("street", datasets / "street" / "scenario.ini"));
    const fs::path argoverse = datasets / "scenarios" / "argoverse.ini";
    for (const fs::path& file : sortedEntries(datasets / "scenarios"))
    {
        if (file.extension() == ".ini" && file != argoverse)
            catalogue.scenarios.push_back(simulated(file.stem().string(), file));
    }
    addRecordings(catalogue, argoverse, data);
    return catalogue;
}

std::vector<RegressionScenario> chosenFrom(const Catalogue& catalogue,
                                           const std::vector<std::string>& names, bool fastOnly)
{
    std::vector<RegressionScenario> chosen;
    std::set<std::string> missing(names.begin(), names.end());
    std::string list;
    for (const RegressionScenario& scenario : catalogue.scenarios)
    {
        const bool isNamed = names.empty() || missing.erase(scenario.name) > 0;
        if (isNamed && (scenario.fast || !fastOnly)) chosen.push_back(scenario);
        list += " " + scenario.name;
    }
    if (!missing.empty())
        throw std::invalid_argument("--only " + *missing.begin() + ": unknown; there are" + list);
    return chosen;
}

}  // namespace vdamf
