// SPDX-License-Identifier: BSD-3-Clause
// What filters are learned from and compared on: the hits of one vehicle with its true box.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "vdamf/tracking/matched_filter/filter_bank.h"
#include "vdamf/tracking/matched_filter/measure.h"
#include "vdamf/tracking/types/cluster.h"
#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
struct LabelledCluster
{
    Cluster cluster;                                   ///< m, with height above the ground
    Eigen::Vector2d sensor = Eigen::Vector2d::Zero();  ///< in the frame of the hits, m
    OrientedBox truth;                                 ///< in the frame of the hits
    FaceSet inView;            ///< faces of the true box that hits can tell of, see facesInView()
    OrientedBox start;         ///< the true box, perturbed: what a track would predict
    bool isBody = true;        ///< not upright walls
    double rangeNoise = 0.02;  ///< standard deviation of the sensor's ranges, m
    double truthPlace = 0.0;   ///< and of the errors of the true box: of the place of a face, m ...
    double truthHeading = 0.0;            ///< ... and of its heading, rad
    VehicleType type = VehicleType::Any;  ///< Any: no vehicle, or an unknown one
    double height = 0.0;                  ///< true, m; 0: unknown
    /// Clusters of one group, those of one vehicle, are never split between training and test.
    std::string group;
};

/// Clusters of one kind.
struct LabelledClusters
{
    std::string name;
    std::string description;
    std::vector<LabelledCluster> samples;
};

/// Faces of the true box that the sensor looks at from more than 10 degrees and that at least five
/// hits lie within 0.4 m of, not counting those which are as close to another such face.
FaceSet facesInView(const Cluster& cluster, const OrientedBox& truth,
                    const Eigen::Vector2d& sensor);

/// The options with what is told of the sensor and of what stands there.
MeasureOptions toldOptions(const MeasureOptions& options, const LabelledCluster& sample);

/// A start with Gaussian errors of 0.3 m in x and y, 8 degrees, 0.3 m in length and width; the
/// same for the same seed and index.
OrientedBox perturbed(const OrientedBox& truth, std::uint64_t seed, std::uint64_t index);

}  // namespace vdamf
