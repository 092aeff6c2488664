// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/identity_score.h"

#include "overlaps.h"
#include "share.h"
#include "trajectories.h"
#include "vdamf/evaluation/dont_care.h"

namespace vdamf
{
namespace
{
/// In how many frames each object and each track overlap, [object][track].
std::vector<std::vector<double>> commonFrames(const Trajectories& trajectories, double minOverlap)
{
    std::vector<std::vector<double>> frames(
        trajectories.objectLengths.size(),
        std::vector<double>(trajectories.trackLengths.size(), 0.0));
    for (const TrajectoryFrame& frame : trajectories.frames)
    {
        for (const MatchedPair& pair : frame.overlaps)
        {
            if (!reaches(pair.overlap, minOverlap)) continue;
            frames[frame.objects[pair.truth]][frame.tracks[pair.track]] += 1.0;
        }
    }
    return frames;
}
}  // namespace

IdentityScore identityScore(const Sequence& sequence, double minOverlap)
{
    const Trajectories trajectories = trajectoriesOf(withoutDontCare(sequence, minOverlap));
    const std::vector<std::vector<double>> frames = commonFrames(trajectories, minOverlap);
    // IDFP + IDFN = rows of both - 2 IDTP: the least cost of the original is the highest IDTP.
    const std::vector<int> trackOf = bestAssignment(frames);
    double idtp = 0.0;
    for (std::size_t object = 0; object < trackOf.size(); ++object)
    {
        if (trackOf[object] >= 0) idtp += frames[object][static_cast<std::size_t>(trackOf[object])];
    }
    const auto objectRows = static_cast<double>(trajectories.objectRows);
    const auto trackRows = static_cast<double>(trajectories.trackRows);
    IdentityScore score;
    score.idf1 = share(2.0 * idtp, objectRows + trackRows);
    score.idPrecision = share(idtp, trackRows);
    score.idRecall = share(idtp, objectRows);
    score.idtp = static_cast<std::size_t>(idtp);
    score.idfp = trajectories.trackRows - score.idtp;
    score.idfn = trajectories.objectRows - score.idtp;
    return score;
}

}  // namespace vdamf
