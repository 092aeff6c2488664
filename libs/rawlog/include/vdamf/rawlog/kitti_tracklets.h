// SPDX-License-Identifier: BSD-3-Clause
// The labels of a KITTI drive: tracklet_labels.xml.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace vdamf
{
/// A box of one object in one frame, velodyne frame (x forward, y left, z up).
struct KittiTrackletPose
{
    double x = 0.0;        ///< centre of the bottom, m
    double y = 0.0;        ///< centre of the bottom, m
    double z = 0.0;        ///< of the bottom, m
    double heading = 0.0;  ///< of the front, counter-clockwise from +x, rad
};

struct KittiTracklet
{
    std::string objectClass;  ///< as in truth.csv
    double length = 0.0;      ///< along the heading, m
    double width = 0.0;       ///< m
    double height = 0.0;      ///< m
    std::size_t firstFrame = 0;
    std::vector<KittiTrackletPose> poses;  ///< of firstFrame and the frames after it
};

/// In the order of the file. `frames`: scans of the drive, which no tracklet may exceed. Throws
/// std::runtime_error that names file and line: not XML, a missing element, a bad number, an
/// unknown kind of object, or a count that does not agree with the items.
std::vector<KittiTracklet> readKittiTracklets(const std::filesystem::path& path,
                                              std::size_t frames);

}  // namespace vdamf
