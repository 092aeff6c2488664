// SPDX-License-Identifier: BSD-3-Clause
// An evaluation for people: tables for a terminal of 80 columns.
#pragma once

#include <string>

#include "vdamf/evaluation/evaluation.h"

namespace vdamf
{
/// Blocks of detection and tracking, errors, errors by group, consistency and discriminator. "-"
/// stands for what is not known.
std::string evaluationText(const Evaluation& evaluation);

/// One line an object; ids are shown in full, and may make a line longer.
std::string objectsText(const Evaluation& evaluation);

}  // namespace vdamf
