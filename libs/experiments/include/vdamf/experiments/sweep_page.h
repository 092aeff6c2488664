// SPDX-License-Identifier: BSD-3-Clause
// A sweep for people: one HTML page that needs nothing else.
#pragma once

#include <string>

#include "vdamf/experiments/results.h"

namespace vdamf
{
/// Tables that sort, each metric against each swept key with its spread over the recordings, a heat
/// map of the goal's metric for each two keys, and the front of accuracy against time. Times make
/// two pages of the same sweep differ.
std::string sweepPage(const SweepResults& results, const std::string& title);

}  // namespace vdamf
