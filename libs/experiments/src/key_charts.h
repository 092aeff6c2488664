// SPDX-License-Identifier: BSD-3-Clause
// One metric against one swept key, with its spread over the recordings.
#pragma once

#include <cstddef>

#include "vdamf/experiments/results.h"
#include "vdamf/report/plots.h"

namespace vdamf
{
/// At each value of the key each recording stands with its mean over the settings that have this
/// value; the line is the mean of the recordings. Where each setting has a value of its own and
/// there are other keys (drawn and searched plans), each run is a point and there is no line.
Chart keyChart(const SweepResults& results, std::size_t metric, std::size_t key);

}  // namespace vdamf
