// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/evaluation_text.h"

#include <utility>
#include <vector>

#include "degrees.h"
#include "text_table.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kLineLength = 80;

std::string countText(std::size_t count)
{
    return std::to_string(count);
}

std::string scoredText(const Evaluation& e)
{
    const EvaluatedCounts& c = e.counts;
    return countText(c.frames) + " frames (" + toFixedText(c.seconds, 1) + " s), " +
           countText(c.objects) + " objects in " + countText(c.objectRows) + " rows, tracks in " +
           countText(c.trackRows) + "\n";
}

/// Four scores in a row.
std::string scoresLine(const std::vector<std::pair<const char*, double>>& scores)
{
    std::string line;
    for (const auto& [name, value] : scores)
        line += "  " + leftCell(name, 10) + rightCell(numberCell(value, 3), 7);
    return line + "\n";
}

std::string trackingText(const Evaluation& e)
{
    const ClearMot& c = e.clearMot;
    const Coverage& v = e.coverage;
    std::string text =
        "\nDetection and tracking (overlap " + toFixedText(e.options.scoring.overlap, 2) + ")\n";
    text += scoresLine({{"HOTA", e.hota.hota},
                        {"DetA", e.hota.detA},
                        {"AssA", e.hota.assA},
                        {"LocA", e.hota.locA}});
    text += scoresLine({{"MOTA", c.mota},
                        {"MOTP", c.motp},
                        {"IDF1", e.identity.idf1},
                        {"MOTP, m", c.motpDistance}});
    text += scoresLine({{"recall", c.recall},
                        {"precision", c.precision},
                        {"ID recall", e.identity.idRecall},
                        {"ID precis.", e.identity.idPrecision}});
    text += "  false alarms a frame " + numberCell(e.counts.falseAlarmsPerFrame, 2) +
            ", identity switches " + countText(c.identitySwitches) + ", fragmentations " +
            countText(c.fragmentations) + "\n";
    text += "  objects: " + countText(c.mostlyTracked) + " mostly tracked, " +
            countText(c.partlyTracked) + " partly, " + countText(c.mostlyLost) + " mostly lost; " +
            toFixedText(100.0 * v.everTracked, 0) + " % ever tracked\n";
    if (v.timeToFirst.count == 0) return text;
    return text + "  first track after " + toFixedText(v.timeToFirst.median, 2) + " s (p90 " +
           toFixedText(v.timeToFirst.p90, 2) + "), longest gap " +
           toFixedText(v.longestGap.median, 2) + " s (p90 " + toFixedText(v.longestGap.p90, 2) +
           ", max " + toFixedText(v.longestGap.max, 2) + ")\n";
}

std::string errorLine(const char* name, const ErrorStatistics& s, double unit, int decimals)
{
    const auto cell = [&](double value)
    {
        const double shown = s.count > 0 ? unit * value : kUnknown;
        return rightCell(numberCell(shown, decimals), 10);
    };
    return "  " + leftCell(name, 24) + cell(s.median) + cell(s.p90) + cell(s.rms) + cell(s.bias) +
           rightCell(countText(s.count), 10) + "\n";
}

std::string errorsText(const Evaluation& e)
{
    const ErrorSummary& s = e.errors;
    std::string text =
        "\n" +
        leftCell("Errors of pairs (overlap " + toFixedText(e.options.pairOverlap, 2) + ")", 30) +
        "  median       p90       rms      bias     pairs\n";
    text += errorLine("position, m", s.position, 1.0, 3);
    text += errorLine("  along the heading", s.longitudinal, 1.0, 3);
    text += errorLine("  to its left", s.lateral, 1.0, 3);
    text += errorLine("nearest corner, m", s.corner, 1.0, 3);
    text += errorLine("heading, deg", s.heading, kDegrees, 2);
    text += errorLine("heading mod 180, deg", s.headingAxis, kDegrees, 2);
    text += errorLine("speed, m/s", s.speed, 1.0, 3);
    text += errorLine("yaw rate, deg/s", s.yawRate, kDegrees, 2);
    text += errorLine("length, m", s.length, 1.0, 3);
    text += errorLine("width, m", s.width, 1.0, 3);
    text += "  overlap: mean " + numberCell(s.pairs > 0 ? s.overlap.bias : kUnknown, 3) +
            "; front taken for rear in " + countText(s.flips) + " pairs, " +
            countText(e.flipsOfMoving) + " of them moving\n  length taken for width in " +
            countText(s.exchanged) + " pairs, in " + countText(s.exchangedThoughSure) +
            " of them though sure (99 %)\n";
    if (s.pairs > 0 && s.corner.count == 0)
        text += "  The truth has no sensor_x_m, sensor_y_m: no corners, nothing by range\n";
    const ErrorStatistics& still = e.phantomSpeed;
    if (still.count == 0) return text;
    return text + "  phantom speed of still objects: median " + toFixedText(still.median, 2) +
           ", p95 " + toFixedText(still.p95, 2) + ", max " + toFixedText(still.max, 2) + " m/s (" +
           countText(still.count) + " pairs)\n";
}

std::string groupLine(const ErrorGroup& group)
{
    const ErrorSummary& s = group.errors;
    const auto cell = [](const ErrorStatistics& of, double unit, int decimals)
    {
        const double shown = of.count > 0 ? unit * of.median : kUnknown;
        return rightCell(numberCell(shown, decimals), 8);
    };
    return "  " + leftCell(group.name, 12) + rightCell(countText(s.pairs), 7) +
           cell(s.position, 1.0, 2) + cell(s.corner, 1.0, 2) + cell(s.headingAxis, kDegrees, 2) +
           cell(s.speed, 1.0, 2) + cell(s.length, 1.0, 2) + cell(s.width, 1.0, 2) +
           cell(s.overlap, 1.0, 2) + "\n";
}

std::string groupsText(const char* name, const std::vector<ErrorGroup>& groups)
{
    std::string lines;
    for (const ErrorGroup& group : groups)
    {
        if (group.errors.pairs > 0) lines += groupLine(group);
    }
    return lines.empty() ? "" : name + ("\n" + lines);
}

std::string allGroupsText(const Evaluation& e)
{
    const std::string groups = groupsText(" range, m", e.errorsByRange) +
                               groupsText(" hits on the object", e.errorsByPoints) +
                               groupsText(" faces seen", e.errorsByFaces) +
                               groupsText(" told sigma of the length, cm", e.errorsByLengthSigma);
    if (groups.empty()) return "";
    std::string header = leftCell("Medians", 14) + rightCell("pairs", 7);
    for (const char* name : {"centre", "corner", "heading", "speed", "length", "width", "overlap"})
        header += rightCell(name, 8);
    return "\n" + header + "\n" + groups;
}

std::string consistencyLine(const char* name, const Consistency& c)
{
    constexpr std::size_t kIndent = 20;
    return "  " + leftCell(name, kIndent - 2) + wrapped(inWords(c), kIndent, kLineLength) + "\n";
}

std::string consistencyText(const ConsistencyReport& c)
{
    return "\nConsistency: are errors as large as the covariance says?\n" +
           consistencyLine("NEES of pose", c.neesPose) +
           consistencyLine("NEES of speed", c.neesSpeed) +
           consistencyLine("NEES of size", c.neesSize) +
           consistencyLine("NIS on objects", c.nisMatched) +
           consistencyLine("NIS of all tracks", c.nisAll);
}

std::string discriminatorText(const Evaluation& e)
{
    if (!e.counts.hasProbability)
    {
        if (e.counts.trackRows == 0) return "\nDiscriminator: there are no tracks to tell apart\n";
        return "\nThe tracks have no vehicle_probability: nothing tells vehicles from "
               "other\nobjects, so every tracked bush and wall off the labels is a false alarm.\n";
    }
    if (!e.roc) return "\nDiscriminator: no ROC, there are not both vehicles and clutter\n";
    const Roc& roc = *e.roc;
    const auto line = [&](const char* name, auto member)
    {
        return "  " + leftCell(name, 24) + rightCell(numberCell(roc.scores.*member, 4), 8) +
               "   95 % " + numberCell(roc.low.*member, 4) + " to " +
               numberCell(roc.high.*member, 4) + "\n";
    };
    return "\nDiscriminator (" + countText(roc.vehicleSamples) + " rows of vehicles, " +
           countText(roc.clutterSamples) + " of clutter, " + countText(roc.tracks) + " tracks)\n" +
           line("area under the ROC", &RocScores::areaUnderCurve) +
           line("equal error rate", &RocScores::equalErrorRate) +
           line("miss rate at FPR 1 %", &RocScores::missRateAtOnePercent) +
           line("miss rate at FPR 0.1 %", &RocScores::missRateAtOnePerMille);
}
}  // namespace

std::string evaluationText(const Evaluation& e)
{
    return scoredText(e) + trackingText(e) + errorsText(e) + allGroupsText(e) +
           consistencyText(e.consistency) + discriminatorText(e);
}

std::string objectsText(const Evaluation& e)
{
    std::string text =
        leftCell("Object", 18) + "class       frames  found tracks overlap  first s    gap s\n";
    for (const ObjectScore& o : e.objects)
    {
        const double overlap = o.found > 0 ? o.meanOverlap : kUnknown;
        text += "  " + leftCell(o.id, 15) + " " + leftCell(o.objectClass, 11) +
                rightCell(countText(o.frames), 7) + rightCell(countText(o.found), 7) +
                rightCell(countText(o.tracks), 7) + rightCell(numberCell(overlap, 2), 8) +
                rightCell(numberCell(o.timeToFirst, 2), 9) +
                rightCell(numberCell(o.longestGap, 2), 9) + "\n";
    }
    return text;
}

}  // namespace vdamf
