// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/hota.h"

#include <array>
#include <cmath>

#include "overlaps.h"
#include "share.h"
#include "trajectories.h"
#include "vdamf/evaluation/dont_care.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kAlphas = 19;

double alphaAt(std::size_t index)
{
    return 0.05 * static_cast<double>(index + 1);
}

/// An object and a track over all frames.
struct Relation
{
    double common = 0.0;  // frames in common, by overlap; then the share of all frames of both
    std::array<double, kAlphas> pairs = {};  // TPA
};

using Relations = std::map<Identities, Relation>;

/// Sums over all alphas' pairs.
struct Sums
{
    std::array<double, kAlphas> pairs = {};  // TP
    std::array<double, kAlphas> overlap = {};
    std::array<double, kAlphas> assA = {};
    std::array<double, kAlphas> assRe = {};
    std::array<double, kAlphas> assPr = {};
};

Identities identitiesOf(const TrajectoryFrame& frame, const MatchedPair& pair)
{
    return {frame.objects[pair.truth], frame.tracks[pair.track]};
}

double lengthOf(const std::vector<std::size_t>& lengths, std::size_t identity)
{
    return static_cast<double>(lengths[identity]);
}

/// In a frame a pair counts with its part of all the overlap that its two rows have.
void addFrame(Relations& relations, const TrajectoryFrame& frame)
{
    std::vector<double> ofObject(frame.objects.size(), 0.0);
    std::vector<double> ofTrack(frame.tracks.size(), 0.0);
    for (const MatchedPair& pair : frame.overlaps)
    {
        ofObject[pair.truth] += pair.overlap;
        ofTrack[pair.track] += pair.overlap;
    }
    for (const MatchedPair& pair : frame.overlaps)
    {
        const double all = ofObject[pair.truth] + ofTrack[pair.track] - pair.overlap;
        relations[identitiesOf(frame, pair)].common += pair.overlap / all;
    }
}

Relations relationsOf(const Trajectories& trajectories)
{
    Relations relations;
    for (const TrajectoryFrame& frame : trajectories.frames) addFrame(relations, frame);
    for (auto& [identities, relation] : relations)
    {
        const double lengths = lengthOf(trajectories.objectLengths, identities.first) +
                               lengthOf(trajectories.trackLengths, identities.second);
        relation.common /= lengths - relation.common;
    }
    return relations;
}

std::vector<MatchedPair> pairsOf(const TrajectoryFrame& frame, const Relations& relations)
{
    std::vector<std::vector<double>> scores(frame.objects.size(),
                                            std::vector<double>(frame.tracks.size(), 0.0));
    for (const MatchedPair& pair : frame.overlaps)
    {
        const double common = relations.at(identitiesOf(frame, pair)).common;
        scores[pair.truth][pair.track] = common * pair.overlap;
    }
    const std::vector<int> trackOf = bestAssignment(scores);
    std::vector<MatchedPair> pairs;
    for (const MatchedPair& pair : frame.overlaps)
    {
        if (trackOf[pair.truth] == static_cast<int>(pair.track)) pairs.push_back(pair);
    }
    return pairs;
}

/// Pairs every frame; notes each pair at the alphas that it reaches.
Sums pairAll(const Trajectories& trajectories, Relations& relations)
{
    Sums sums;
    for (const TrajectoryFrame& frame : trajectories.frames)
    {
        for (const MatchedPair& pair : pairsOf(frame, relations))
        {
            Relation& relation = relations.at(identitiesOf(frame, pair));
            for (std::size_t a = 0; a < kAlphas && reaches(pair.overlap, alphaAt(a)); ++a)
            {
                sums.pairs[a] += 1.0;
                sums.overlap[a] += pair.overlap;
                relation.pairs[a] += 1.0;
            }
        }
    }
    return sums;
}

Sums withAssociation(Sums sums, const Trajectories& trajectories, const Relations& relations)
{
    for (const auto& [identities, relation] : relations)
    {
        const double object = lengthOf(trajectories.objectLengths, identities.first);
        const double track = lengthOf(trajectories.trackLengths, identities.second);
        for (std::size_t a = 0; a < kAlphas; ++a)
        {
            const double pairs = relation.pairs[a];
            sums.assA[a] += pairs * pairs / (object + track - pairs);
            sums.assRe[a] += pairs * pairs / object;
            sums.assPr[a] += pairs * pairs / track;
        }
    }
    return sums;
}

HotaAtAlpha scoresAt(std::size_t a, const Sums& sums, const Trajectories& trajectories)
{
    const auto objectRows = static_cast<double>(trajectories.objectRows);
    const auto trackRows = static_cast<double>(trajectories.trackRows);
    const double pairs = sums.pairs[a];
    HotaAtAlpha scores;
    scores.alpha = alphaAt(a);
    if (objectRows + trackRows == 0.0) return scores;
    scores.detA = share(pairs, objectRows + trackRows - pairs);
    scores.detRe = share(pairs, objectRows);
    scores.detPr = share(pairs, trackRows);
    const bool hasPairs = pairs > 0.0;
    scores.assA = hasPairs ? sums.assA[a] / pairs : 0.0;
    scores.assRe = hasPairs ? sums.assRe[a] / pairs : 0.0;
    scores.assPr = hasPairs ? sums.assPr[a] / pairs : 0.0;
    if (sums.pairs[0] > 0.0) scores.locA = hasPairs ? sums.overlap[a] / pairs : 1.0;
    scores.hota = std::sqrt(scores.detA * scores.assA);
    return scores;
}

double meanOf(const std::vector<HotaAtAlpha>& scores, double HotaScores::*member)
{
    double sum = 0.0;
    for (const HotaAtAlpha& at : scores) sum += at.*member;
    return sum / static_cast<double>(scores.size());
}
}  // namespace

Hota hotaOf(const Sequence& sequence, double dontCareOverlap)
{
    const Trajectories trajectories = trajectoriesOf(withoutDontCare(sequence, dontCareOverlap));
    Relations relations = relationsOf(trajectories);
    const Sums pairs = pairAll(trajectories, relations);
    const Sums sums = withAssociation(pairs, trajectories, relations);
    Hota result;
    for (std::size_t a = 0; a < kAlphas; ++a)
    {
        result.atAlpha.push_back(scoresAt(a, sums, trajectories));
    }
    for (double HotaScores::*member :
         {&HotaScores::hota, &HotaScores::detA, &HotaScores::assA, &HotaScores::locA,
          &HotaScores::detRe, &HotaScores::detPr, &HotaScores::assRe, &HotaScores::assPr})
    {
        result.*member = meanOf(result.atAlpha, member);
    }
    return result;
}

}  // namespace vdamf
