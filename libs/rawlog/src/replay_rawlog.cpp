// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "first_labels.h"
#include "frame_maker.h"
#include "pending_entries.h"
#include "vdamf/rawlog/annotated_rawlog.h"

namespace vdamf
{
namespace
{
class Replay
{
public:
    Replay(const std::filesystem::path& path, const Annotations& annotations,
           const FrameListener& listener)
        : annotations_(annotations),
          listener_(listener),
          reader_(path),
          ins_(annotations.configuration.ins),
          pending_(reader_, ins_, annotations.configuration.scan),
          frames_(annotations.configuration.scan, path, ins_, counts_)
    {
    }

    ReplaySummary run(const std::atomic<bool>& stop)
    {
        while (!stop && pending_.prepareFirst())
        {
            for (PendingScan& scan : pending_.first().scans)
                while (!scan.done) take(*pending_.earliestScanUntil(scan.time));
            pending_.popFirst();
        }
        if (!pending_.readError().empty()) throw ReadError(pending_.readError());
        summary_.tablesUnused = annotations_.tables.size() - summary_.frames;
        summary_.interrupted = stop;
        return summary_;
    }

private:
    void take(PendingScan& scan)
    {
        scan.done = true;
        const std::vector<PendingScan*> partners = pending_.partnersOf(scan);
        for (PendingScan* partner : partners) partner->done = true;
        // As when it was tracked: the source of the poses is that for the first scan.
        const std::optional<VehiclePose> pose = ins_.at(scan.time);
        const auto table = annotations_.tables.find(scan.observation->timestamp);
        if (table != annotations_.tables.end()) handOn(scan, pose, partners, table->second);
        constexpr double kPosesKept = 10.0;  // s
        if (pose) ins_.forgetBefore(scan.time - kPosesKept);
    }

    void handOn(const PendingScan& scan, const std::optional<VehiclePose>& pose,
                const std::vector<PendingScan*>& partners, const std::vector<TrackReport>& tracks)
    {
        const std::optional<LadarFrame> frame = frames_.frameOf(scan, pose, partners);
        if (!frame) return;
        ++summary_.frames;
        ++counts_.frames;
        counts_.lastTime = frame->time;
        addLabel(summary_.labels, scan.observation->sensorLabel);
        for (const PendingScan* partner : partners)
            addLabel(summary_.labels, partner->observation->sensorLabel);
        FrameResult result;
        result.time = frame->time;
        result.tracks = tracks;
        result.points = frame->points.size();
        const auto alignment = annotations_.alignments.find(scan.observation->timestamp);
        if (alignment != annotations_.alignments.end()) result.alignment = alignment->second;
        listener_(result.alignment.isNone() ? *frame : movedBy(*frame, result.alignment), result,
                  reader_.progress());
    }

    const Annotations& annotations_;
    const FrameListener& listener_;
    RawlogReader reader_;
    InsTrajectory ins_;
    PendingEntries pending_;
    TrackRawlogSummary counts_;
    FrameMaker frames_;
    ReplaySummary summary_;
};
}  // namespace

ReplaySummary replayRawlog(const std::filesystem::path& path, const Annotations& annotations,
                           const std::atomic<bool>& stop, const FrameListener& listener)
{
    const ReplaySummary summary = Replay(path, annotations, listener).run(stop);
    if (summary.frames > 0 || summary.interrupted) return summary;
    throw std::runtime_error(path.string() + ": none of its " +
                             std::to_string(annotations.tables.size()) +
                             " tables of tracks has a scan with a pose at its time: are the "
                             "sensor's observations still in it?");
}

}  // namespace vdamf
