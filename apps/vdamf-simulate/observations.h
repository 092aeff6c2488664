// SPDX-License-Identifier: BSD-3-Clause
// Simulated frames and poses as observations of MRPT.
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstddef>
#include <cstring>
#include <vector>

#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
inline VelodyneModel velodyneModel(LadarModel model)
{
    switch (model)
    {
        case LadarModel::VLP16:
            return VelodyneModel::VLP16;
        case LadarModel::HDL32E:
            return VelodyneModel::HDL32E;
        case LadarModel::HDL64E:
            return VelodyneModel::HDL64E;
    }
    return VelodyneModel::HDL32E;
}

inline std::vector<VelodyneFiring> packetFirings(const std::vector<LadarFiring>& firings)
{
    std::vector<VelodyneFiring> result;
    result.reserve(firings.size());
    for (const LadarFiring& firing : firings)
    {
        VelodyneFiring& packed = result.emplace_back();
        packed.azimuth = firing.azimuth;
        for (const LadarReturn& one : firing.returns)
        {
            packed.range.push_back(static_cast<float>(one.range));
            packed.intensity.push_back(static_cast<float>(one.intensity));
        }
    }
    return result;
}

/// Gives all packets the time of the first: in a world that stood still during the revolution,
/// all returns belong to its begin, and whoever moves them by their times must not.
inline void stopClock(mrpt::obs::CObservationVelodyneScan& scan)
{
    using Packet = mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket;
    // The stamp is private to the packet; it stands behind the blocks.
    constexpr std::size_t kStampOffset = sizeof(Packet::blocks);
    constexpr std::size_t kStampSize = 4;
    char stamp[kStampSize];
    for (std::size_t i = 0; i < scan.scan_packets.size(); ++i)
    {
        char* bytes = reinterpret_cast<char*>(&scan.scan_packets[i]) + kStampOffset;
        if (i == 0) std::memcpy(stamp, bytes, kStampSize);
        std::memcpy(bytes, stamp, kStampSize);
    }
}

/// The scan, label `velodyne`.
inline mrpt::obs::CObservationVelodyneScan scanObservation(const Scenario& scenario,
                                                           const SimulatedFrame& frame)
{
    const VelodyneModel model = velodyneModel(scenario.sensor.model);
    mrpt::obs::CObservationVelodyneScan scan =
        encodeVelodyne(model, frame.time, packetFirings(frame.firings));
    const Eigen::Vector3d& position = scenario.mount.position;
    scan.sensorLabel = "velodyne";
    scan.sensorPose = mrpt::poses::CPose3D(position.x(), position.y(), position.z(),
                                           scenario.mount.heading, 0.0, 0.0);
    scan.minRange = scenario.mount.ladar.minRange;
    scan.maxRange = scenario.mount.ladar.maxRange;
    if (scenario.mount.instantaneous) stopClock(scan);
    return scan;
}

/// The platform's pose in the scene at a scene time, label `ins`. It is exact; the covariance is
/// that of a good INS (2 cm, 0.1 degrees), because filters divide by it.
inline mrpt::obs::CObservationRobotPose poseObservation(const Scenario& scenario, double sceneTime)
{
    const MotionState state = scenario.scene.platform.at(sceneTime);
    mrpt::obs::CObservationRobotPose pose;
    pose.sensorLabel = "ins";
    pose.timestamp = mrpt::Clock::fromDouble(scenario.run.startTime + sceneTime);
    pose.pose.mean = mrpt::poses::CPose3D(state.x, state.y, 0.0, state.heading, 0.0, 0.0);
    pose.pose.cov.setZero();
    for (int i = 0; i < 6; ++i) pose.pose.cov(i, i) = i < 3 ? 4e-4 : 3e-6;
    return pose;
}

}  // namespace vdamf
