// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
Configuration readConfiguration(const IniDocument& document)
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
    reader.read("lifecycle", c.tracker.lifecycle);
    reader.read("output", c.output);
    reader.finish();
    return c;
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
    writer.write("lifecycle", "Start, confirmation and end of tracks", c.tracker.lifecycle);
    writer.write("output", "Annotated rawlog", c.output);
    return writer.text();
}

}  // namespace vdamf
