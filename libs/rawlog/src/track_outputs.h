// SPDX-License-Identifier: BSD-3-Clause
// The files that a tracking run writes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "pending_entries.h"
#include "vdamf/rawlog/annotation.h"
#include "vdamf/rawlog/nis_report.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
/// The annotated rawlog, the table of tracks and that of their consistency, as far as the job asks
/// for them. Entries are held back until the head of the rawlog is known.
class TrackOutputs
{
public:
    explicit TrackOutputs(const TrackRawlogJob& job);

    /// The frame's rows, and the annotations that go behind its scan.
    void annotate(PendingScan& scan, const FrameResult& result);
    /// The entry's bytes and, right behind them, what its scans led to. Damaged bytes are left
    /// out: behind them stock tools would stop reading. So are the head and tail of a rawlog that
    /// stands as one object, which say how many entries it has.
    void copy(const PendingEntry& entry);

    bool hasHead() const { return !writer_ || headWritten_; }
    std::size_t heldBytes() const { return held_.size(); }
    /// Writes the head, and what was held back for it.
    void writeHead(const mrpt::obs::CObservationComment& head);

    void write(const NisReport& report);
    void commit();
    void discard();

private:
    void endMemberAt(double time);

    Annotator annotator_;
    std::optional<RawlogWriter> writer_;
    std::optional<OutputFile> tracks_;
    std::optional<OutputFile> nis_;
    std::string held_;
    double memberBegin_ = 0.0;  ///< s
    bool headWritten_ = false;
};

}  // namespace vdamf
