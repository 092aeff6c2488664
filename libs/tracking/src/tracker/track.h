// SPDX-License-Identifier: BSD-3-Clause
// A tracked object between frames.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "tracker/shown_heading.h"
#include "tracker/sighting.h"
#include "types/boxed.h"
#include "vdamf/tracking/discrimination/classify.h"
#include "vdamf/tracking/estimation/heading_belief.h"
#include "vdamf/tracking/estimation/jitter.h"
#include "vdamf/tracking/estimation/motion_hypotheses.h"
#include "vdamf/tracking/estimation/start_state.h"
#include "vdamf/tracking/estimation/told_errors.h"
#include "vdamf/tracking/estimation/view.h"
#include "vdamf/tracking/tracker/tracker.h"
#include "vdamf/tracking/types/plane_motion.h"

namespace vdamf
{
/// Where a track was measured.
struct PathPoint
{
    double time = 0.0;
    OrientedBox box;                                 ///< m, rad
    FaceSet located;                                 ///< those whose place the measurement told
    Eigen::Vector2d hits = Eigen::Vector2d::Zero();  ///< middle of their rectangle, m
    double headingVariance = 0.0;                    ///< of the measurement, rad^2
};

/// What the discriminator holds of a track.
struct Judgement
{
    VehicleEvidence evidence;
    double logOdds = 0.0;         ///< by the last frame that it looked at
    double probability = 0.5;     ///< of a vehicle, by all of them
    std::size_t hits = 0;         ///< in that frame
    OrientedBox box;              ///< measured in that frame
    bool hasDriven = false;       ///< as only vehicles do
    std::vector<float> features;  ///< of the current frame, where options ask for them
};

/// All positions are relative to the origin of the frame of its last prediction.
struct Track
{
    static constexpr double kStill = 1.0;  ///< m/s: what is slower may stand

    std::uint64_t id = 0;
    TrackStatus status = TrackStatus::Tentative;
    bool wasPublished = false;  ///< in an earlier frame
    Boxed<MotionHypotheses> hypotheses;
    VehicleState state;  ///< mean of the hypotheses
    JitterShares jitter;
    Eigen::Matrix3d lastingError =
        Eigen::Matrix3d::Zero();                         ///< of the last sighting: x, y, heading
    ToldErrors errors;                                   ///< by the last sighting, as reported
    double viewChanged = 0.0;                            ///< of late, as changeOfView() counts
    Eigen::Vector2d seenFrom = Eigen::Vector2d::Zero();  ///< sensor of the last frame, m
    double groundZ = 0.0;
    double height = 0.0;
    double highest = 0.0;                      ///< roof that two sightings in a row agree on
    double tallest = 0.0;                      ///< of its faces, as two sightings in a row tell, m
    double faceHeight = 0.0;                   ///< by the last sighting, m
    std::optional<AssumedSize> assumedLength;  ///< of what was seen from an end alone
    int busRears = 0;                          ///< sightings of its rear that only a bus shows
    int sightings = 0;
    int startedAt = 1;       ///< sighting at which its state was started, or started anew
    int surprisedAt = 0;     ///< last sighting that was far from what was foretold
    int misses = 0;          ///< frames since the last sighting
    int lastHits = 0;        ///< in the last frame before this one that had some
    double existence = 0.5;  ///< probability that there is an object
    double firstSeen = 0.0;  ///< s
    double lastSeen = 0.0;   ///< s
    double lastMatch = 0.0;  ///< response per hit of the last sighting, 1/m
    HeadingBelief front;
    SizesTold told;
    OrientedBox around;           ///< the hits of the last sighting, in the frame of the box
    std::vector<PathPoint> path;  ///< sightings of the last seconds
    bool isFaceless = false;      ///< tracked by its hits alone, as riders and people are
    Judgement judgement;
    std::optional<ShownHeading> shownHeading;  ///< while it stands
    std::vector<double> typeEvidence;          ///< by filter of the bank, log-likelihoods
    std::optional<TypeProbability> type;
    double stoodProbability = 0.0;  ///< that it did, before the last prediction
    double interval = 0.0;          ///< since the frame before this one, s
    // Of the current frame:
    int hits = 0;
    bool areParts = false;                   ///< the hits: hit at both ends of a revolution
    std::optional<Measurement> measurement;  ///< nothing where it was glanced at, too
    std::optional<double> nis;

    OrientedBox box() const { return state.box(); }
    /// That its state was told by.
    int sightingsOfState() const { return sightings - startedAt + 1; }
    /// It likelier does than not.
    bool stands() const { return hypotheses->standingProbability >= 0.5; }
    /// It likelier did than not, before the last prediction.
    bool stood() const { return stoodProbability >= 0.5; }
    /// It surely moves, forward or backward.
    bool moves() const { return std::abs(state.mean(kSpeed)) - 2.0 * state.speedSigma() > kStill; }
    /// Where its hits should be if it is as large as the last ones were.
    OrientedBox boxOfHits() const;
    Eigen::Vector2d velocity() const  ///< of the centre, world, m/s
    {
        return rotation(state.mean(kHeading)) *
               Eigen::Vector2d(state.mean(kSpeed), state.mean(kAxis) * state.yawRate());
    }
    /// Of the centre along each axis, about, m.
    double positionSigma() const { return std::sqrt(0.5 * boxSigma().squaredNorm()); }
    /// Of the centre along and across the box, m.
    Eigen::Vector2d boxSigma() const
    {
        const Eigen::Matrix2d axes = rotation(state.mean(kHeading));
        const Eigen::Matrix2d position =
            state.covariance.topLeftCorner<2, 2>() + lastingError.topLeftCorner<2, 2>();
        const Eigen::Vector2d variances = (axes.transpose() * position * axes).diagonal();
        return variances.cwiseMax(0.0).cwiseSqrt();
    }
    /// Of the places of its rear and its front along the box, m.
    Eigen::Vector2d endSigma() const
    {
        const Eigen::Vector2d along = rotation(state.mean(kHeading)).col(0);
        const double lasting =
            std::sqrt(std::max(0.0, along.dot(lastingError.topLeftCorner<2, 2>() * along)));
        return {std::hypot(state.faceSigma(0, 0), lasting),
                std::hypot(state.faceSigma(0, 1), lasting)};
    }
    /// Covariance of the place of the centre along the box and the speed, m^2/s.
    double speedCovariance() const
    {
        return rotation(state.mean(kHeading)).col(0).dot(state.covariance.block<2, 1>(kX, kSpeed));
    }
    double lengthSigma() const { return std::sqrt(state.covariance(kLength, kLength)); }
    double widthSigma() const { return std::sqrt(state.widthVariance); }
};

class Neighbourhood;

/// A new track from its first sighting.
Track startedTrack(std::uint64_t id, const Sighting& sighting, const StartSpeed& speed,
                   const TrackerOptions& options);

/// The track after a sighting: visibility correction, Kalman update, heading checks.
Track sightedTrack(Track track, const Sighting& sighting, const Neighbourhood& around,
                   VehicleKalmanFilter& filter, const TrackerOptions& options);

/// What the faces of a measurement, and the rows of hits that the sighting shows along them, tell
/// of the axes of a vehicle of that height (m).
HeadingCues sizeCues(const Sighting& sighting, const Measurement& m, double height);

/// The track with its front where path and sizes say it is: exchanged with the rear or turned by a
/// quarter once the odds for that are high. `sighting` is the one that was just taken in.
Track withCheckedHeading(Track track, const Sighting& sighting, const Neighbourhood& around,
                         const TrackerOptions& options);

/// A box in the frame of another one.
OrientedBox inFrameOf(const OrientedBox& frame, const OrientedBox& box);

/// The track with all positions moved (m), for a frame of another origin. What it has of the last
/// frame stays as it is.
Track movedBy(Track track, const Eigen::Vector3d& by);
/// By a small motion of all that there is; its turn does not matter to covariances.
Track movedBy(Track track, const PlaneMotion& by);

/// The track before anything is seen of it in a frame.
Track withoutSighting(Track track);

/// The track `dt` seconds later, for a frame seen from `sensor`.
Track predictedTrack(Track track, double dt, const Eigen::Vector2d& sensor,
                     VehicleKalmanFilter& filter, const MotionOptions& options);

/// In the world, where the track's origin is at `origin` (m). `extent`: what it covers.
TrackReport reportOf(const Track& track, const OrientedBox& extent,
                     const VisibilityOptions& options, const Eigen::Vector3d& origin);

}  // namespace vdamf
