// SPDX-License-Identifier: BSD-3-Clause
// From the clusters of a frame to what they say of one target.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "types/lent.h"
#include "types/time_range.h"
#include "vdamf/tracking/matched_filter/measure.h"
#include "vdamf/tracking/types/cluster.h"
#include "vdamf/tracking/types/measurement.h"
#include "vdamf/tracking/types/point_cloud.h"
#include "vdamf/tracking/types/range_profile.h"

namespace vdamf
{
/// A frame behind the segmentation. All positions are relative to the frame's origin.
struct SegmentedFrame
{
    double time = 0.0;                                 ///< s
    Eigen::Vector2d sensor = Eigen::Vector2d::Zero();  ///< m
    double sensorZ = 0.0;                              ///< m
    std::size_t points = 0;
    std::size_t pointsAboveGround = 0;
    bool planar = false;
    TimeRange times;  ///< of all points, s after `time`
    RangeProfile profile;
    std::vector<Cluster> clusters;
    Cluster loose;                ///< hits in no cluster
    std::vector<Hits> hits;       ///< of each cluster
    std::vector<bool> isVehicle;  ///< what was found to be one of each of the first clusters
};

/// Hits as they lay together at one time. Of a single cluster without times they are the frame's.
struct HitsAtOneTime
{
    Lent<Hits> hits;
    Lent<Cluster> each;  ///< the same one by one, with heights; z is not told
    double lag = 0.0;    ///< s after the frame's time
    /// Middle of the part that was left out, in the frame of the hits, m: towards it the target
    /// goes on.
    std::optional<Eigen::Vector2d> goesOn;
    /// By which parts that were hit a revolution apart may be turned against each other when put
    /// together, rad.
    double turnSigma = 0.0;
    bool areParts = false;  ///< hit at both ends of a revolution
    bool isCut = false;     ///< what went on past an end of a face is left out
};

/// Hits in a row along a face lie so far before and behind it, where it is round, m.
constexpr double kInFrontOfFace = 0.25;
constexpr double kBehindFace = 0.45;

/// Hits that go on along a face without a wide gap.
struct FaceRow
{
    double metres = 0.0;  ///< from the first to the last
    double hits = 0.0;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< of the first and the last hit, m
};

/// Hits of one target in one frame, and what they measured, relative to the frame's origin.
struct Sighting
{
    double time = 0.0;                                 ///< of the frame, s
    double lag = 0.0;                                  ///< of the hits after it, s
    Eigen::Vector2d sensor = Eigen::Vector2d::Zero();  ///< m
    std::vector<std::size_t> clusters;                 ///< of the frame, whose hits they are
    Measurement measurement;
    OrientedBox around;  ///< the hits, along and across the box
    /// Of the hits that lie on a face seen, all but the two highest, above the ground, m; 0 where
    /// heights are not known. Trees over a car have none there.
    double faceHeight = 0.0;
    FaceRow side, end;            ///< of the faces towards the sensor
    double groundZ = 0.0;         ///< local ground, m
    double height = 0.0;          ///< of the highest hit above it, m
    double overHits = 0.0;        ///< what is likely to be above that, between two rows of hits, m
    double endAboveBumper = 0.0;  ///< of the lowest hits on its end, m; 0 where nothing tells
    bool isRoofSeen = false;      ///< rays pass closely over the highest hit
    bool areParts = false;        ///< hit at both ends of a revolution
    bool isCut = false;           ///< as of its hits
    /// Log odds, by the shape, that the front lies where the measurement's heading points.
    double front = 0.0;
    bool isBusEnd = false;  ///< the end seen is closed as a bus's is
};

/// The same hits, with the heading of the box counter-clockwise by quarter turns: the front lies
/// elsewhere. After an odd number the side is the end, whose shape is not known.
Sighting turnedBy(Sighting sighting, int quarters);

/// Height of the highest hit above the local ground, m.
double heightOf(const Cluster& cluster);

/// The hits of a cluster projected. A level scan line (`planar`) measures no heights: those of its
/// hits are assumed.
Hits projected(const Cluster& cluster, double mergeCell, bool planar);

/// The hits of some of the frame's clusters together; of a single one, the frame's.
Lent<Hits> hitsOf(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters);

/// The smallest rectangle of a heading with all hits.
OrientedBox rectangleAround(const Hits& hits, double heading);

/// The row of hits along the face of a box that lies towards the sensor across `axis` (0: length,
/// so an end; 1: width, a side).
FaceRow rowAlongFace(const Hits& hits, const OrientedBox& box, const Eigen::Vector2d& sensor,
                     int axis);

/// The measurement of a target that goes on towards a point (m, same frame) that it does not show:
/// its end or side there is hidden.
Measurement goingOnTowards(const Measurement& measurement, const Eigen::Vector2d& point);

/// How closely hits are looked at.
struct Attention
{
    SearchEffort search;
    /// Nothing is asked for that only vehicles have.
    bool isPlaceEnough = false;
};

/// Measures the hits of some clusters from a start.
Sighting sightingOf(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters,
                    const HitsAtOneTime& seen, const OrientedBox& start,
                    const std::optional<Eigen::Vector2d>& knownLengthWidth,
                    const MeasureOptions& options, const Attention& attention = {});

}  // namespace vdamf
