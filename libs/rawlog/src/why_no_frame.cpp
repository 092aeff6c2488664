// SPDX-License-Identifier: BSD-3-Clause
#include "why_no_frame.h"

#include <vector>

namespace vdamf
{
namespace
{
/// " labelled 'foo' ([scan] label)"; nothing where none was asked for.
std::string askedFor(const std::string& label, const std::string& section)
{
    return label.empty() ? "" : " labelled '" + label + "' ([" + section + "] label)";
}

/// ", but those labelled 'left', 'right'".
std::string butOthers(const std::vector<std::string>& labels)
{
    std::string all;
    for (const std::string& label : labels) all += (all.empty() ? "'" : ", '") + label + "'";
    return all.empty() ? "" : ", but those labelled " + all;
}

std::string posesText(const TrackRawlogJob& job, const TrackRawlogSummary& summary)
{
    if (!summary.insSource.empty()) return summary.insSource;
    const InsOptions& ins = job.configuration.ins;
    std::string none = "none";
    for (const auto& [source, name] : EnumNames<InsSource>::names())
        if (source == ins.source && source != InsSource::Auto)
            none += std::string(" with source = ") + name;
    return none + askedFor(ins.label, "ins") +
           (ins.label.empty() ? "" : butOthers(summary.ins.labels));
}
// " (2 damaged entries left out; truncated: ...)"; nothing where the file is whole.
std::string damageText(const RawlogSummary& read)
{
    std::string text;
    if (read.damaged > 0)
        text = std::to_string(read.damaged) + " damaged " +
               (read.damaged == 1 ? "entry" : "entries") + " left out";
    if (read.truncated)
        text += std::string(text.empty() ? "" : "; ") + "truncated: " + read.truncation;
    return text.empty() ? "" : " (" + text + ")";
}
}  // namespace

std::string whyNoFrame(const TrackRawlogJob& job, const TrackRawlogSummary& summary,
                       std::uint64_t scansMet)
{
    const std::string& label = job.configuration.scan.label;
    if (scansMet == 0 && summary.unstamped > 0)
        return "none of its " + std::to_string(summary.unstamped) +
               " scans has a time stamp, without which it has no pose";
    if (scansMet == 0)
        return "no scans" +
               (label.empty() ? " (of a class that can be tracked on)" : askedFor(label, "scan")) +
               " among its " + std::to_string(summary.read.objects) + " objects" +
               damageText(summary.read) + (label.empty() ? "" : butOthers(summary.scanLabels));
    if (summary.scans == 0)
        return "no frame in the range asked for: it begins at frame " +
               std::to_string(job.firstFrame) + ", the rawlog has the frames 0 to " +
               std::to_string(scansMet - 1);
    if (summary.withoutPose > 0)
        return "no INS pose at the time of any scan (" + std::to_string(summary.scans) +
               " scans; poses: " + posesText(job, summary) +
               (summary.poseTooLate > 0 ? ", but for " + std::to_string(summary.poseTooLate) +
                                              " of them more than a second behind in the rawlog"
                                        : "") +
               (summary.ins.impossible > 0
                    ? ", " + std::to_string(summary.ins.impossible) + " impossible ones left out"
                    : "") +
               "); see section [ins] of the configuration" +
               (summary.ins.taken > 0 ? ", and whether scans and poses have one clock" : "");
    return "no scan could be read: " + summary.firstUnreadable;
}

}  // namespace vdamf
