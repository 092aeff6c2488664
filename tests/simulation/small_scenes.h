// SPDX-License-Identifier: BSD-3-Clause
// Parts of small scenes for tests of the ray caster.
#pragma once

#include "vdamf/simulation/ray_caster.h"

namespace vdamf
{
inline SceneObject objectAt(ObjectClass objectClass, const OrientedBox& pose, BodySize size,
                            double speed = 0.0)
{
    SceneObject object;
    object.objectClass = objectClass;
    object.size = size;
    object.body = makeBody(objectClass, size);
    object.rearAxleOffset = isVehicle(objectClass) ? 0.28 * size.length : 0.0;
    object.trajectory = Trajectory(startOf(pose, object.rearAxleOffset, speed), {});
    return object;
}

/// An ideal HDL-32E, 2 m above the ground.
inline LadarMount idealMount()
{
    LadarMount mount;
    mount.ladar = ladarOf(LadarModel::HDL32E);
    mount.ladar.rangeNoise = 0.0;
    mount.position = {0.5, 0.2, 2.0};
    mount.instantaneous = true;
    mount.halfLossStrength = 0.0;
    mount.glassLoss = 0.0;
    return mount;
}

inline std::vector<LadarFiring> cast(const Scene& scene, const LadarMount& mount, double time = 0.0)
{
    RandomStream random(3, 0);
    return castScan(scene, mount, time, random);
}

}  // namespace vdamf
