// SPDX-License-Identifier: BSD-3-Clause
// cases.csv: every single estimate with its errors, to look for the worst ones.
#pragma once

#include <string>

#include "vdamf/learning/clusters/case_errors.h"

namespace vdamf
{
std::string casesHeader();  ///< with the line's end

std::string caseLine(const std::string& condition, const std::string& method, std::size_t index,
                     const LabelledCluster& sample, const CaseErrors& errors);

}  // namespace vdamf
