// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/configuration.h"

#include <filesystem>

#include "discriminator_file.h"
#include "vdamf/files/numbers.h"
#include "vdamf/rawlog/filter_file.h"

namespace vdamf
{
namespace
{
// Limits whose ranges touch.
void checkLimits(IniReader& reader, const TrackerOptions& tracker)
{
    const auto below = [&reader](const std::string& section, double low, const std::string& lowKey,
                                 double high, const std::string& highKey, bool mayBeEqual = false)
    {
        reader.require(low < high || (mayBeEqual && low == high),
                       section + "." + lowKey + " = " + toText(low) + " must " +
                           (mayBeEqual ? "not be above " : "be below ") + section + "." + highKey +
                           " = " + toText(high),
                       {{section, lowKey}, {section, highKey}});
    };
    const GroundOptions& ground = tracker.ground;
    below("ground", ground.minRange, "min_range_m", ground.maxRange, "max_range_m");
    below("ground", ground.minHeight, "min_height_m", ground.maxHeight, "max_height_m");
    below("ground", ground.minSensorHeight, "min_sensor_height_m", ground.maxSensorHeight,
          "max_sensor_height_m");
    below("clustering", tracker.clustering.gap, "gap_m", tracker.clustering.maxGap, "max_gap_m",
          true);
}

std::string absoluteName(const IniDocument& document, const char* section, const char* key,
                         const std::string& name)
{
    if (name.empty()) return name;
    const std::filesystem::path beside = document.fileOf(section, key, name);
    const std::filesystem::path path =
        std::filesystem::absolute(std::filesystem::exists(beside) ? beside.string() : name);
    // By the disk: "link/.." is the folder above the one that the link leads to.
    return (std::filesystem::weakly_canonical(path.parent_path()) / path.filename()).string();
}

// The configuration names the same files from any folder.
Configuration withAbsoluteFiles(Configuration c, const IniDocument& document)
{
    DiscriminatorOptions& discriminator = c.tracker.discriminator;
    if (!discriminator.isOff())
        discriminator.model = absoluteName(document, "discriminator", "model", discriminator.model);
    std::string& filters = c.tracker.measurement.filterFile;
    filters = absoluteName(document, "measurement", "filter_file", filters);
    return c;
}
}  // namespace

Configuration readSettings(const IniDocument& document)
{
    Configuration c;
    IniReader reader(document);
    reader.read("scan", c.scan);
    reader.read("ins", c.ins);
    reader.read("ground", c.tracker.ground);
    reader.read("clustering", c.tracker.clustering);
    reader.read("association", c.tracker.association);
    reader.read("measurement", c.tracker.measurement);
    reader.read("visibility", c.tracker.visibility);
    reader.read("motion", c.tracker.motion);
    reader.read("alignment", c.tracker.alignment);
    reader.read("lifecycle", c.tracker.lifecycle);
    reader.read("tracker", c.tracker.execution);
    reader.read("discriminator", c.tracker.discriminator);
    reader.read("output", c.output);
    checkLimits(reader, c.tracker);
    reader.finish();
    return c;
}

Configuration readConfiguration(const IniDocument& document)
{
    Configuration c = withAbsoluteFiles(readSettings(document), document);
    c.tracker.discriminator.loaded = discriminatorFromFile(c.tracker.discriminator);
    c.tracker.measurement = withFilterFromFile(c.tracker.measurement);
    return c;
}

std::vector<NamedInput> filesNamedBy(const Configuration& c)
{
    const DiscriminatorOptions& discriminator = c.tracker.discriminator;
    return {{discriminator.isOff() ? "" : discriminator.model, "discriminator.model"},
            {c.tracker.measurement.filterFile, "measurement.filter_file"}};
}

Configuration loadConfiguration(const std::filesystem::path& file,
                                const std::vector<std::string>& assignments)
{
    IniDocument document =
        file.empty() ? IniDocument::parse("", "built-in configuration") : IniDocument::load(file);
    for (const std::string& assignment : assignments) document.set(assignment);
    return readConfiguration(document);
}

std::string toIni(const Configuration& c)
{
    IniWriter writer;
    writer.write("scan", "Observations that are tracked on", c.scan);
    writer.write("ins", "Pose of the vehicle", c.ins);
    writer.write("ground", "Ground removal", c.tracker.ground);
    writer.write("clustering", "Hits above ground to clusters, each inside at most one target",
                 c.tracker.clustering);
    writer.write("association", "Auction of clusters to tracks", c.tracker.association);
    writer.write("measurement", "Matched filter: pose and size of a target from its hits",
                 c.tracker.measurement);
    writer.write("visibility", "Partly seen vehicles (paper, 4.5) and the memory of sizes",
                 c.tracker.visibility);
    writer.write("motion", "Variable-axis steering model", c.tracker.motion);
    writer.write("alignment", "Errors of the poses of the vehicle", c.tracker.alignment);
    writer.write("lifecycle", "Start, confirmation and end of tracks", c.tracker.lifecycle);
    writer.write("tracker", "How the tracker runs", c.tracker.execution);
    writer.write("discriminator", "Vehicle or not (paper, 5)", c.tracker.discriminator);
    writer.write("output", "Annotated rawlog", c.output);
    return writer.text();
}

}  // namespace vdamf
