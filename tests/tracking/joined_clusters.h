// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
/// The hits of both as those of one cluster.
inline Cluster together(Cluster a, const Cluster& b)
{
    const auto join = [](std::vector<float>& to, const std::vector<float>& from)
    { to.insert(to.end(), from.begin(), from.end()); };
    join(a.x, b.x);
    join(a.y, b.y);
    join(a.z, b.z);
    join(a.height, b.height);
    join(a.time, b.time);
    return a;
}

}  // namespace vdamf
