// SPDX-License-Identifier: BSD-3-Clause
// Which of the four faces of a box is the vehicle's front: four hypotheses with probabilities.
//
// A box fits as well with front and rear exchanged, and often with length and width exchanged. What
// decides is gathered over frames: the way a vehicle moves, the sizes that ends and sides have, its
// shape, and how the vehicles around it stand. One frame never turns what others told, so that
// headings do not flip.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "vdamf/tracking/estimation/vehicle_sizes.h"

namespace vdamf
{
constexpr double kReverseSpeed = 4.0;  ///< m/s: nobody reverses faster on a road

/// What one frame tells of the front.
struct HeadingCues
{
    double dt = 0.1;  ///< s since the frame before
    /// Straight motion of late, where it is clear: direction from the heading that is held,
    /// counter-clockwise (rad), and speed (m/s).
    struct Course
    {
        double direction = 0.0;
        double speed = 0.0;
    };
    std::optional<Course> course;
    double forth = 0.5;  ///< probability that it moves forward along the heading, not backward
    double fast = 0.0;   ///< probability that it is faster than anybody reverses
    std::optional<FaceExtent> side;  ///< seen, of the box as it is held
    std::optional<FaceExtent> end;   ///< seen, of the box as it is held
    double height = 1.5;             ///< of the vehicle, m
    bool isHeightSeen = false;       ///< it is no higher
    double shape = 0.0;              ///< log odds for the front held, by the vehicle's shape
    double axle = 0.0;  ///< log odds for the front held, by the axle that does not steer, in bends
    double neighbours = 0.0;  ///< log odds for the axes held, by the vehicles around it
    double inLine = 0.0;      ///< log odds for the front held, by the vehicles before and behind it
};

/// Log odds that length and width are as they are held rather than exchanged, by the faces that one
/// frame shows.
double axesEvidence(const HeadingCues& cues);

class HeadingBelief
{
public:
    /// Nothing is known.
    HeadingBelief() = default;
    /// What the first sighting tells.
    explicit HeadingBelief(const HeadingCues& cues);

    HeadingBelief after(const HeadingCues& cues) const;

    /// Counter-clockwise quarter turns from the heading held to the likeliest one, if its log odds
    /// against that held are above `logOdds`; else 0.
    int turnDue(double logOdds) const;

    /// The same belief, told from a heading turned counter-clockwise by quarter turns.
    HeadingBelief turned(int quarters) const;

    /// That the heading points to the front rather than to the rear.
    double forwardProbability() const;
    /// That length and width are not exchanged.
    double axesProbability() const;
    /// The same by what the vehicle itself showed, without its neighbours.
    double ownAxesProbability() const;
    /// Log odds of the same by the vehicles around it alone, in the last frame.
    double axesByNeighbours() const { return neighbours_; }
    /// Frames in a row that left length and width more likely exchanged than not.
    int acrossFor() const { return acrossFor_; }
    /// That the heading points to the front, by the way it moved alone.
    double forwardProbabilityByCourse() const;
    double forwardProbabilityByShape() const;

private:
    std::array<double, 4> logs() const;
    double byAxle(std::size_t k) const;
    void followCourse(const HeadingCues::Course& course, double dt);

    /// By the way it moves: log of the probability that the front lies k quarter turns ahead, but
    /// for a constant.
    std::array<double, 4> course_{};
    /// By the sizes seen: log odds that length and width are not exchanged.
    double axes_ = 0.0;
    /// Rows of hits along the ends or the sides.
    struct Rows
    {
        std::optional<FaceExtent> last;
        /// Of late, that two in a row agree on: shorter ones are parts of it, and for once a row
        /// goes on along what stands beside.
        std::optional<FaceExtent> longest;

        Rows with(const std::optional<FaceExtent>& row, double dt) const;
    };
    Rows ends_, sides_;
    /// By the shape: log odds of the front held.
    double shape_ = 0.0;
    /// By the axle that does not steer: log odds of the front held.
    double axle_ = 0.0;
    /// Log odds of the axes held by the vehicles around it in the last frame.
    double neighbours_ = 0.0;
    /// Log odds of the front held, by the vehicles in line with it in the last frame.
    double inLine_ = 0.0;
    int acrossFor_ = 0;
};

}  // namespace vdamf
