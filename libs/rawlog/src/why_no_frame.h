// SPDX-License-Identifier: BSD-3-Clause
// Why a run has not tracked a single frame.
#pragma once

#include <cstdint>
#include <string>

#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
/// `scansMet`: scans that were there to be tracked on, before the range asked for and in it.
std::string whyNoFrame(const TrackRawlogJob& job, const TrackRawlogSummary& summary,
                       std::uint64_t scansMet);

}  // namespace vdamf
