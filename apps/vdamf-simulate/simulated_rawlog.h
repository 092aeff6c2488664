// SPDX-License-Identifier: BSD-3-Clause
// The rawlog of a simulated drive, in either format.
#pragma once

#include <mrpt/obs/CSensoryFrame.h>

#include "pose_sources.h"
#include "scan_classes.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf
{
/// Takes poses and scans by rising time. Single observations; or pairs of a collection of actions
/// and a sensory frame: with poses in actions a pair begins at each pose, else one ends at each
/// scan.
class SimulatedRawlog
{
public:
    SimulatedRawlog(const Scenario& scenario, const std::filesystem::path& path,
                    const RawlogWriter::Options& options)
        : scenario_(scenario), rawlog_(path, options), poses_(scenario)
    {
    }

    void add(const InsSample& sample);
    void add(const SimulatedScan& scan);
    void commit();

private:
    void add(const mrpt::obs::CObservation::Ptr& observation);
    void endPair();

    const Scenario& scenario_;
    RawlogWriter rawlog_;
    PoseRecorder poses_;
    mrpt::obs::CActionCollection actions_;
    mrpt::obs::CSensoryFrame frame_;
};

}  // namespace vdamf
