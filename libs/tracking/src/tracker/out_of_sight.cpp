// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/out_of_sight.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vdamf
{
namespace
{
constexpr double kDrives = 2.0;          // m/s
constexpr double kLikelyVehicle = 0.5;   // probability
constexpr double kSureOfFront = 0.9;     // probability
constexpr double kMostTurn = 2.1;        // rad
constexpr double kStraight = 0.1;        // rad, by which a way may lead aside and end as it began
constexpr double kUneven = 0.15;         // of a turn: more of it before or after the middle
constexpr double kChangeOfSpeed = 0.15;  // on the way
constexpr double kAnyway = 1.0;          // m
constexpr double kLonger = 0.3;          // of the length: one of them may be seen in part
constexpr double kSizes = 0.4;           // m

// By rising id, as they are kept: where that one is, or would be.
std::vector<Track>::iterator placeOf(std::uint64_t id, std::vector<Track>& tracks)
{
    return std::lower_bound(tracks.begin(), tracks.end(), id,
                            [](const Track& t, std::uint64_t i) { return t.id < i; });
}

bool isAmong(std::vector<Track>& tracks, std::vector<Track>::iterator place, std::uint64_t id)
{
    return place != tracks.end() && place->id == id;
}

// A bend of one curvature from a heading at one place to another one.
struct Bend
{
    double length = 0.0;  // m
    double turn = 0.0;    // rad
    double skew = 0.0;    // rad, between the way from place to place and that of such a bend
};

Bend bendBetween(const OrientedBox& from, const OrientedBox& to)
{
    const Eigen::Vector2d way = to.centre() - from.centre();
    Bend bend;
    bend.turn = wrapAngle(to.heading - from.heading);
    bend.skew = wrapAngle(std::atan2(way.y(), way.x()) - from.heading - 0.5 * bend.turn);
    const double half = 0.5 * bend.turn;
    bend.length = way.norm() * (std::abs(half) < 1e-3 ? 1.0 : half / std::sin(half));
    return bend;
}

// Nobody was told of it yet, and it is known how it drives.
bool mayHaveComeBack(const Track& track)
{
    return !track.wasPublished && track.status != TrackStatus::Ended && track.misses == 0 &&
           !track.isFaceless && track.judgement.probability > kLikelyVehicle &&
           track.state.mean(kSpeed) > kDrives && track.front.forwardProbability() > kSureOfFront &&
           track.front.axesProbability() > kSureOfFront;
}

// With the track `found` under another identity; its own one ends.
std::vector<Track> withIdentity(std::uint64_t id, std::vector<Track> tracks, std::uint64_t found)
{
    const auto own = placeOf(found, tracks);
    Track back = *own;
    back.id = id;
    back.wasPublished = true;
    own->status = TrackStatus::Ended;
    const auto place = placeOf(id, tracks);
    if (isAmong(tracks, place, id))
        *place = std::move(back);
    else
        tracks.insert(place, std::move(back));
    return tracks;
}
}  // namespace

void OutOfSight::moveBy(const Eigen::Vector3d& by)
{
    for (Departure& gone : gone_)
    {
        gone.box.x += by.x();
        gone.box.y += by.y();
    }
}

void OutOfSight::moveBy(const PlaneMotion& by)
{
    for (Departure& gone : gone_) gone.box = by.of(gone.box);
}

bool OutOfSight::mayBe(const Departure& gone, const Track& found, double time)
{
    const double dt = time - gone.time;
    if (found.firstSeen <= gone.time) return false;
    const Bend bend = bendBetween(gone.box, found.box());
    if (std::abs(bend.turn) > kMostTurn ||
        std::abs(bend.skew) > kStraight + kUneven * std::abs(bend.turn))
        return false;
    const double speedSigma = found.state.speedSigma();
    const double mean = bend.length / dt;
    const auto differs = [&](double speed, double sigma)
    { return std::abs(speed - mean) > kChangeOfSpeed * mean + kAnyway / dt + 2.0 * sigma; };
    if (differs(gone.speed, 0.0) || differs(found.state.mean(kSpeed), speedSigma)) return false;
    return std::abs(found.box().length - gone.box.length) <
               kLonger * std::max(found.box().length, gone.box.length) &&
           std::abs(found.box().width - gone.box.width) < kSizes &&
           std::abs(found.height - gone.height) < kSizes;
}

void OutOfSight::remember(const std::vector<Track>& tracks, double time)
{
    for (const Track& track : tracks)
    {
        if (track.status != TrackStatus::Coasting || track.misses != 1 || track.isFaceless ||
            track.judgement.probability < kLikelyVehicle || track.state.mean(kSpeed) < kDrives)
            continue;
        gone_.push_back({track.id, time, track.box(), track.state.mean(kSpeed), track.height});
    }
}

std::vector<Track> OutOfSight::withReturns(std::vector<Track> tracks, double time)
{
    const auto isBackOrForgotten = [&](const Departure& gone)
    {
        const auto place = placeOf(gone.id, tracks);
        return time - gone.time > longest_ ||
               (isAmong(tracks, place, gone.id) && place->misses <= 1);
    };
    gone_.erase(std::remove_if(gone_.begin(), gone_.end(), isBackOrForgotten), gone_.end());
    remember(tracks, time);

    std::vector<std::pair<std::uint64_t, std::uint64_t>> pairs;  // departed, found
    for (const Track& found : tracks)
    {
        if (!mayHaveComeBack(found)) continue;
        for (const Departure& gone : gone_)
            if (mayBe(gone, found, time)) pairs.emplace_back(gone.id, found.id);
    }
    for (const auto& [gone, found] : pairs)
    {
        const auto isOther = [one = gone, other = found](const auto& pair)
        { return (pair.first == one) != (pair.second == other); };
        if (std::any_of(pairs.begin(), pairs.end(), isOther)) continue;
        tracks = withIdentity(gone, std::move(tracks), found);
    }
    return tracks;
}

}  // namespace vdamf
