// SPDX-License-Identifier: BSD-3-Clause
// Fig. 2 as a whole: a frame of LADAR data in, tracked objects out.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "vdamf/tracking/association/auction.h"
#include "vdamf/tracking/discrimination/options.h"
#include "vdamf/tracking/estimation/platform_errors.h"
#include "vdamf/tracking/estimation/variable_axis_model.h"
#include "vdamf/tracking/estimation/visibility.h"
#include "vdamf/tracking/matched_filter/measure.h"
#include "vdamf/tracking/preprocessing/clustering.h"
#include "vdamf/tracking/preprocessing/ground.h"
#include "vdamf/tracking/types/point_cloud.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
struct LifecycleOptions
{
    int minHits = 10;
    double minHeight = 0.4;   ///< m
    double maxExtent = 30.0;  ///< m
    int confirmHits = 3;
    double confirmAxes = 0.9;
    double confirmSpeedSigma = 1.5;  ///< m/s
    double hitProbability = 0.7;
    double endProbability = 0.1;
    double maxCoast = 8.0;          ///< s
    double startSpeedSigma = 16.0;  ///< m/s
    double nisGate = 11.34;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.minHits, "min_hits", 3, 1000, "least hits of a cluster that starts a track");
        field(self.minHeight, "min_height_m", 0.0, 3.0,
              "least height of a cluster that starts a track, where heights are known");
        field(self.maxExtent, "max_extent_m", 3.0, 60.0,
              "largest diagonal of a cluster that starts a track");
        field(self.confirmHits, "confirm_hits", 1, 50,
              "measured frames that confirm a track; one fewer of what surely is a vehicle and "
              "stands or has a known speed, thirty more of what may be one and is shorter than any "
              "car");
        field(
            self.confirmAxes, "confirm_axes_probability", 0.0, 0.99,
            "that length and width are not exchanged, nor front and rear of what may be moving, "
            "from which a track is confirmed then; where the former may be, it waits for ten more "
            "measured frames, of few hits for thirty, for the front for four");
        field(self.confirmSpeedSigma, "confirm_speed_sigma_mps", 0.1, 40.0,
              "standard deviation of a track's speed up to which it is confirmed then; one that is "
              "known less, or of few hits that may stand or drive, waits for four more");
        field(self.hitProbability, "hit_probability", 0.1, 0.99,
              "that an object in full view has hits: each frame in which the sensor sees through "
              "where it ought to be speaks against it; hidden behind something nearer it is not "
              "missed");
        field(self.endProbability, "end_probability", 0.001, 0.5,
              "probability that an object is there below which its track ends; a new track's is "
              "0.5, most is 0.99");
        field(self.maxCoast, "max_coast_s", 0.0, 60.0,
              "time without hits that ends a track, hidden or not, and within which what turned "
              "out of sight is known again");
        field(self.startSpeedSigma, "start_speed_sigma_mps", 0.1, 40.0,
              "standard deviation of a new track's speed");
        field(self.nisGate, "nis_gate", 1.0, 1000.0,
              "chi-square value with 3 degrees of freedom above which a measurement counts less "
              "(11.34: 99 %)");
    }
};

struct ExecutionOptions
{
    int threads = 1;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.threads, "threads", 0, 256,
              "threads that measure and update tracks; 0: one for each processor; the results are "
              "the same");
    }
};

struct TrackerOptions
{
    GroundOptions ground;
    ClusterOptions clustering;
    AssociationOptions association;
    MeasureOptions measurement;
    VisibilityOptions visibility;
    MotionOptions motion;
    AlignmentOptions alignment;
    LifecycleOptions lifecycle;
    ExecutionOptions execution;
    DiscriminatorOptions discriminator;

    /// All problems, each with its section: "[clustering] gap_m = ...". Empty: valid.
    std::vector<std::string> problems() const;
};

/// Stages of the frame function, in order: for timing.
enum class Stage
{
    Ground,
    Clustering,
    Prediction,
    Association,
    Measurement,
    Update,
    NewTracks,
    Discrimination
};
const char* toString(Stage stage);

/// Tracks all objects of vehicle size, vehicles or not (section 2). Pure: no clock, no file, no
/// randomness; the same frames give the same results, to the bit and with any number of threads.
class Tracker
{
public:
    /// Throws std::invalid_argument that lists the problems of bad options.
    explicit Tracker(const TrackerOptions& options);
    ~Tracker();
    Tracker(Tracker&&) noexcept;
    Tracker& operator=(Tracker&&) noexcept;

    /// Takes the next frame. Frames come in order of time; one that is not later than its
    /// predecessor, whose time, origin or sensor is not finite, whose arrays differ in length or
    /// whose points have times beyond 10 s, throws std::invalid_argument and changes nothing. After
    /// anything else that is thrown (by an observer, say) all tracks are gone, without a report of
    /// their ends, and begin anew with the next frame.
    /// Over more than [lifecycle] max_coast_s and 2 s between frames all tracks
    /// end: the later one reports them as they were.
    FrameResult process(const LadarFrame& frame);

    /// Called as each stage begins and, with nullptr, after the last one.
    void onStage(std::function<void(const Stage*)> observer);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vdamf
