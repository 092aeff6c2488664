// SPDX-License-Identifier: BSD-3-Clause
// Poses of the simulated INS as observations or actions of MRPT, from the source asked for.
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>

#include <vector>

#include "vdamf/simulation/ins.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
/// By the scenario's pose_source:
///  - robot_pose: CObservationRobotPose `ins`. Its covariance is that of the INS' errors, and at
///    least that of a good INS (2 cm, 0.1 degrees), because filters divide by it;
///  - inspvas: CObservationGPS `ins` with an INSPVAS;
///  - gga: CObservationGPS `gps` with a GGA, antenna at the vehicle's origin; gga_imu: beside it a
///    CObservationIMU `imu` with yaw (0 east), pitch and roll;
///  - odometry: CObservationOdometry `wheels`;
///  - actions: none, see movement().
/// GPS positions are those of the scene's axes laid to 48.5 N, 9 E, 400 m at the first sample.
class PoseRecorder
{
public:
    explicit PoseRecorder(const Scenario& scenario) : scenario_(scenario) {}

    std::vector<mrpt::obs::CObservation::Ptr> observations(const InsSample& sample);
    /// The step from the sample of the call before (the first one: none) as a planar movement by
    /// odometry.
    mrpt::obs::CActionCollection movement(const InsSample& sample);

private:
    mrpt::Clock::time_point timeOf(const InsSample& sample) const;

    const Scenario& scenario_;
    std::optional<GroundPose> first_;
    std::optional<GroundPose> last_;
};

}  // namespace vdamf
