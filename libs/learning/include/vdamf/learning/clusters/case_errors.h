// SPDX-License-Identifier: BSD-3-Clause
// Errors of one estimate against the true box.
#pragma once

#include <optional>

#include "vdamf/learning/clusters/labelled_cluster.h"
#include "vdamf/tracking/types/measurement.h"

namespace vdamf
{
struct Estimate
{
    OrientedBox box;
    std::optional<Measurement> measurement;  ///< of our fits
};

struct CaseErrors
{
    double heading90 = 0.0;   ///< to the nearest axis of the true box, 0..45 deg
    double heading180 = 0.0;  ///< to its long axis, 0..90 deg
    double corner = 0.0;  ///< of the true corner nearest to the sensor to the estimate's nearest, m
    std::optional<double> end;     ///< of the end in view, positive outwards, m
    std::optional<double> side;    ///< of the side in view, positive outwards, m
    std::optional<double> length;  ///< where an end and a side are in view, m
    std::optional<double> width;   ///< likewise, m
    double iou = 0.0;              ///< 0..1
    std::optional<double> nees;    ///< of heading and of the faces seen by the fit's own word
    int neesDimension = 0;
    int iterations = 0;
    bool failed = false;  ///< not converged or not finite
};

/// The same rectangle with the heading turned by quarters to within 45 degrees of a direction.
OrientedBox alignedTo(const OrientedBox& box, double heading);

/// How far a face of `other` lies outwards of the same face of `box`, along the normal in the
/// middle of the latter, m. The headings are within 45 degrees of each other.
double faceOffset(const OrientedBox& box, const OrientedBox& other, Face face);

CaseErrors errorsOf(const Estimate& estimate, const LabelledCluster& sample);

}  // namespace vdamf
