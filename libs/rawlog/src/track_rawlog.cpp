// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/track_rawlog.h"

#include <mrpt/core/Clock.h>

#include <chrono>
#include <set>
#include <stdexcept>

#include "pending_entries.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/annotation.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/rawlog/world_frame.h"

namespace vdamf
{
namespace
{
// Of 3 degrees of freedom.
constexpr double kChiSquareMedian = 2.366;
constexpr double kChiSquare99 = 11.345;

// Adds the time that a scope takes to a sum.
class Stopwatch
{
public:
    explicit Stopwatch(double& sum) : sum_(sum), start_(std::chrono::steady_clock::now()) {}
    ~Stopwatch()
    {
        sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    double& sum_;
    std::chrono::steady_clock::time_point start_;
};

class Run
{
public:
    Run(const TrackRawlogJob& job, const FrameListener& listener)
        : job_(job),
          listener_(listener),
          reader_(job.input),
          ins_(job.configuration.ins),
          pending_(reader_, ins_, job.configuration.scan.label),
          tracker_(job.configuration.tracker),
          annotator_(job.configuration.output)
    {
        openOutputs();
        observeStages();
    }

    TrackRawlogSummary run(const std::atomic<bool>& stop)
    {
        // The head of the output names the world's origin, which the first scan settles.
        if (PendingScan* scan = pending_.prepareFirstScan())
            track(*pending_.earliestScanUntil(scan->time));
        while (!stop && !finished_ && prepareFirst())
        {
            PendingEntry& first = pending_.first();
            // Scans that stand later in the file but are earlier in time come first.
            for (PendingScan& scan : first.scans)
                while (!scan.done) track(*pending_.earliestScanUntil(scan.time));
            if (!finished_) copyFirst();
        }
        summary_.interrupted = stop;
        summary_.read = reader_.summary();
        summary_.insSource = ins_.sourceName();
        // An interrupted run leaves its outputs unfinished: they stay as `.partial`.
        if (!summary_.interrupted)
        {
            checkUsable();
            commit();
        }
        return summary_;
    }

private:
    void openOutputs()
    {
        if (job_.output)
        {
            RawlogWriter::Options options;
            options.gzLevel = job_.configuration.output.gzLevel;
            options.threads = job_.configuration.output.gzThreads;
            options.existing = job_.existing;
            options.unfinished = OutputFile::Unfinished::Keep;
            writer_.emplace(*job_.output, options);
        }
        if (job_.tracks)
        {
            table_.emplace(*job_.tracks, job_.existing, OutputFile::Unfinished::Keep);
            table_->write(tracksHeader());
        }
    }

    void observeStages()
    {
        tracker_.onStage(
            [this](const Stage* stage)
            {
                const auto now = std::chrono::steady_clock::now();
                if (stage_ != nullptr)
                    summary_.stageSeconds[static_cast<std::size_t>(*stage_)] +=
                        std::chrono::duration<double>(now - stageStart_).count();
                stageStart_ = now;
                current_ = stage != nullptr ? *stage : current_;
                stage_ = stage != nullptr ? &current_ : nullptr;
            });
    }

    bool prepareFirst()
    {
        const Stopwatch watch(summary_.readSeconds);
        return pending_.prepareFirst();
    }

    void track(PendingScan& scan)
    {
        scan.done = true;
        const std::uint64_t number = summary_.scans++;
        if (number >= job_.lastFrame)
        {
            finished_ = true;
            return;
        }
        std::optional<LadarFrame> frame = frameOf(scan);
        // Frames before the first one asked for count, but are not looked at.
        if (!frame || number < job_.firstFrame) return;
        const FrameResult result = tracker_.process(*frame);
        account(result);
        annotate(scan, result);
        if (listener_) listener_(*frame, result, reader_.progress());
        ins_.forgetBefore(frame->time - 10.0);
    }

    std::optional<LadarFrame> frameOf(const PendingScan& scan)
    {
        const Stopwatch watch(summary_.frameSeconds);
        if (summary_.frames > 0 && scan.time <= summary_.lastTime)
        {
            ++summary_.outOfOrder;
            return std::nullopt;
        }
        const std::optional<VehiclePose> pose = ins_.at(scan.time);
        if (!pose)
        {
            ++summary_.withoutPose;
            return std::nullopt;
        }
        try
        {
            return toLadarFrame(*scanFrom(*scan.observation), *pose);
        }
        catch (const std::exception& error)
        {
            if (summary_.unreadable++ == 0) summary_.firstUnreadable = error.what();
            return std::nullopt;
        }
    }

    void account(const FrameResult& result)
    {
        if (summary_.frames++ == 0) summary_.firstTime = result.time;
        summary_.lastTime = result.time;
        for (const TrackReport& track : result.tracks)
        {
            if (track.status == TrackStatus::Confirmed) confirmed_.insert(track.id);
            if (track.nis && track.status == TrackStatus::Confirmed)
            {
                ++summary_.nisCount;
                if (*track.nis < kChiSquareMedian) ++summary_.nisBelowMedian;
                if (*track.nis > kChiSquare99) ++summary_.nisAbove99;
            }
        }
        summary_.tracksConfirmed = confirmed_.size();
    }

    void annotate(PendingScan& scan, const FrameResult& result)
    {
        const Stopwatch watch(summary_.writeSeconds);
        if (table_) table_->write(toCsv(result));
        if (!writer_) return;
        for (const auto& o : annotator_.annotate(result, scan.observation->timestamp))
            scan.annotations += serialized(*o);
    }

    // The first entry's bytes and, right behind them, what its scans led to. Damaged bytes are
    // left out: behind them stock tools would stop reading.
    void copyFirst()
    {
        const PendingEntry entry = pending_.popFirst();
        const Stopwatch watch(summary_.writeSeconds);
        if (!writer_) return;
        writeHead();
        if (entry.entry.kind != RawlogEntry::Kind::Damaged) writer_->writeBytes(entry.entry.bytes);
        for (const PendingScan& scan : entry.scans) writer_->writeBytes(scan.annotations);
    }

    void writeHead()
    {
        if (headWritten_) return;
        headWritten_ = true;
        writer_->write(headComment(job_.version, ins_.originText(), ins_.sourceName(),
                                   job_.configuration,
                                   mrpt::Clock::fromDouble(summary_.firstTime)));
    }

    // A run without any frame has failed: it throws, with the reason, and leaves no output.
    void checkUsable()
    {
        const std::string name = job_.input.string();
        if (summary_.frames > 0) return;
        if (writer_) writer_->discard();
        if (table_) table_->discard();
        if (summary_.scans == 0)
            throw std::runtime_error(
                name + ": no scans" +
                (job_.configuration.scan.label.empty()
                     ? std::string(" (CObservationPointCloud or CObservationVelodyneScan)")
                     : " labelled '" + job_.configuration.scan.label + "' ([scan] label)") +
                " among its " + std::to_string(summary_.read.objects) + " objects");
        if (summary_.withoutPose > 0)
            throw std::runtime_error(
                name + ": no INS pose at the time of any scan (" + std::to_string(summary_.scans) +
                " scans; poses: " + (summary_.insSource.empty() ? "none" : summary_.insSource) +
                "); see section [ins] of the configuration");
        if (summary_.unreadable > 0)
            throw std::runtime_error(name + ": no scan could be read: " + summary_.firstUnreadable);
        throw std::runtime_error(name + ": no frame in the range asked for (" +
                                 std::to_string(summary_.scans) + " scans)");
    }

    void commit()
    {
        const Stopwatch watch(summary_.writeSeconds);
        if (writer_) writer_->commit();
        if (table_) table_->commit();
    }

    const TrackRawlogJob& job_;
    const FrameListener& listener_;
    RawlogReader reader_;
    InsTrajectory ins_;
    PendingEntries pending_;
    Tracker tracker_;
    Annotator annotator_;
    std::optional<RawlogWriter> writer_;
    std::optional<OutputFile> table_;
    TrackRawlogSummary summary_;
    std::set<std::uint64_t> confirmed_;
    bool headWritten_ = false;
    bool finished_ = false;
    const Stage* stage_ = nullptr;
    Stage current_ = Stage::Ground;
    std::chrono::steady_clock::time_point stageStart_;
};
}  // namespace

void checkPaths(const TrackRawlogJob& job)
{
    const auto same = [](const std::filesystem::path& a, const std::filesystem::path& b)
    {
        std::error_code error;
        if (std::filesystem::equivalent(a, b, error)) return true;
        return std::filesystem::weakly_canonical(a, error) ==
               std::filesystem::weakly_canonical(b, error);
    };
    std::vector<std::filesystem::path> outputs = job.otherOutputs;
    if (job.output) outputs.push_back(*job.output);
    if (job.tracks) outputs.push_back(*job.tracks);
    for (std::size_t i = 0; i < outputs.size(); ++i)
    {
        std::filesystem::path partial = outputs[i];
        partial += ".partial";
        if (same(outputs[i], job.input))
            throw std::runtime_error(outputs[i].string() + ": is the input; choose another output");
        if (same(partial, job.input))
            throw std::runtime_error(outputs[i].string() + ": is written by way of " +
                                     partial.string() +
                                     ", which is the input; choose another output");
        for (std::size_t j = 0; j < i; ++j)
            if (same(outputs[i], outputs[j]))
                throw std::runtime_error(outputs[i].string() + ": is named for two outputs");
    }
}

TrackRawlogSummary trackRawlog(const TrackRawlogJob& job, const std::atomic<bool>& stop,
                               const FrameListener& listener)
{
    checkPaths(job);
    return Run(job, listener).run(stop);
}

}  // namespace vdamf
