// SPDX-License-Identifier: BSD-3-Clause
#include "traffic.h"

#include <stdexcept>

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
}  // namespace

std::vector<SceneObject> sceneObjects(const Recording& recording, double smoothing)
{
    std::vector<SceneObject> objects;
    for (const LabelledObject& labelled : recording.objects)
    {
        if (labelled.poses.size() < kFewestLabels) continue;
        try
        {
            objects.push_back(sceneObject(labelled, smoothing));
        }
        catch (const std::runtime_error& error)
        {
            throw std::runtime_error("object " + labelled.name + ": " + error.what());
        }
    }
    return objects;
}

}  // namespace vdamf
