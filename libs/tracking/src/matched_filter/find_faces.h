// SPDX-License-Identifier: BSD-3-Clause
// From the matched filter's box to the faces of the vehicle, with a second look where few hits lie
// on what was found.
#pragma once

#include <functional>
#include <optional>

#include "matched_filter/face_box.h"
#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
struct FoundFaces
{
    FaceBox fit;
    FaceSet seen;
};

/// Where to look for the faces.
struct FaceSearch
{
    OrientedBox fitted;  ///< the filter's box
    OrientedBox start;
    /// The filter's box from the start, where that is not `fitted` anyway.
    std::function<OrientedBox()> filterFromStart;
    bool isFirstTaken = false;  ///< no second look
};

/// Lines through the faces of the filter's box. If they hold too few of the hits (a bush was taken
/// for a face), the start, the filter's box from there and the densest corner of the hits are tried
/// as well, and the lines that hold the most hits are taken. Nothing where no face has hits enough.
std::optional<FoundFaces> findFaces(const Hits& hits, const FaceSearch& search,
                                    const Eigen::Vector2d& sensor, const MeasureOptions& options);

}  // namespace vdamf
