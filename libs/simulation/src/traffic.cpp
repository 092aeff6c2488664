// SPDX-License-Identifier: BSD-3-Clause
#include "traffic.h"

#include <algorithm>
#include <stdexcept>

#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kFewestLabels = 5;

ObjectClass fittingClass(const LabelledObject& object)
{
    const BodySize least = leastSizeOf(object.objectClass);
    const bool fits = object.size.length >= least.length && object.size.width >= least.width &&
                      object.size.height >= least.height;
    return fits ? object.objectClass : ObjectClass::Box;
}

SceneObject sceneObject(const LabelledObject& labelled, double smoothing)
{
    SceneObject object;
    object.name = labelled.name;
    object.objectClass = fittingClass(labelled);
    object.size = labelled.size;
    object.rearAxleOffset = rearAxleOffsetOf(object.objectClass, object.size.length);
    object.body = makeBody(object.objectClass, object.size);
    object.trajectory = smoothed(labelled.poses, object.rearAxleOffset, smoothing);
    object.appears = labelled.poses.front().time;
    object.vanishes = labelled.poses.back().time;
    return object;
}

/// Adds how many there are, and the names of the first.
void warn(std::vector<std::string>& warnings, const std::vector<std::string>& names,
          std::size_t all, const std::string& what)
{
    constexpr std::size_t kNamed = 5;
    if (names.empty()) return;
    std::string text =
        std::to_string(names.size()) + " of its " + std::to_string(all) + " objects " + what;
    for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i)
        text += (i == 0 ? ": " : ", ") + inQuotes(names[i]);
    warnings.push_back(text + (names.size() > kNamed ? ", ..." : ""));
}
}  // namespace

TrafficObjects trafficOf(const Recording& recording, double smoothing)
{
    TrafficObjects traffic;
    std::vector<std::string> rare;
    std::vector<std::string> small;
    for (const LabelledObject& labelled : recording.objects)
    {
        if (labelled.poses.size() < kFewestLabels)
        {
            rare.push_back(labelled.name);
            continue;
        }
        if (fittingClass(labelled) != labelled.objectClass) small.push_back(labelled.name);
        try
        {
            traffic.objects.push_back(sceneObject(labelled, smoothing));
        }
        catch (const std::runtime_error& error)
        {
            throw std::runtime_error("object " + labelled.name + ": " + error.what());
        }
    }
    const std::size_t all = recording.objects.size();
    warn(traffic.warnings, rare, all,
         "have fewer than " + std::to_string(kFewestLabels) + " labels and are left out");
    warn(traffic.warnings, small, all,
         "are smaller than their class can be: boxes in the scene, not in the truth");
    return traffic;
}

}  // namespace vdamf
