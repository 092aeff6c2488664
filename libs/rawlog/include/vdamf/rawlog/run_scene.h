// SPDX-License-Identifier: BSD-3-Clause
// A whole run as one scene for MRPT's SceneViewer3D.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "vdamf/tracking/types/point_cloud.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// Follows a run frame by frame.
class RunScene
{
public:
    void add(const LadarFrame& frame, const FrameResult& result);

    /// The content of a .3Dscene file (gz): the hits of the last frame coloured by height, the
    /// boxes of its tracks with their fronts and identities, the ways of all tracks and of the
    /// sensor over the whole run. World frame.
    std::string bytes() const;

private:
    struct Path
    {
        std::vector<Eigen::Vector3f> places;
        TrackReport last;
        bool isThere = false;  ///< in the last frame
    };

    LadarFrame frame_;
    std::vector<Eigen::Vector3f> sensor_;
    std::map<std::uint64_t, Path> paths_;
};

}  // namespace vdamf
