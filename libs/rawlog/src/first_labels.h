// SPDX-License-Identifier: BSD-3-Clause
// Labels for messages: what there is, where it is not what was asked for.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace vdamf
{
/// Adds a label that is not there yet; no more than eight.
inline void addLabel(std::vector<std::string>& labels, const std::string& label)
{
    constexpr std::size_t kMost = 8;
    if (labels.size() < kMost && std::find(labels.begin(), labels.end(), label) == labels.end())
        labels.push_back(label);
}

}  // namespace vdamf
