// SPDX-License-Identifier: BSD-3-Clause
// Clusters hit by hit.
#pragma once

#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
/// With z and time where those are known.
inline void appendHit(Cluster& to, const Cluster& from, std::size_t i)
{
    to.x.push_back(from.x[i]);
    to.y.push_back(from.y[i]);
    if (!from.z.empty()) to.z.push_back(from.z[i]);
    to.height.push_back(from.height[i]);
    if (!from.time.empty()) to.time.push_back(from.time[i]);
}

inline void appendHits(Cluster& to, const Cluster& from)
{
    for (std::size_t i = 0; i < from.size(); ++i) appendHit(to, from, i);
}

}  // namespace vdamf
