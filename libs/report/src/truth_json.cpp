// SPDX-License-Identifier: BSD-3-Clause
#include "truth_json.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "vdamf/evaluation/evaluation_json.h"
#include "vdamf/evaluation/truth_frames.h"

namespace vdamf
{
namespace
{
/// Frames of the run by time.
class FrameTimes
{
public:
    FrameTimes(const std::vector<RecordedFrame>& frames, double tolerance) : tolerance_(tolerance)
    {
        for (const RecordedFrame& frame : frames) times_.push_back(frame.time);
    }

    std::size_t nearest(double time) const { return nearestTime(times_, time); }
    std::optional<std::size_t> at(double time) const
    {
        const std::size_t index = nearest(time);
        if (std::abs(times_[index] - time) <= tolerance_) return index;
        return std::nullopt;
    }

private:
    double tolerance_;
    std::vector<double> times_;
};

std::vector<TrackRow> rowsOf(const std::vector<RecordedFrame>& frames)
{
    std::vector<TrackRow> rows;
    for (const RecordedFrame& frame : frames)
        for (const TrackReport& track : frame.tracks) rows.push_back({frame.time, track});
    return rows;
}

/// Truth of frames that were not tracked is neither found nor missed.
std::vector<TruthRow> truthOf(const std::vector<RecordedFrame>& frames, const ReportTruth& truth)
{
    std::vector<double> times;
    for (const RecordedFrame& frame : frames) times.push_back(frame.time);
    std::vector<TruthRow> rows = truthAt(truth.rows, times, truth.evaluation.scoring.timeTolerance);
    if (!rows.empty() || truth.rows.empty()) return rows;
    failNothingCommon(*spanOf(truth.rows), {times.front(), times.back()});
}

void append(Json& columns, std::size_t frame, const TruthRow& row, bool doesCount)
{
    columns["frame"].push_back(frame);
    columns["counts"].push_back(doesCount ? 1 : 0);
    columns["x"].push_back(rounded(row.box.x, 3));
    columns["y"].push_back(rounded(row.box.y, 3));
    columns["z"].push_back(rounded(row.z, 2));
    columns["heading"].push_back(rounded(row.box.heading, 4));
    columns["length"].push_back(rounded(row.box.length, 3));
    columns["width"].push_back(rounded(row.box.width, 3));
    columns["height"].push_back(rounded(row.height, 2));
    columns["speed"].push_back(rounded(row.speed, 3));
    columns["points"].push_back(row.points);
}

/// Objects in the order of their names, with the index of each.
struct Objects
{
    Json json = Json::array();
    std::map<std::string, std::size_t> index;
};

Objects objectsOf(const Sequence& sequence, const FrameTimes& times)
{
    std::map<std::string, Json> byName;
    for (const ScoredFrame& frame : sequence.frames)
    {
        const auto f = times.at(frame.time);
        if (!f) continue;
        for (std::size_t i = 0; i < frame.truth.size(); ++i)
        {
            const TruthRow& row = frame.truth[i];
            Json& columns = byName[row.objectId];
            if (columns.is_null())
                columns = {{"id", row.objectId},
                           {"class", row.objectClass},
                           {"isVehicle", isVehicleClass(row.objectClass)}};
            append(columns, *f, row, frame.counts[i]);
        }
    }
    Objects objects;
    for (auto& [name, columns] : byName)
    {
        objects.index[name] = objects.json.size();
        objects.json.push_back(std::move(columns));
    }
    return objects;
}

Json matchesJson(const Sequence& sequence, const std::vector<FrameMatches>& matches,
                 const FrameTimes& times, const Objects& objects, std::size_t frameCount)
{
    Json json = Json::array();
    for (std::size_t f = 0; f < frameCount; ++f)
        json.push_back(
            {{"pairs", Json::array()}, {"missed", Json::array()}, {"false", Json::array()}});
    for (std::size_t i = 0; i < matches.size(); ++i)
    {
        const ScoredFrame& frame = sequence.frames[i];
        const auto f = times.at(frame.time);
        if (!f) continue;
        const auto object = [&](std::size_t truth)
        { return objects.index.at(frame.truth[truth].objectId); };
        for (const MatchedPair& pair : matches[i].pairs)
            json[*f]["pairs"].push_back(
                {object(pair.truth), frame.tracks[pair.track].report.id, rounded(pair.overlap, 2)});
        for (const std::size_t truth : matches[i].missed)
            json[*f]["missed"].push_back(object(truth));
        for (const std::size_t track : matches[i].falseAlarms)
            json[*f]["false"].push_back(frame.tracks[track].report.id);
    }
    return json;
}

Json mistakeJson(const Mistake& m, const FrameTimes& times, const Objects& objects)
{
    const auto object = objects.index.find(m.objectId);
    const bool isAngle = m.kind == MistakeKind::Heading || m.kind == MistakeKind::Flip;
    const auto id = [](const std::optional<std::uint64_t>& track)
    { return track ? Json(*track) : Json(nullptr); };
    return {{"kind", nameOf(m.kind)},
            {"object", object != objects.index.end() ? Json(object->second) : Json(nullptr)},
            {"track", id(m.track)},
            {"trackBefore", id(m.trackBefore)},
            {"first", times.nearest(m.firstTime)},
            {"last", times.nearest(m.lastTime)},
            {"frames", m.frames},
            {"worst", rounded(isAngle ? m.worst * 180.0 / kPi : m.worst, 2)},
            {"worstFrame", times.nearest(m.worstTime)}};
}
}  // namespace

Json truthJson(const std::vector<RecordedFrame>& frames, const ReportTruth& truth)
{
    const std::vector<TrackRow> rows = rowsOf(frames);
    const std::vector<TruthRow> labelled = truthOf(frames, truth);
    const Sequence sequence = makeSequence(labelled, rows, truth.evaluation.scoring);
    const auto matches = matchFrames(sequence, truth.evaluation.scoring.overlap);
    const auto pairs = poseErrors(sequence, matchFrames(sequence, truth.evaluation.pairOverlap));
    const FrameTimes times(frames, truth.evaluation.scoring.timeTolerance);
    const Objects objects = objectsOf(sequence, times);
    Json mistakes = Json::array();
    for (const Mistake& m : mistakesOf(sequence, matches, pairs, truth.mistakes))
        mistakes.push_back(mistakeJson(m, times, objects));
    const Evaluation evaluation = evaluate(labelled, rows, truth.evaluation);
    return {{"objects", objects.json},
            {"matches", matchesJson(sequence, matches, times, objects, frames.size())},
            {"mistakes", std::move(mistakes)},
            {"metrics", Json::parse(toJson(evaluation))}};
}

}  // namespace vdamf
