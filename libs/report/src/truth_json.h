// SPDX-License-Identifier: BSD-3-Clause
// Truth, what the tracks are by it, and the mistakes, for the page.
#pragma once

#include "run_recording.h"
#include "vdamf/report/run_report.h"

namespace vdamf
{
/// Keys: objects (arrays over their frames), matches (a frame each: pairs of object index and
/// track, missed objects, false tracks), mistakes, metrics (as vdamf-evaluate writes them). Truth
/// of other frames than these is left out. Throws as makeSequence().
Json truthJson(const std::vector<RecordedFrame>& frames, const ReportTruth& truth);

}  // namespace vdamf
