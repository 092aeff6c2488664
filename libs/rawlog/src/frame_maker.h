// SPDX-License-Identifier: BSD-3-Clause
// Scans of a rawlog to frames for the tracker.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "pending_entries.h"
#include "vdamf/rawlog/track_rawlog.h"
#include "vdamf/rawlog/world_frame.h"

namespace vdamf
{
/// Counts in the run's summary what becomes of the scans.
class FrameMaker
{
public:
    /// `rawlog`: the file that the scans stand in.
    FrameMaker(const ScanOptions& options, const std::filesystem::path& rawlog,
               const InsTrajectory& ins, TrackRawlogSummary& summary)
        : options_(options), files_(rawlog), ins_(ins), summary_(summary)
    {
    }

    /// One frame of a scan and its partners, as far as they can be used; nothing where the first
    /// cannot.
    std::optional<LadarFrame> frameOf(const PendingScan& scan,
                                      const std::optional<VehiclePose>& pose,
                                      const std::vector<PendingScan*>& partners);

private:
    std::optional<LadarFrame> frameOf(const PendingScan& scan,
                                      const std::optional<VehiclePose>& pose);

    const ScanOptions& options_;
    ExternalFiles files_;
    const InsTrajectory& ins_;
    TrackRawlogSummary& summary_;
};

}  // namespace vdamf
