// SPDX-License-Identifier: BSD-3-Clause
// Which filter of a bank measures a track: its type, carried from frame to frame.
#pragma once

#include <vector>

#include "tracker/track.h"

namespace vdamf
{
class TypeFilters
{
public:
    explicit TypeFilters(const MeasureOptions& options);

    /// Those of the track's most likely type, or the common ones.
    const MeasureOptions& optionsFor(const Track& track) const;

    /// The track with what a sighting says of its type, in log-odds. Frames of a track are alike:
    /// all of them together count as three, and old ones fade. Unchanged where there is no bank of
    /// several types.
    Track judged(Track track, const Sighting& sighting) const;

private:
    MeasureOptions common_;
    std::vector<MeasureOptions> ofType_;  // by filter of the bank; empty: one filter serves all
};

}  // namespace vdamf
