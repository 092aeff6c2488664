// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "types/box_changes.h"
#include "types/box_extent.h"
#include "vdamf/tracking/estimation/assumed_size.h"
#include "vdamf/tracking/estimation/start_state.h"

namespace vdamf
{
namespace
{
constexpr double kReach = 8.0;  // m between centres
// Farther apart only those that stand in line or side by side count: of labelled ones 59 pairs in
// 61 are alike, of the rest, around corners, 21 in 27.
constexpr double kReachInRow = 12.0;          // m
constexpr double kRowHalfWidth = 2.5;         // m
constexpr double kAlike = 0.97;               // of the labelled vehicles with another one in reach
constexpr double kSame = 20.0 * kPi / 180.0;  // rad
// In one lane fronts lie alike: of labelled pairs 667 in 668.
constexpr double kLineHalfWidth = 1.5;  // m
constexpr double kAlikeInLine = 0.99;
constexpr double kAlikeParked = 0.9;

// Of headings of labelled vehicles that stand within reach of each other, two in three differ by
// less than 2.6 degrees, one in ten by more than 10.
constexpr double kHeadingSpread = 0.07 * 0.07;  // rad^2
constexpr double kLeastSpread = 0.04 * 0.04;    // rad^2, of what all around have in common
constexpr double kAskew = 30.0 * kPi / 180.0;   // rad: stands otherwise
constexpr double kSureNeighbour = 2.3;          // log odds, of those that are followed
constexpr double kTurns = 0.1;                  // rad/s: lies so for a moment only
constexpr double kTooDeep = 1.0;                // m, for two vehicles in each other

// Whether what lies so far from a vehicle stands in line with it or beside it.
bool isInRow(const Eigen::Vector2d& off, double heading)
{
    return (rotation(-heading) * off).cwiseAbs().minCoeff() < kRowHalfWidth;
}

// Log odds of something that a share of vehicles have in common, by a neighbour: how likely it is a
// vehicle, and has that itself. Beside anything else it is as likely as not.
double oddsByNeighbour(double vehicle, double own, double share)
{
    const double alike = own * share + (1.0 - own) * (1.0 - share);
    const double p = vehicle * alike + (1.0 - vehicle) * 0.5;
    return std::log(p / (1.0 - p));
}

// Log odds that the front of another vehicle in line lies as one's own: by its way where it was
// seen to drive for long (what stands may seem to move for some frames), else by its shape.
double frontOddsByNeighbour(const HeadingBelief& front, double vehicle)
{
    constexpr double kSure = 1e-3;
    const double ahead = front.forwardProbabilityByCourse();
    if (std::min(ahead, 1.0 - ahead) < kSure) return oddsByNeighbour(vehicle, ahead, kAlikeInLine);
    return oddsByNeighbour(vehicle, front.forwardProbabilityByShape(), kAlikeParked);
}

// Whether two boxes stand in one lane: parallel, and each before or behind the other.
bool areInLine(const OrientedBox& a, const OrientedBox& b)
{
    return std::abs(std::remainder(a.heading - b.heading, kPi)) < kSame &&
           std::abs(toBoxFrame(a, b.centre()).y()) < kLineHalfWidth &&
           std::abs(toBoxFrame(b, a.centre()).y()) < kLineHalfWidth;
}

// Probability of the axes held by what a vehicle itself showed. What others outvoted tells nothing:
// of a row of cars ever the same part of a side shows between two of them, as long as an end.
double axesToFollow(const HeadingBelief& front)
{
    const double own = front.ownAxesProbability();
    return front.axesProbability() > 0.5 ? std::max(0.5, own) : own;
}

// Published, or on its way to it with a vehicle's box whose axes are sure.
bool isKnown(const Track& track)
{
    constexpr int kSightings = 3;
    constexpr double kSureAxes = 0.9;  // probability
    if (track.status == TrackStatus::Ended) return false;
    if (track.status != TrackStatus::Tentative) return true;
    return track.sightingsOfState() >= kSightings && track.front.axesProbability() >= kSureAxes &&
           track.box().length >= kShortestCar;
}

std::vector<PlaneBounds> boundsOf(const std::vector<Track>& tracks)
{
    std::vector<PlaneBounds> bounds;
    for (const Track& track : tracks)
        if (isKnown(track)) bounds.push_back(PlaneBounds::around(track.box().centre(), 0.0));
    return bounds;
}
}  // namespace

Neighbourhood::Neighbourhood(const std::vector<Track>& tracks, const Discriminator& discriminator)
    : index_(boundsOf(tracks))
{
    for (const Track& track : tracks)
    {
        if (!isKnown(track)) continue;
        const double vehicle = discriminator.vehicleProbability(track);
        neighbours_.push_back({track.id, track.box(), track.misses == 0,
                               std::abs(track.state.yawRate()) > kTurns,
                               track.state.covariance(kHeading, kHeading),
                               oddsByNeighbour(vehicle, axesToFollow(track.front), kAlike),
                               frontOddsByNeighbour(track.front, vehicle)});
    }
}

template <class Use>
void Neighbourhood::forEachWithin(double reach, const Eigen::Vector2d& centre, std::uint64_t self,
                                  const Use& use) const
{
    for (const std::size_t k : index_.overlapping(PlaneBounds::around(centre, reach)))
    {
        const Neighbour& other = neighbours_[k];
        if (other.id != self && (other.box.centre() - centre).norm() <= reach) use(other);
    }
}

double Neighbourhood::axesEvidence(const OrientedBox& box, std::uint64_t self) const
{
    double sum = 0.0;
    forEachWithin(
        kReachInRow, box.centre(), self,
        [&](const Neighbour& other)
        {
            const Eigen::Vector2d off = box.centre() - other.box.centre();
            if (other.isTurning || (off.norm() > kReach && !isInRow(off, other.box.heading)))
                return;
            const double turn = std::abs(std::remainder(other.box.heading - box.heading, kPi));
            if (turn < kSame)
                sum += other.logOdds;
            else if (turn > 0.5 * kPi - kSame)
                sum -= other.logOdds;
        });
    return std::clamp(sum, -kMostEvidence, kMostEvidence);
}

double Neighbourhood::frontEvidence(const OrientedBox& box, std::uint64_t self) const
{
    double sum = 0.0;
    forEachWithin(kReachInRow, box.centre(), self,
                  [&](const Neighbour& other)
                  {
                      if (!areInLine(box, other.box)) return;
                      const bool isAlike =
                          std::abs(wrapAngle(other.box.heading - box.heading)) < 0.5 * kPi;
                      sum += isAlike ? other.front : -other.front;
                  });
    return std::clamp(sum, -kMostOfFront, kMostOfFront);
}

bool Neighbourhood::isTaken(const OrientedBox& place, std::uint64_t self) const
{
    bool taken = false;
    forEachWithin(kReach, place.centre(), self,
                  [&](const Neighbour& other)
                  {
                      taken = taken || (other.isInSight && other.logOdds >= kSureNeighbour &&
                                        depthInEachOther(place, other.box) > kTooDeep);
                  });
    return taken;
}

std::optional<HeadingPrior> Neighbourhood::heading(const OrientedBox& box, std::uint64_t self) const
{
    double information = 0.0;
    double turns = 0.0;
    forEachWithin(
        kReach, box.centre(), self,
        [&](const Neighbour& other)
        {
            const double turn = std::remainder(other.box.heading - box.heading, kPi);
            if (other.isTurning || other.logOdds < kSureNeighbour || std::abs(turn) > kAskew)
                return;
            const double each = 1.0 / (kHeadingSpread + other.headingVariance);
            information += each;
            turns += each * turn;
        });
    if (information == 0.0) return std::nullopt;
    return HeadingPrior{box.heading + turns / information,
                        std::max(1.0 / information, kLeastSpread)};
}

namespace
{
constexpr double kSigmasAlike = 2.5;  // beyond which it stands otherwise

// From a box to a heading or its reverse, rad.
double turnTo(const HeadingPrior& prior, const OrientedBox& box)
{
    return std::remainder(prior.heading - box.heading, kPi);
}

bool agree(const HeadingPrior& prior, const OrientedBox& box, double variance, double sigmas)
{
    const double turn = turnTo(prior, box);
    return turn * turn <= sigmas * sigmas * (variance + prior.variance);
}

// The heading by those around a box, where its own of some variance (rad^2) agrees with it.
std::optional<HeadingPrior> headingAlike(const Neighbourhood& around, std::uint64_t self,
                                         const OrientedBox& box, double variance, double sigmas)
{
    const auto prior = around.heading(box, self);
    return prior && agree(*prior, box, variance, sigmas) ? prior : std::nullopt;
}

// What is known to stand alike does so in vague frames too that seem to tell otherwise, as parts of
// round ends do.
std::optional<HeadingPrior> headingAsHeld(const Neighbourhood& around, std::uint64_t self,
                                          const VehicleState& held, const OrientedBox& box,
                                          double variance)
{
    constexpr double kSigmasHeld = 1.5;
    constexpr double kSigmasOnce = 5.0;
    constexpr double kAcross = 0.25 * kPi;  // rad: length and width may be exchanged
    const auto prior =
        headingAlike(around, self, held.box(), held.covariance(kHeading, kHeading), kSigmasHeld);
    const bool isFar = prior && (std::abs(turnTo(*prior, box)) > kAcross ||
                                 !agree(*prior, box, variance, kSigmasOnce));
    return isFar ? std::nullopt : prior;
}
}  // namespace

double placeTaken(const Measurement& measurement, double height, const Eigen::Vector2d& sensor,
                  const Neighbourhood& around, std::uint64_t self, const TrackerOptions& options)
{
    constexpr double kTaken = 6.0;  // more than sizes can say
    const OrientedBox box =
        startState(measurement, height, sensor, {}, options.visibility, options.motion).box();
    return around.isTaken(box, self) ? kTaken : 0.0;
}

Sighting withHeadingOfNeighbours(Sighting sighting, const Neighbourhood& around, std::uint64_t self,
                                 const VehicleState* held)
{
    constexpr double kVague = 1.5 * kPi / 180.0;  // rad: others tell it themselves
    OrientedBox& box = sighting.measurement.box;
    const double variance = sighting.measurement.covariance(2, 2);
    if (variance < kVague * kVague) return sighting;
    auto prior = headingAlike(around, self, box, variance, kSigmasAlike);
    if (!prior && held) prior = headingAsHeld(around, self, *held, box, variance);
    if (!prior) return sighting;
    const double turn = variance / (variance + prior->variance) * turnTo(*prior, box);
    box = turnedAbout(sighting.around.centre(), turn, box);
    return sighting;
}

}  // namespace vdamf
