// SPDX-License-Identifier: BSD-3-Clause
// One reading of a rawlog from its first to its last entry, and what it writes.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "frame_maker.h"
#include "pending_entries.h"
#include "track_outputs.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
/// Opens the input and the outputs of a job, which outlives it.
class TrackingRun
{
public:
    TrackingRun(const TrackRawlogJob& job, FrameListener listener);

    /// Frames of all scans to come, as another reading of the same input found them: they are not
    /// tracked again. `summary`: of that reading.
    void tell(std::vector<FrameResult> tracked, const TrackRawlogSummary& summary);

    TrackRawlogSummary run(const std::atomic<bool>& stop);

    /// Leaves nothing of the outputs.
    void discard() { outputs_.discard(); }

private:
    void observeStages();
    bool prepareFirst();
    void take(PendingScan& scan);
    void countLatePoses(double forgotten);
    void track(PendingScan& scan, const std::optional<VehiclePose>& pose,
               const std::vector<PendingScan*>& partners);
    FrameResult resultOf(const LadarFrame& frame);
    std::optional<LadarFrame> frameOf(const PendingScan& scan,
                                      const std::optional<VehiclePose>& pose,
                                      const std::vector<PendingScan*>& partners);
    void account(const FrameResult& result);
    void account(const PlaneMotion& alignment, const Eigen::Vector2d& vehicle);
    void copyFirst();
    void writeHead();
    void finishSummary(bool interrupted);
    void checkUsable();

    const TrackRawlogJob& job_;
    FrameListener listener_;
    RawlogReader reader_;
    InsTrajectory ins_;
    PendingEntries pending_;
    TrackRawlogSummary summary_;
    FrameMaker frames_;
    Tracker tracker_;
    TrackOutputs outputs_;
    NisCollector nis_;
    std::optional<std::vector<FrameResult>> told_;  // in hindsight
    std::set<std::uint64_t> confirmed_;             // that live
    std::vector<double> skipped_;                   // times of scans without a pose, s (UNIX)
    std::uint64_t scansMet_ = 0;                    // before the range and in it
    std::optional<double> firstScanTime_;
    std::optional<double> firstEntryTime_;
    bool finished_ = false;
    const Stage* stage_ = nullptr;
    Stage current_ = Stage::Ground;
    std::chrono::steady_clock::time_point stageStart_;
};

}  // namespace vdamf
