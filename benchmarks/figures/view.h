// SPDX-License-Identifier: BSD-3-Clause
// One object as the figures of the paper show it: its hits and the filter fitted to them.
#pragma once

#include <string>
#include <vector>

#include "vdamf/evaluation/tables.h"
#include "vdamf/tracking/types/measurement.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
struct FigureView
{
    std::string caption;
    std::vector<Eigen::Vector3d> hits;                 ///< z above the object's ground, m
    Eigen::Vector2d sensor = Eigen::Vector2d::Zero();  ///< in the coordinates of the hits
    Measurement measured;
};

/// The object's hits in a frame, cut out by its box in the truth (0.4 m wider), and the measurement
/// from them alone. Coordinates: world axes, the origin at the box's centre.
FigureView viewOf(const LadarFrame& frame, const TruthRow& object, const std::string& caption);

/// The same for the hits about a box of a track.
FigureView viewOf(const LadarFrame& frame, const OrientedBox& box, double groundZ,
                  const std::string& caption);

/// Fig. 8 and 10 (a) to (d): views from above side by side. The fit is red with its seen edges
/// filled, the surround dashed blue, the line of sight dashed black; the ellipse and the sector are
/// ten times the standard deviation of the centre (cut at 2.2 m) and of the heading.
std::string viewsSvg(const std::vector<FigureView>& views, int columns);

/// Fig. 10 (e): hits and box in oblique projection.
std::string obliqueSvg(const FigureView& view);

}  // namespace vdamf
