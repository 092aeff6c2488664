// SPDX-License-Identifier: BSD-3-Clause
// KITTI's labels as truth in the world frame.
#pragma once

#include <cstddef>
#include <vector>

#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/kitti_drive.h"
#include "vdamf/rawlog/kitti_tracklets.h"

namespace vdamf
{
/// One labelled box.
struct KittiLabel
{
    std::size_t frame = 0;
    KittiTrackletPose inVelodyne;
    TruthRow truth;  ///< `points` not yet counted
};

/// Labels by rising frame, then tracklet; object_id is the tracklet's index. A box is brought to
/// the world with the trajectory's pose at the time of its scan; `sensor` is the velodyne's
/// position and the vehicle's heading in that pose; the speed is the slope of the box's world
/// positions over up to three frames on either side, along its heading. Frames where the trajectory
/// has no pose have no labels.
std::vector<KittiLabel> kittiLabels(const KittiDrive& drive,
                                    const std::vector<KittiTracklet>& tracklets,
                                    const InsTrajectory& trajectory);

/// Points of a scan (velodyne frame) inside the box as labelled.
int pointsInside(const KittiLabel& label, const PointCloud& scan);

}  // namespace vdamf
