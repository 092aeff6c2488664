// SPDX-License-Identifier: BSD-3-Clause
#include "track_outputs.h"

#include <cmath>

#include "vdamf/evaluation/tables.h"

namespace vdamf
{
TrackOutputs::TrackOutputs(const TrackRawlogJob& job) : annotator_(job.configuration.output)
{
    constexpr auto kKeep = OutputFile::Unfinished::Keep;
    if (job.output)
    {
        RawlogWriter::Options options;
        options.gzLevel = job.configuration.output.gzLevel;
        options.threads = job.configuration.output.gzThreads;
        options.existing = job.existing;
        options.unfinished = kKeep;
        writer_.emplace(*job.output, options);
    }
    if (job.tracks) tracks_.emplace(*job.tracks, job.existing, kKeep);
    if (job.nis) nis_.emplace(*job.nis, job.existing, kKeep);
    // Only now: an output that cannot be opened must not leave the others behind.
    if (tracks_) tracks_->write(tracksHeader());
}

void TrackOutputs::annotate(PendingScan& scan, const FrameResult& result)
{
    if (tracks_) tracks_->write(toCsv(result));
    if (!writer_) return;
    for (const auto& o : annotator_.annotate(result, scan.observation->timestamp))
        scan.annotations += serialized(*o);
}

void TrackOutputs::copy(const PendingEntry& entry)
{
    if (!writer_) return;
    const auto take = [this](const std::string& bytes)
    {
        if (headWritten_)
            writer_->writeBytes(bytes);
        else
            held_ += bytes;
    };
    const RawlogEntry::Kind kind = entry.entry.kind;
    if (kind != RawlogEntry::Kind::Damaged && kind != RawlogEntry::Kind::Wrapper)
        take(entry.entry.bytes);
    for (const PendingScan& scan : entry.scans) take(scan.annotations);
    if (headWritten_ && entry.time) endMemberAt(*entry.time);
}

// By the recording's time, so that the same input gives the same bytes: a process that is killed
// loses about a second of it.
void TrackOutputs::endMemberAt(double time)
{
    constexpr double kLongestMember = 1.0;  // s
    if (std::abs(time - memberBegin_) < kLongestMember) return;
    memberBegin_ = time;
    writer_->endMember();
}

void TrackOutputs::writeHead(const mrpt::obs::CObservationComment& head)
{
    if (hasHead()) return;
    headWritten_ = true;
    writer_->write(head);
    writer_->writeBytes(held_);
    std::string().swap(held_);  // an assignment would keep the memory
}

void TrackOutputs::write(const NisReport& report)
{
    if (nis_) nis_->write(toCsv(report));
}

void TrackOutputs::commit()
{
    if (writer_) writer_->commit();
    if (tracks_) tracks_->commit();
    if (nis_) nis_->commit();
}

void TrackOutputs::discard()
{
    if (writer_) writer_->discard();
    if (tracks_) tracks_->discard();
    if (nis_) nis_->discard();
}

}  // namespace vdamf
