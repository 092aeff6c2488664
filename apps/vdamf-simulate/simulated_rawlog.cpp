// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_rawlog.h"

namespace vdamf
{
void SimulatedRawlog::add(const InsSample& sample)
{
    if (scenario_.recording.poseSource == PoseSource::Actions)
    {
        endPair();
        actions_ = poses_.movement(sample);
    }
    for (const auto& observation : poses_.observations(sample)) add(observation);
}

void SimulatedRawlog::add(const SimulatedScan& scan)
{
    add(scanObservation(scenario_, scan));
    const bool endsPair = scenario_.recording.poseSource != PoseSource::Actions;
    if (scenario_.recording.sensoryFrames && endsPair) endPair();
}

void SimulatedRawlog::add(const mrpt::obs::CObservation::Ptr& observation)
{
    if (scenario_.recording.sensoryFrames)
        frame_.insert(observation);
    else
        rawlog_.write(*observation);
}

void SimulatedRawlog::endPair()
{
    if (actions_.size() == 0 && frame_.size() == 0) return;
    rawlog_.write(actions_);
    rawlog_.write(frame_);
    actions_.clear();
    frame_.clear();
}

void SimulatedRawlog::commit()
{
    endPair();
    rawlog_.commit();
}

}  // namespace vdamf
