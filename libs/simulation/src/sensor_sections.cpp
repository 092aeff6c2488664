// SPDX-License-Identifier: BSD-3-Clause
// The sensors of a scenario file.
#include "sensor_sections.h"

#include <set>
#include <string_view>

#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr std::string_view kPrefix = "sensor ";

LadarMount mountOf(const RunOptions& run, const SensorOptions& sensor)
{
    LadarMount mount;
    mount.ladar = ladarOf(sensor.model);
    if (sensor.rangeNoise >= 0.0) mount.ladar.rangeNoise = sensor.rangeNoise;
    if (sensor.maxRange >= 0.0) mount.ladar.maxRange = sensor.maxRange;
    if (sensor.resolution > 0.0 && mount.ladar.isLineScanner())
    {
        mount.ladar.resolution = sensor.resolution;
    }
    mount.position = {sensor.x, sensor.y, sensor.z};
    mount.heading = sensor.heading;
    mount.pitch = sensor.pitch;
    mount.roll = sensor.roll;
    mount.rate = sensor.rate > 0.0 ? sensor.rate : run.rate;
    mount.fieldOfView = sensor.fieldOfView > 0.0 ? sensor.fieldOfView : mount.ladar.fieldOfView;
    mount.instantaneous = sensor.instantaneous;
    mount.halfLossStrength =
        sensor.halfLossStrength >= 0.0 ? sensor.halfLossStrength : mount.ladar.halfLossStrength;
    mount.glassLoss = sensor.glassLoss;
    return mount;
}

/// The key with the value that the document gives it.
std::string assignmentOf(const IniDocument& document, const std::string& section,
                         const std::string& key)
{
    const IniEntry* const entry = document.find(section, key);
    return section + "." + key + (entry == nullptr ? "" : " = " + inQuotes(entry->value));
}

void checkSensor(const IniDocument& document, IniReader& reader, const std::string& section,
                 const SimulatedSensor& sensor)
{
    const LadarModel model = sensor.options.model;
    const LadarMount& mount = sensor.mount;
    const SpinningLadar sheet = ladarOf(model);
    constexpr double kSpinningMinRate = 1.0;
    const double minRate = sheet.isLineScanner() ? 0.0 : kSpinningMinRate;
    const auto require = [&](bool condition, const std::string& key, const std::string& problem)
    {
        reader.require(condition, assignmentOf(document, section, key) + ": " + problem,
                       {{section, key}});
    };
    require(mount.rate >= minRate && mount.rate <= sheet.maxRate, "rate_hz",
            "the sensor scans at most " + toText(sheet.maxRate) + " times a second" +
                (minRate > 0.0 ? " and at least once" : ""));
    require(sensor.options.resolution == 0.0 || sheet.isLineScanner(), "resolution_deg",
            "only line scanners (LMS-291, LMS-511) have it; leave it out");
    require(!sheet.isLineScanner() || mount.fieldOfView <= sheet.fieldOfView + 1e-9,
            "field_of_view_deg",
            "the sensor has " + toText(sheet.fieldOfView * 180.0 / kPi) + " degrees at most");
    reader.require(mount.fieldOfView >= mount.ladar.resolution,
                   section + ".field_of_view_deg: is smaller than resolution_deg",
                   {{section, "field_of_view_deg"}, {section, "resolution_deg"}});
}
}  // namespace

std::vector<SimulatedSensor> readSensors(const IniDocument& document, IniReader& reader,
                                         const RunOptions& run)
{
    std::vector<std::string> sections;
    for (const IniSection& section : document.sections())
    {
        const bool isNamed = section.name.substr(0, kPrefix.size()) == kPrefix;
        if (isNamed || section.name == "sensor") sections.push_back(section.name);
    }
    if (sections.empty()) sections.emplace_back("sensor");

    std::vector<SimulatedSensor> sensors;
    std::set<std::string> labels{"ins"};
    for (const std::string& section : sections)
    {
        SimulatedSensor sensor;
        reader.read(section, sensor.options);
        sensor.mount = mountOf(run, sensor.options);
        sensor.label = sensor.mount.ladar.isLineScanner() ? "lms" : "velodyne";
        if (section != "sensor") sensor.label = section.substr(kPrefix.size());
        reader.require(labels.insert(sensor.label).second,
                       "[" + section + "]: the label '" + sensor.label +
                           "' is taken already; choose another name");
        reader.require(standsInIni(sensor.label),
                       "[" + section + "]: the name must be " + kIniText);
        checkSensor(document, reader, section, sensor);
        sensors.push_back(sensor);
    }
    reader.require(sensors.front().options.delay == 0.0,
                   assignmentOf(document, sections.front(), "delay_s") +
                       ": the first sensor's scans are the frames; delay the others",
                   {{sections.front(), "delay_s"}});
    return sensors;
}

}  // namespace vdamf
