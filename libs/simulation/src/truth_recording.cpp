// SPDX-License-Identifier: BSD-3-Clause
// A truth table as a recording.
#include <map>
#include <stdexcept>
#include <string>

#include "recording_span.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/simulation/recording.h"

namespace vdamf
{
namespace
{
ObjectClass classOf(const std::string& name)
{
    static const std::map<std::string, ObjectClass> kClasses{
        {"Car", ObjectClass::Car},        {"Van", ObjectClass::Van},
        {"Truck", ObjectClass::Truck},    {"Tram", ObjectClass::Tram},
        {"Bus", ObjectClass::Bus},        {"Pedestrian", ObjectClass::Pedestrian},
        {"Cyclist", ObjectClass::Bicycle}};
    const auto found = kClasses.find(name);
    return found == kClasses.end() ? ObjectClass::Box : found->second;
}
}  // namespace

Recording readTruthTable(const std::filesystem::path& path)
{
    Recording recording;
    std::map<std::string, std::size_t> indices;
    double begin = 0.0;
    for (const TruthRow& row : readTruth(path))
    {
        if (recording.objects.empty()) begin = row.time;
        const std::string problem = spanProblem(row.time - begin);
        if (!problem.empty())
            throw std::runtime_error(path.string() + ": time_s " + toFixedText(row.time, 6) + ": " +
                                     problem);
        const auto [at, isNew] = indices.emplace(row.objectId, recording.objects.size());
        if (isNew)
        {
            const BodySize size{row.box.length, row.box.width, row.height};
            recording.objects.push_back({row.objectId, classOf(row.objectClass), size, {}});
        }
        const double time = row.time - begin;
        recording.objects[at->second].poses.push_back(
            {time, row.box.x, row.box.y, row.box.heading});
        const bool isNewTime = recording.platform.empty() || time > recording.platform.back().time;
        if (row.sensor && isNewTime)
        {
            recording.platform.push_back({time, row.sensor->x, row.sensor->y, row.sensor->heading});
        }
    }
    if (recording.objects.empty()) throw std::runtime_error(path.string() + ": holds no object");
    return recording;
}

}  // namespace vdamf
