// SPDX-License-Identifier: BSD-3-Clause
// Where a tracker erred, as a list that people can go through: what, when, which object and track.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/evaluation/matching.h"
#include "vdamf/evaluation/pose_errors.h"
#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
enum class MistakeKind
{
    NeverFound,      ///< an object that no track ever found
    FoundLate,       ///< frames before the first track on an object
    Lost,            ///< an object without any track, after it was found
    BoxOff,          ///< a track on an object that overlaps too little of it to count as found
    IdentitySwitch,  ///< another track than the last one on the object
    FalseTrack,      ///< a track on nothing that is labelled
    Position,        ///< centres far apart, m
    Heading,         ///< axes of the boxes turned against each other, rad
    Flip,            ///< front taken for rear, rad
    Speed,           ///< m/s
    Size             ///< length or width, m
};

/// Name in the report's data: "never_found", "found_late", ...
const char* nameOf(MistakeKind kind);

/// Frames in a row (but for short breaks) in which one thing is wrong with one object or track.
struct Mistake
{
    MistakeKind kind = MistakeKind::NeverFound;
    std::string objectId;                      ///< empty for false tracks
    std::optional<std::uint64_t> track;        ///< the one on the object, or the false one
    std::optional<std::uint64_t> trackBefore;  ///< for switches: the one that had it
    double firstTime = 0.0;                    ///< s (UNIX)
    double lastTime = 0.0;
    std::size_t frames = 0;
    double worst = 0.0;      ///< largest error, in the kind's unit; overlap for BoxOff; else 0
    double worstTime = 0.0;  ///< the first frame where the kind has no size
};

/// From which size on an error is a mistake.
struct MistakeOptions
{
    double position = 1.0;                ///< m
    double heading = 15.0 * kPi / 180.0;  ///< rad
    double speed = 2.0;                   ///< m/s
    double size = 1.0;                    ///< m
    double lateAfter = 0.5;               ///< s; what is found sooner is not late
    double longestBreak = 0.5;            ///< s
};

/// By first time. `matches` at the overlap from which a track has found an object, `pairs` at a
/// lower one, of the same sequence.
std::vector<Mistake> mistakesOf(const Sequence& sequence, const std::vector<FrameMatches>& matches,
                                const std::vector<PoseError>& pairs,
                                const MistakeOptions& options = {});

}  // namespace vdamf
