// SPDX-License-Identifier: BSD-3-Clause
#include "filter_sources.h"

#include <algorithm>
#include <stdexcept>

#include "vdamf/learning/clusters/simulated_clusters.h"

namespace vdamf
{
namespace
{
const std::string kSimulated = "simulated ";

SimulatedSource readSimulated(IniReader& reader, const std::string& section)
{
    SimulatedSource s;
    s.name = section.substr(kSimulated.size());
    reader.read(section, s.options);
    const std::vector<SimulatedKind> kinds = simulatedKinds();
    const bool isKnown =
        s.options.kind.empty() ||
        std::any_of(kinds.begin(), kinds.end(),
                    [&](const SimulatedKind& kind) { return kind.name == s.options.kind; });
    std::string names;
    for (const SimulatedKind& kind : kinds) names += (names.empty() ? "" : ", ") + kind.name;
    reader.require(isKnown,
                   "[" + section + "] kind = " + s.options.kind + ": expected one of " + names);
    return s;
}
}  // namespace

FilterSources readFilterSources(const IniDocument& document)
{
    IniReader reader(document);
    FilterSources sources;
    sources.recordings = readRecordings<FilterRecordingOptions>(reader, document);
    for (const IniSection& section : document.sections())
        if (section.name.rfind(kSimulated, 0) == 0)
            sources.simulated.push_back(readSimulated(reader, section.name));
    reader.finish();
    if (sources.recordings.empty() && sources.simulated.empty())
        throw std::runtime_error(
            document.fileName() +
            ": names nothing to learn from: expected sections [recording NAME] or [simulated "
            "NAME]");
    return sources;
}

}  // namespace vdamf
