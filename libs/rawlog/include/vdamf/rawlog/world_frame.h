// SPDX-License-Identifier: BSD-3-Clause
// Section 2: LADAR data "transformed into fixed world coordinates" by the INS.
#pragma once

#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/scan.h"
#include "vdamf/tracking/types/plane_motion.h"

namespace vdamf
{
/// A scan in world axes, relative to an origin at the vehicle. `pose` is the vehicle's
/// at the scan's time; all hits are taken as seen then.
LadarFrame toLadarFrame(const Scan& scan, const VehiclePose& pose);

/// A frame whose hits were moved by where the vehicle was when each was seen.
struct DeskewedFrame
{
    LadarFrame frame;
    /// False where the INS gives no pose at the time of some hits (or that time is more than a
    /// second from the scan's): these are moved by the pose nearest to it, on the scan's side.
    bool posesCoverScan = true;
};

/// As above, but each hit is placed by the pose of the vehicle at its own time (within 0.05 ms),
/// so that standing things are where they are however fast the vehicle drives and turns. What
/// moves by itself is where it was at that time, which `frame.points.time` keeps (of both kinds of
/// frames; times more than a second from the scan's count as the scan's). `frame.time` and
/// `frame.sensor` stay those of the scan's time. Scans without times come out as above.
DeskewedFrame toLadarFrame(const Scan& scan, const VehiclePose& pose, const InsTrajectory& ins);

/// One frame of two sensors' scans: the hits of both; time, origin and sensor of the first.
/// Intensities are kept where both have them; times are relative to the first frame's time, and a
/// scan without times counts as seen at its own.
LadarFrame merged(LadarFrame first, const LadarFrame& second);

/// A frame in another world: hits and sensor moved; its origin stays.
LadarFrame movedBy(LadarFrame frame, const PlaneMotion& motion);

}  // namespace vdamf
