// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/object_scores.h"

#include <algorithm>
#include <map>
#include <set>

namespace vdamf
{
namespace
{
/// An object on its way through the frames.
struct Course
{
    ObjectScore score;
    double firstTime = 0.0;
    double lastFound = 0.0;
    bool lostSince = false;
    std::set<std::uint64_t> trackIds;
};

using Courses = std::map<std::string, Course>;

void addFrame(Courses& courses, const TruthRow& truth)
{
    const auto [place, isNew] = courses.try_emplace(truth.objectId);
    Course& course = place->second;
    if (isNew)
    {
        course.score.id = truth.objectId;
        course.score.objectClass = truth.objectClass;
        course.firstTime = truth.time;
    }
    ++course.score.frames;
}

void addFound(Course& course, double time, const MatchedPair& pair, std::uint64_t trackId)
{
    ObjectScore& score = course.score;
    if (!score.timeToFirst) score.timeToFirst = time - course.firstTime;
    if (course.lostSince) score.longestGap = std::max(score.longestGap, time - course.lastFound);
    course.lostSince = false;
    course.lastFound = time;
    course.trackIds.insert(trackId);
    score.meanOverlap += pair.overlap;
    ++score.found;
}
}  // namespace

std::vector<ObjectScore> objectScores(const Sequence& sequence,
                                      const std::vector<FrameMatches>& matches)
{
    Courses courses;
    for (std::size_t k = 0; k < matches.size(); ++k)
    {
        const ScoredFrame& frame = sequence.frames[k];
        for (std::size_t i = 0; i < frame.truth.size(); ++i)
        {
            if (frame.counts[i]) addFrame(courses, frame.truth[i]);
        }
        for (const MatchedPair& pair : matches[k].pairs)
        {
            const TruthRow& truth = frame.truth[pair.truth];
            addFound(courses.at(truth.objectId), truth.time, pair,
                     frame.tracks[pair.track].report.id);
        }
        for (const std::size_t i : matches[k].missed)
        {
            Course& course = courses.at(frame.truth[i].objectId);
            course.lostSince = course.score.found > 0;
        }
    }
    std::vector<ObjectScore> scores;
    for (auto& [id, course] : courses)
    {
        ObjectScore score = std::move(course.score);
        score.tracks = course.trackIds.size();
        if (score.found > 0) score.meanOverlap /= static_cast<double>(score.found);
        scores.push_back(std::move(score));
    }
    return scores;
}

}  // namespace vdamf
