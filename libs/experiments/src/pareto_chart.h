// SPDX-License-Identifier: BSD-3-Clause
// Accuracy against time: which settings are worth their milliseconds.
#pragma once

#include <string>

#include "vdamf/experiments/results.h"

namespace vdamf
{
/// As SVG for a page with the style of sweepPage(): each setting by its time a frame and its mean
/// of the goal's metric, those of the front (paretoFront()) joined and numbered. Points carry the
/// number of their setting as data-setting. Empty where no setting has both.
std::string paretoSvg(const SweepResults& results);

}  // namespace vdamf
