// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/configuration.h"

#include "discriminator_file.h"
#include "named_file.h"
#include "vdamf/files/numbers.h"
#include "vdamf/rawlog/filter_file.h"

namespace vdamf
{
namespace
{
// Limits whose ranges touch.
void checkLimits(IniReader& reader, const TrackerOptions& tracker)
{
    const auto below = [&reader](double low, const std::string& lowKey, double high,
                                 const std::string& highKey, bool mayBeEqual = false)
    {
        reader.require(low < high || (mayBeEqual && low == high),
                       lowKey + " = " + toText(low) + " must " +
                           (mayBeEqual ? "not be above " : "be below ") + highKey + " = " +
                           toText(high));
    };
    const GroundOptions& ground = tracker.ground;
    below(ground.minRange, "ground.min_range_m", ground.maxRange, "ground.max_range_m");
    below(ground.minHeight, "ground.min_height_m", ground.maxHeight, "ground.max_height_m");
    below(ground.minSensorHeight, "ground.min_sensor_height_m", ground.maxSensorHeight,
          "ground.max_sensor_height_m");
    below(tracker.clustering.gap, "clustering.gap_m", tracker.clustering.maxGap,
          "clustering.max_gap_m", true);
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
    Configuration c = readSettings(document);
    c.tracker.discriminator.loaded =
        discriminatorFromFile(c.tracker.discriminator, document.fileName());
    c.tracker.measurement = withFilterFromFile(c.tracker.measurement, document.fileName());
    return c;
}

std::vector<NamedInput> filesNamedBy(const Configuration& c,
                                     const std::filesystem::path& configurationFile)
{
    const DiscriminatorOptions& discriminator = c.tracker.discriminator;
    const std::string model = discriminator.isOff() ? "" : discriminator.model;
    return {{namedFile(model, configurationFile), "discriminator.model"},
            {namedFile(c.tracker.measurement.filterFile, configurationFile),
             "measurement.filter_file"}};
}

Configuration withAbsoluteFiles(Configuration c, const std::filesystem::path& configurationFile)
{
    std::string* const names[] = {&c.tracker.discriminator.model,
                                  &c.tracker.measurement.filterFile};
    const std::vector<NamedInput> files = filesNamedBy(c, configurationFile);
    for (std::size_t k = 0; k < files.size(); ++k)
        if (!files[k].path.empty())
            *names[k] = std::filesystem::absolute(files[k].path).lexically_normal().string();
    return c;
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
