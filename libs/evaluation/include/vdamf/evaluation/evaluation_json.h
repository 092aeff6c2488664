// SPDX-License-Identifier: BSD-3-Clause
// An evaluation as JSON for other programs. Keys: README of vdamf-evaluate.
#pragma once

#include <string>

#include "vdamf/evaluation/evaluation.h"

namespace vdamf
{
/// Indented, with the line's end. Keys carry units and keep their order; what is not known, or no
/// number, is null. Angles in degrees.
std::string toJson(const Evaluation& evaluation);

}  // namespace vdamf
