// SPDX-License-Identifier: BSD-3-Clause
#include "tracking_run.h"

#include <mrpt/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "first_labels.h"
#include "vdamf/rawlog/annotation.h"
#include "vdamf/tracking/hindsight/hindsight.h"
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
}  // namespace

TrackingRun::TrackingRun(const TrackRawlogJob& job, FrameListener listener)
    : job_(job),
      listener_(std::move(listener)),
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

void TrackingRun::tell(std::vector<FrameResult> tracked, const TrackRawlogSummary& summary)
{
    for (const FrameResult& frame : tracked) nis_.add(frame);
    summary_.stageSeconds = summary.stageSeconds;
    summary_.readSeconds = summary.readSeconds;
    summary_.frameSeconds = summary.frameSeconds;
    const Stopwatch watch(summary_.writeSeconds);
    told_ = inHindsight(std::move(tracked));
}

TrackRawlogSummary TrackingRun::run(const std::atomic<bool>& stop)
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

void TrackingRun::observeStages()
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

bool TrackingRun::prepareFirst()
{
    const Stopwatch watch(summary_.readSeconds);
    return pending_.prepareFirst();
}

void TrackingRun::take(PendingScan& scan)
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

// Of the scans that were skipped, those of which the pose has been met since. Those before the
// time are given up.
void TrackingRun::countLatePoses(double forgotten)
{
    const auto settled = [&](double time)
    {
        const bool late = ins_.at(time).has_value();
        summary_.poseTooLate += late ? 1 : 0;
        return late || time < forgotten;
    };
    skipped_.erase(std::remove_if(skipped_.begin(), skipped_.end(), settled), skipped_.end());
}

void TrackingRun::track(PendingScan& scan, const std::optional<VehiclePose>& pose,
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
    const FrameResult result = resultOf(*frame);
    account(result);
    account(result.alignment, frame->origin.head<2>());
    {
        const Stopwatch watch(summary_.writeSeconds);
        outputs_.annotate(scan, result);
        if (!outputs_.hasHead()) writeHead();
    }
    if (!listener_) return;
    const bool isElsewhere = !result.alignment.isNone();
    listener_(isElsewhere ? movedBy(*frame, result.alignment) : *frame, result, reader_.progress());
}

FrameResult TrackingRun::resultOf(const LadarFrame& frame)
{
    if (!told_) return tracker_.process(frame);
    if (summary_.frames >= told_->size() || (*told_)[summary_.frames].time != frame.time)
        throw std::runtime_error(job_.input.string() + ": changed while it was tracked");
    return std::move((*told_)[summary_.frames]);
}

std::optional<LadarFrame> TrackingRun::frameOf(const PendingScan& scan,
                                               const std::optional<VehiclePose>& pose,
                                               const std::vector<PendingScan*>& partners)
{
    const Stopwatch watch(summary_.frameSeconds);
    return frames_.frameOf(scan, pose, partners);
}

void TrackingRun::account(const FrameResult& result)
{
    if (summary_.frames++ == 0) summary_.firstTime = result.time;
    summary_.lastTime = result.time;
    if (!told_) nis_.add(result);
    for (const TrackReport& track : result.tracks)
    {
        if (track.status == TrackStatus::Confirmed && confirmed_.insert(track.id).second)
            ++summary_.tracksConfirmed;
        if (track.status == TrackStatus::Ended) confirmed_.erase(track.id);
    }
}

void TrackingRun::account(const PlaneMotion& alignment, const Eigen::Vector2d& vehicle)
{
    if (alignment.isNone()) return;
    ++summary_.aligned;
    summary_.mostShifted = std::max(summary_.mostShifted, (alignment.of(vehicle) - vehicle).norm());
    summary_.mostTurned = std::max(summary_.mostTurned, std::abs(alignment.turn));
}

void TrackingRun::copyFirst()
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

void TrackingRun::writeHead()
{
    std::optional<double> time = firstScanTime_ ? firstScanTime_ : firstEntryTime_;
    if (summary_.frames > 0) time = summary_.firstTime;
    outputs_.writeHead(headComment(job_.version, ins_.originText(), ins_.sourceName(),
                                   job_.configuration,
                                   time ? mrpt::Clock::fromDouble(*time) : INVALID_TIMESTAMP));
}

void TrackingRun::finishSummary(bool interrupted)
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
void TrackingRun::checkUsable()
{
    if (summary_.frames > 0) return;
    outputs_.discard();
    if (!summary_.readError.empty()) throw ReadError(summary_.readError);
    const std::string why = job_.input.string() + ": " + whyNoFrame(job_, summary_, scansMet_);
    if (scansMet_ > 0 && summary_.scans == 0) throw NoFrameInRange(why);
    throw std::runtime_error(why);
}

}  // namespace vdamf
