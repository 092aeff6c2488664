// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/track_rawlog.h"

#include <mrpt/core/Clock.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "first_labels.h"
#include "frame_maker.h"
#include "pending_entries.h"
#include "track_outputs.h"
#include "vdamf/rawlog/annotation.h"
#include "why_no_frame.h"

namespace vdamf
{
namespace
{
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
          pending_(reader_, ins_, job.configuration.scan),
          frames_(job.configuration.scan, job.input, ins_, summary_),
          tracker_(job.configuration.tracker),
          outputs_(job),
          nis_(job.nis ? NisCollector::Rows::Keep : NisCollector::Rows::Drop)
    {
        observeStages();
    }

    TrackRawlogSummary run(const std::atomic<bool>& stop)
    {
        while (!stop && !finished_ && prepareFirst())
        {
            // Scans that stand later in the file but are earlier in time come first.
            for (PendingScan& scan : pending_.first().scans)
                while (!scan.done && !finished_) take(*pending_.earliestScanUntil(scan.time));
            if (!finished_) copyFirst();
        }
        while (pending_.holdsAnnotations()) copyFirst();
        if (outputs_.heldBytes() > 0) writeHead();
        finishSummary(stop);
        // An interrupted run leaves its outputs unfinished: they stay as `.partial`.
        if (!summary_.interrupted)
        {
            checkUsable();
            const Stopwatch watch(summary_.writeSeconds);
            outputs_.commit();
        }
        return summary_;
    }

private:
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

    void take(PendingScan& scan)
    {
        if (scansMet_ == job_.lastFrame)
        {
            finished_ = true;
            return;
        }
        scan.done = true;
        const std::vector<PendingScan*> partners = pending_.partnersOf(scan);
        for (PendingScan* partner : partners) partner->done = true;
        if (scansMet_ == 0) firstScanTime_ = scan.time;
        // Also before the range: the source of the poses, and with it the world's origin, must not
        // depend on where the range begins.
        const std::optional<VehiclePose> pose = ins_.at(scan.time);
        if (scansMet_++ >= job_.firstFrame) track(scan, pose, partners);
        // Only where the stamp is one of the recording's: a wild one would forget all poses.
        if (!pose) return;
        constexpr double kPosesKept = 10.0;  // s
        countLatePoses(scan.time - kPosesKept);
        ins_.forgetBefore(scan.time - kPosesKept);
    }

    /// Of the scans that were skipped, those of which the pose has been met since. Those before the
    /// time are given up.
    void countLatePoses(double forgotten)
    {
        const auto settled = [&](double time)
        {
            const bool late = ins_.at(time).has_value();
            summary_.poseTooLate += late ? 1 : 0;
            return late || time < forgotten;
        };
        skipped_.erase(std::remove_if(skipped_.begin(), skipped_.end(), settled), skipped_.end());
    }

    void track(PendingScan& scan, const std::optional<VehiclePose>& pose,
               const std::vector<PendingScan*>& partners)
    {
        summary_.scans += 1 + partners.size();
        addLabel(summary_.sensors, scan.observation->sensorLabel);
        for (const PendingScan* partner : partners)
            addLabel(summary_.sensors, partner->observation->sensorLabel);
        const std::uint64_t withoutPose = summary_.withoutPose;
        const std::optional<LadarFrame> frame = frameOf(scan, pose, partners);
        if (!pose && summary_.withoutPose > withoutPose) skipped_.push_back(scan.time);
        if (!frame) return;
        const FrameResult result = tracker_.process(*frame);
        account(result);
        account(result.alignment, frame->origin.head<2>());
        {
            const Stopwatch watch(summary_.writeSeconds);
            outputs_.annotate(scan, result);
            if (!outputs_.hasHead()) writeHead();
        }
        if (!listener_) return;
        const bool isElsewhere = !result.alignment.isNone();
        listener_(isElsewhere ? movedBy(*frame, result.alignment) : *frame, result,
                  reader_.progress());
    }

    std::optional<LadarFrame> frameOf(const PendingScan& scan,
                                      const std::optional<VehiclePose>& pose,
                                      const std::vector<PendingScan*>& partners)
    {
        const Stopwatch watch(summary_.frameSeconds);
        return frames_.frameOf(scan, pose, partners);
    }

    void account(const FrameResult& result)
    {
        if (summary_.frames++ == 0) summary_.firstTime = result.time;
        summary_.lastTime = result.time;
        nis_.add(result);
        for (const TrackReport& track : result.tracks)
        {
            if (track.status == TrackStatus::Confirmed && confirmed_.insert(track.id).second)
                ++summary_.tracksConfirmed;
            if (track.status == TrackStatus::Ended) confirmed_.erase(track.id);
        }
    }

    void account(const PlaneMotion& alignment, const Eigen::Vector2d& vehicle)
    {
        if (alignment.isNone()) return;
        ++summary_.aligned;
        summary_.mostShifted =
            std::max(summary_.mostShifted, (alignment.of(vehicle) - vehicle).norm());
        summary_.mostTurned = std::max(summary_.mostTurned, std::abs(alignment.turn));
    }

    void copyFirst()
    {
        const PendingEntry entry = pending_.popFirst();
        if (scansMet_ >= job_.firstFrame) summary_.unstamped += entry.unstamped;
        if (!firstEntryTime_) firstEntryTime_ = entry.time;
        if (entry.ofEarlierRun)
        {
            summary_.ofEarlierRun += job_.output ? 1 : 0;
            return;
        }
        const Stopwatch watch(summary_.writeSeconds);
        outputs_.copy(entry);
        if (outputs_.heldBytes() > job_.heldBytes) writeHead();
    }

    void writeHead()
    {
        std::optional<double> time = firstScanTime_ ? firstScanTime_ : firstEntryTime_;
        if (summary_.frames > 0) time = summary_.firstTime;
        outputs_.writeHead(headComment(job_.version, ins_.originText(), ins_.sourceName(),
                                       job_.configuration,
                                       time ? mrpt::Clock::fromDouble(*time) : INVALID_TIMESTAMP));
    }

    void finishSummary(bool interrupted)
    {
        summary_.interrupted = interrupted;
        countLatePoses(-std::numeric_limits<double>::infinity());
        summary_.read = reader_.summary();
        summary_.readError = pending_.readError();
        summary_.insSource = ins_.sourceName();
        summary_.ins = ins_.report();
        summary_.scanLabels = pending_.scanLabels();
        summary_.nis = nis_.report();
        if (summary_.frames > 0) outputs_.write(summary_.nis);
    }

    // A run without any frame has failed: it throws, with the reason, and leaves no output.
    void checkUsable()
    {
        if (summary_.frames > 0) return;
        outputs_.discard();
        if (!summary_.readError.empty()) throw ReadError(summary_.readError);
        const std::string why = job_.input.string() + ": " + whyNoFrame(job_, summary_, scansMet_);
        if (scansMet_ > 0 && summary_.scans == 0) throw NoFrameInRange(why);
        throw std::runtime_error(why);
    }

    const TrackRawlogJob& job_;
    const FrameListener& listener_;
    RawlogReader reader_;
    InsTrajectory ins_;
    PendingEntries pending_;
    TrackRawlogSummary summary_;
    FrameMaker frames_;
    Tracker tracker_;
    TrackOutputs outputs_;
    NisCollector nis_;
    std::set<std::uint64_t> confirmed_;  // that live
    std::vector<double> skipped_;        // times of scans without a pose, s (UNIX)
    std::uint64_t scansMet_ = 0;         // before the range and in it
    std::optional<double> firstScanTime_;
    std::optional<double> firstEntryTime_;
    bool finished_ = false;
    const Stage* stage_ = nullptr;
    Stage current_ = Stage::Ground;
    std::chrono::steady_clock::time_point stageStart_;
};
}  // namespace

void checkPaths(const TrackRawlogJob& job)
{
    std::vector<std::filesystem::path> outputs = job.otherOutputs;
    for (const auto& output : {job.output, job.tracks, job.nis})
        if (output) outputs.push_back(*output);
    std::vector<NamedInput> inputs = filesNamedBy(job.configuration);
    inputs.push_back({job.input, "the input"});
    inputs.push_back({job.configurationFile, "the configuration"});
    checkOutputPaths(outputs, inputs);
}

TrackRawlogSummary trackRawlog(const TrackRawlogJob& job, const std::atomic<bool>& stop,
                               const FrameListener& listener)
{
    checkPaths(job);
    return Run(job, listener).run(stop);
}

}  // namespace vdamf
