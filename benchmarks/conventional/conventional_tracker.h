// SPDX-License-Identifier: BSD-3-Clause
// What users of LADARs track vehicles with today, to compare with: a box of each cluster, boxes to
// tracks, a filter behind.
//
//  - Ground removal and clusters are this project's own, so that what is compared is what follows.
//  - A box of each cluster by L-shape fitting (closeness; Zhang et al., IV 2017), completed to the
//    size of a car (car_size.h).
//  - Boxes to tracks one to one, by the least sum of distances within gates: 5 m, 60 degrees, the
//    99 % ellipse of the predicted position, an overlap of a tenth.
//  - A bicycle model in an extended Kalman filter (bicycle_filter.h), updated with the corner or
//    face that is nearest to the sensor kept in place; half of each new size is believed.
//  - Published from the third measurement on, ended after a second without; of two tracks on one
//    place the younger one ends.
//
// Written anew from Autoware's multi-object tracker (0.43), with its constants for cars. It has
// besides: classes by a network or a camera, and the merging of clusters by the tracks.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "conventional/bicycle_filter.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
class ConventionalTracker
{
public:
    /// Of the options those of ground, clustering, and of what may start a track.
    explicit ConventionalTracker(const TrackerOptions& options) : options_(options) {}

    /// Frames come in order of time.
    FrameResult process(const LadarFrame& frame);

private:
    struct Detection
    {
        OrientedBox box;  ///< world frame
        int points = 0;
        double groundZ = 0.0, height = 0.0;  ///< m, world and over the ground
        bool mayStart = false;
    };
    struct Track
    {
        std::uint64_t id = 0;
        BicycleFilter filter;
        double length = 0.0, width = 0.0;  ///< m
        Detection last;
        int sightings = 1;
        double lastSeen = 0.0;  ///< s
        bool ended = false;

        OrientedBox box() const;
    };

    std::vector<Detection> detectionsIn(const LadarFrame& frame, FrameResult& result) const;
    std::vector<int> assigned(const std::vector<Detection>& detections) const;
    void endOldAndDouble(double time);
    static void update(Track& track, const Detection& seen, const LadarFrame& frame);
    TrackReport reportOf(const Track& track) const;

    TrackerOptions options_;
    std::vector<Track> tracks_;  ///< by rising id
    std::uint64_t nextId_ = 1;
    double time_ = 0.0;
};

}  // namespace vdamf
