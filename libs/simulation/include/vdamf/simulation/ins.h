// SPDX-License-Identifier: BSD-3-Clause
// The INS of the platform: its poses, with noise, drift and gaps.
#pragma once

#include <cstdint>
#include <optional>

#include "vdamf/simulation/scenario.h"

namespace vdamf
{
struct InsSample
{
    double sceneTime = 0.0;      ///< s
    GroundPose pose;             ///< of the vehicle frame in the scene, as the INS has it
    double positionSigma = 0.0;  ///< of the errors, m
    double headingSigma = 0.0;   ///< rad
    double tiltSigma = 0.0;      ///< rad
    bool isLost = false;         ///< not in the recording
};

/// The samples one after another, from scene time 0. The first one is exact and never lost: it is
/// the origin of the recording's world frame, in which the truth is given. From then on
///  - white noise is added to each sample,
///  - a bias of each axis is a first-order Gauss-Markov process that starts at 0.
class InsSimulator
{
public:
    /// `scenario` must outlive the simulator.
    explicit InsSimulator(const Scenario& scenario);

    double nextTime() const;  ///< scene time, s
    InsSample next();

private:
    void drift();
    bool isLost();

    const Scenario& scenario_;
    RandomStream random_;
    std::int64_t index_ = 0;
    Eigen::Vector4d bias_ = Eigen::Vector4d::Zero();  ///< x, y, z in m; heading in rad
};

}  // namespace vdamf
