// SPDX-License-Identifier: BSD-3-Clause
// A group of hits that lie on one object, or on a part of one.
#pragma once

#include <cstddef>
#include <vector>

namespace vdamf
{
/// Hits of one cluster, structure of arrays of equal length (`time` may be empty). Coordinates are
/// world axes relative to the frame's origin, like those of LadarFrame.
struct Cluster
{
    std::vector<float> x;       ///< m
    std::vector<float> y;       ///< m
    std::vector<float> z;       ///< m
    std::vector<float> height;  ///< above the local ground, m
    std::vector<float> time;    ///< s relative to the frame's time; empty where it is not known

    std::size_t size() const { return x.size(); }
};

}  // namespace vdamf
