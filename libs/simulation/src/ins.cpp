// SPDX-License-Identifier: BSD-3-Clause
// The INS of the platform.
#include "vdamf/simulation/ins.h"

#include <cmath>

namespace vdamf
{
InsSimulator::InsSimulator(const Scenario& scenario)
    : scenario_(scenario),
      random_(static_cast<std::uint64_t>(scenario.run.seed), streamIndex(kInsStream, 0))
{
}

double InsSimulator::nextTime() const
{
    return static_cast<double>(index_) / scenario_.run.insRate;
}

/// b <- a b + sqrt(1 - a^2) sigma n with a = exp(-dt / T).
void InsSimulator::drift()
{
    const InsErrorOptions& errors = scenario_.ins;
    const double kept = std::exp(-1.0 / (scenario_.run.insRate * errors.biasTime));
    const double fresh = std::sqrt(1.0 - kept * kept);
    for (int axis = 0; axis < 4; ++axis)
    {
        const double sigma = axis < 3 ? errors.positionBias : errors.headingBias;
        bias_[axis] = kept * bias_[axis] + fresh * sigma * random_.gaussian();
    }
}

bool InsSimulator::isLost()
{
    const InsErrorOptions& errors = scenario_.ins;
    const double inPeriod = std::fmod(nextTime(), errors.gapEvery);
    const bool isInGap = inPeriod > errors.gapEvery - errors.gapLength;
    const bool isDropped = random_.uniform() < errors.lossShare;
    return isInGap || isDropped;
}

InsSample InsSimulator::next()
{
    const InsErrorOptions& errors = scenario_.ins;
    InsSample sample;
    sample.sceneTime = nextTime();
    sample.pose = platformPoseAt(scenario_.scene, sample.sceneTime);
    sample.positionSigma = std::hypot(errors.positionNoise, errors.positionBias);
    sample.headingSigma = std::hypot(errors.headingNoise, errors.headingBias);
    sample.tiltSigma = errors.tiltNoise;
    if (index_ > 0)
    {
        drift();
        sample.isLost = isLost();
        for (int axis = 0; axis < 3; ++axis)
        {
            sample.pose.position[axis] += bias_[axis] + errors.positionNoise * random_.gaussian();
        }
        sample.pose.heading += bias_[3] + errors.headingNoise * random_.gaussian();
        sample.pose.pitch += errors.tiltNoise * random_.gaussian();
        sample.pose.roll += errors.tiltNoise * random_.gaussian();
    }
    ++index_;
    return sample;
}

}  // namespace vdamf
