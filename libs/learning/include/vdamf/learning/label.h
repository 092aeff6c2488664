// SPDX-License-Identifier: BSD-3-Clause
// What tracks are, by the truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vdamf/evaluation/sequence.h"
#include "vdamf/learning/sample.h"

namespace vdamf
{
/// A track in a frame, and what it is.
struct LabelledRow
{
    double time = 0.0;  ///< of the track's row, s
    std::uint64_t track = 0;
    ObjectLabel label = ObjectLabel::Unknown;
    std::string object;  ///< that it lies on
};

/// Labels of the tracks that are published.
/// A vehicle: the box overlaps a counting Car, Van, Truck, Bus or Tram by 0.3 or more, or has its
/// centre inside. Unknown: it touches a vehicle less than that, or one that does not count.
/// Clutter: all else, also on people and cyclists. Rows that are not in the result are unknown; so
/// are all at times of which the truth has no row, like those of a second sensor.
/// Where `options` limit the region, only the region is known to have all of its vehicles labelled
/// (ScoringOptions): outside of the sector ahead, a track is what it was when it was seen inside as
/// long as it stands there (within 0.5 m), or a vehicle where the truth has one, or unknown; and a
/// track that is ever on a vehicle is clutter at no time, as labels of what is hidden or cut off by
/// the camera's border are missing.
/// Throws as makeSequence().
std::vector<LabelledRow> labelTracks(const std::vector<TruthRow>& truth,
                                     const std::vector<TrackRow>& tracks,
                                     const ScoringOptions& options);

}  // namespace vdamf
