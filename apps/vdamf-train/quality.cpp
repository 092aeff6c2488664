// SPDX-License-Identifier: BSD-3-Clause
#include "quality.h"

#include <functional>
#include <limits>
#include <sstream>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
using Samples = std::vector<ClassifierSample>;
using Condition = std::function<bool(const HeldOutFrame&)>;

Samples samplesOf(const std::vector<HeldOutFrame>& frames, double HeldOutFrame::*probability,
                  const Condition& condition)
{
    Samples samples;
    for (const HeldOutFrame& frame : frames)
    {
        if (!condition(frame)) continue;
        samples.push_back(
            {frame.sample->track, frame.*probability, frame.sample->label == ObjectLabel::Vehicle});
    }
    return samples;
}

Quality qualityOf(const Samples& samples, const RocOptions& options)
{
    return {rocOf(samples, options), reliabilityOf(samples)};
}

QualityReport::Group groupOf(const std::string& name, const Samples& samples,
                             const RocOptions& options)
{
    QualityReport::Group group = {name, 0, 0, rocOf(samples, options)};
    for (const ClassifierSample& sample : samples)
        ++(sample.vehicle ? group.vehicles : group.clutter);
    return group;
}

std::vector<QualityReport::Group> groupsOf(const std::vector<HeldOutFrame>& frames,
                                           const std::vector<double>& limits,
                                           const std::string& unit,
                                           const std::function<double(const ObjectSample&)>& value,
                                           const RocOptions& options)
{
    std::vector<QualityReport::Group> groups;
    for (std::size_t i = 0; i < limits.size(); ++i)
    {
        const bool isOpen = i + 1 == limits.size();
        const double end = isOpen ? std::numeric_limits<double>::infinity() : limits[i + 1];
        const std::string name = toText(limits[i]) + (isOpen ? "" : " to " + toText(end)) + unit +
                                 (isOpen ? " and more" : "");
        const auto isIn = [&](const HeldOutFrame& f)
        { return value(*f.sample) >= limits[i] && value(*f.sample) < end; };
        groups.push_back(
            groupOf(name, samplesOf(frames, &HeldOutFrame::frameProbability, isIn), options));
    }
    return groups;
}

std::string percent(double share)
{
    return toFixedText(100.0 * share, 2) + " %";
}

std::string withInterval(double value, double low, double high)
{
    return percent(value) + " (" + percent(low) + " to " + percent(high) + ")";
}

void tell(std::ostream& out, const char* name, const Quality& q)
{
    out << "  " << name << '\n';
    if (!q.roc)
    {
        out << "    not both vehicles and clutter: no curve\n";
        return;
    }
    const Roc& roc = *q.roc;
    out << "    samples            " << roc.vehicleSamples << " vehicles, " << roc.clutterSamples
        << " clutter, of " << roc.tracks << " tracks\n"
        << "    equal error rate   "
        << withInterval(roc.scores.equalErrorRate, roc.low.equalErrorRate, roc.high.equalErrorRate)
        << '\n'
        << "    area under curve   " << toFixedText(roc.scores.areaUnderCurve, 5) << '\n';
    if (const auto miss = roc.scores.missRateAtOnePercent)
    {
        out << "    found at 1 % false "
            << withInterval(1.0 - *miss, 1.0 - roc.high.missRateAtOnePercent.value_or(*miss),
                            1.0 - roc.low.missRateAtOnePercent.value_or(*miss))
            << '\n';
    }
    out << "    calibration error  " << toFixedText(q.reliability.expectedCalibrationError, 4)
        << " (Brier score " << toFixedText(q.reliability.brierScore, 4) << ")\n";
}

void tell(std::ostream& out, const std::vector<QualityReport::Group>& groups)
{
    for (const QualityReport::Group& group : groups)
    {
        out << "    " << group.name
            << std::string(20 - std::min<std::size_t>(19, group.name.size()), ' ') << group.vehicles
            << " vehicles, " << group.clutter << " clutter: ";
        if (group.roc)
            out << percent(group.roc->scores.equalErrorRate);
        else
            out << "no curve";
        out << '\n';
    }
}
}  // namespace

QualityReport qualityOf(const std::vector<HeldOutFrame>& frames, const RocOptions& options)
{
    constexpr std::size_t kClear = 50;  // hits
    const auto all = [](const HeldOutFrame&) { return true; };
    const auto isClear = [](const HeldOutFrame& f) { return f.sample->hits >= kClear; };
    const auto isLast = [](const HeldOutFrame& f) { return f.isLastOfTrack; };
    RocOptions withoutIntervals = options;
    withoutIntervals.replicates = 0;
    QualityReport report;
    report.frames = qualityOf(samplesOf(frames, &HeldOutFrame::frameProbability, all), options);
    report.clearFrames =
        qualityOf(samplesOf(frames, &HeldOutFrame::frameProbability, isClear), options);
    report.tracks = qualityOf(samplesOf(frames, &HeldOutFrame::trackProbability, all), options);
    report.clearTracks =
        qualityOf(samplesOf(frames, &HeldOutFrame::trackProbability, isClear), options);
    report.tracksAtEnd =
        qualityOf(samplesOf(frames, &HeldOutFrame::trackProbability, isLast), options);
    report.byRange = groupsOf(
        frames, {0.0, 10.0, 20.0, 30.0, 45.0, 60.0}, " m",
        [](const ObjectSample& s) { return s.range; }, withoutIntervals);
    report.byHits = groupsOf(
        frames, {0.0, 20.0, 50.0, 100.0, 300.0, 1000.0}, " hits",
        [](const ObjectSample& s) { return static_cast<double>(s.hits); }, withoutIntervals);
    return report;
}

std::string qualityText(const QualityReport& report)
{
    std::ostringstream out;
    tell(out, "single frames", report.frames);
    tell(out, "single frames with 50 hits or more", report.clearFrames);
    tell(out, "tracks, at each frame", report.tracks);
    tell(out, "tracks, at each frame with 50 hits or more", report.clearTracks);
    tell(out, "tracks, at their end", report.tracksAtEnd);
    out << "  equal error rate of single frames\n";
    tell(out, report.byRange);
    tell(out, report.byHits);
    return out.str();
}

}  // namespace vdamf
