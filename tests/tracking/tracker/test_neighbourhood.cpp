// SPDX-License-Identifier: BSD-3-Clause
// What vehicles around tell of the axes of one.
#include "tracker/neighbourhood.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
constexpr std::uint64_t kSelf = 99;

Track parkedAt(std::uint64_t id, double x, double y, double heading)
{
    HeadingCues whole;
    whole.end = {1.8, 0.9};
    whole.side = {4.3, 0.9};
    Track track;
    track.id = id;
    track.status = TrackStatus::Confirmed;
    track.state.mean << x, y, heading, 0.0, 0.0, 1.2, 4.3;
    track.state.width = 1.8;
    track.front = HeadingBelief(whole);
    return track;
}

double evidence(const std::vector<Track>& tracks, const OrientedBox& box)
{
    DiscriminatorOptions off;
    off.model = "none";
    return Neighbourhood(tracks, Discriminator(off)).axesEvidence(box, kSelf);
}

TEST(Neighbourhood, VehiclesAroundSpeakForAxesAlongTheirs)
{
    const std::vector<Track> one{parkedAt(1, 6.0, 0.0, 0.3)};
    EXPECT_GT(evidence(one, {0, 0, 0.25, 4.3, 1.8}), 0.5);
    EXPECT_DOUBLE_EQ(evidence(one, {0, 0, 0.25 + kPi, 4.3, 1.8}),
                     evidence(one, {0, 0, 0.25, 4.3, 1.8}));
    EXPECT_DOUBLE_EQ(evidence(one, {0, 0, 0.25 + 0.5 * kPi, 4.3, 1.8}),
                     -evidence(one, {0, 0, 0.25, 4.3, 1.8}));
    EXPECT_EQ(evidence(one, {0, 0, 0.3 + 0.25 * kPi, 4.3, 1.8}), 0.0) << "askew";
    EXPECT_EQ(evidence(one, {-4, 0, 0.3, 4.3, 1.8}), 0.0) << "far away";
}

TEST(Neighbourhood, InLineAndSideBySideItReachesFarther)
{
    const std::vector<Track> one{parkedAt(1, 0.0, 0.0, 0.0)};
    EXPECT_GT(evidence(one, {10.5, 1.0, 0.0, 4.3, 1.8}), 0.5) << "in line";
    EXPECT_GT(evidence(one, {-1.0, -10.5, 0.0, 4.3, 1.8}), 0.5) << "beside";
    EXPECT_EQ(evidence(one, {8.0, 7.0, 0.0, 4.3, 1.8}), 0.0) << "around a corner";
    EXPECT_EQ(evidence(one, {13.0, 0.0, 0.0, 4.3, 1.8}), 0.0) << "far away";
}

TEST(Neighbourhood, WhoDroveTellsTheFrontOfWhatIsInLine)
{
    Track drove = parkedAt(1, 7.0, 0.0, 0.0);
    HeadingCues course;
    course.course = {0.0, 6.0};
    for (int k = 0; k < 6; ++k) drove.front = drove.front.after(course);
    DiscriminatorOptions always;
    always.model = "none";
    drove.judgement.probability = 1.0;
    const auto front = [&](const Track& track, const OrientedBox& box)
    { return Neighbourhood({track}, Discriminator(always)).frontEvidence(box, kSelf); };
    EXPECT_GT(front(drove, {0, 0.5, 0.1, 4.3, 1.8}), 3.0);
    EXPECT_LE(front(drove, {0, 0.5, 0.1, 4.3, 1.8}), Neighbourhood::kMostOfFront);
    EXPECT_LT(front(drove, {0, 0.5, 0.1 - kPi, 4.3, 1.8}), -3.0);
    EXPECT_EQ(front(drove, {0, 3.0, 0.0, 4.3, 1.8}), 0.0) << "in the next lane";
    EXPECT_EQ(front(drove, {0, 0.0, 0.5 * kPi, 4.3, 1.8}), 0.0) << "across";
    EXPECT_EQ(front(drove, {-6, 0.0, 0.0, 4.3, 1.8}), 0.0) << "far away";
    EXPECT_NEAR(front(parkedAt(1, 7.0, 0.0, 0.0), {0, 0.0, 0.0, 4.3, 1.8}), 0.0, 1e-12)
        << "knows its own no better";
    Track seemed = parkedAt(1, 7.0, 0.0, 0.0);
    HeadingCues forth;
    forth.forth = 0.99;
    seemed.front = seemed.front.after(forth);
    EXPECT_GT(seemed.front.forwardProbabilityByCourse(), 0.9);
    EXPECT_NEAR(front(seemed, {0, 0.0, 0.0, 4.3, 1.8}), 0.0, 1e-12) << "it may have seemed so";
    Track shown = parkedAt(1, 7.0, 0.0, 0.0);
    HeadingCues shape;
    shape.shape = 2.5;
    for (int k = 0; k < 6; ++k) shown.front = shown.front.after(shape);
    shown.judgement.probability = 1.0;
    const double byShape = front(shown, {0, 0.0, 0.0, 4.3, 1.8});
    EXPECT_GT(byShape, 1.5);
    EXPECT_LT(byShape, front(drove, {0, 0.0, 0.0, 4.3, 1.8})) << "who parks may turn around";
}

TEST(Neighbourhood, ManySayMoreThanOneWithinBounds)
{
    std::vector<Track> row;
    for (int k = 1; k <= 6; ++k) row.push_back(parkedAt(std::uint64_t(k), 0.0, 1.2 * k, 0.0));
    const OrientedBox box{0, 0, 0.0, 4.3, 1.8};
    EXPECT_GT(evidence(row, box), evidence({row.front()}, box));
    EXPECT_LE(evidence(row, box), 3.0);
}

TEST(Neighbourhood, WhatIsSeenWholeIsBelievedMoreThanAllAroundIt)
{
    HeadingCues across;
    across.side = FaceExtent{1.8, 0.9};
    across.end = FaceExtent{4.3, 0.9};
    across.neighbours = Neighbourhood::kMostEvidence;
    HeadingBelief belief;
    for (int k = 0; k < 5; ++k) belief = belief.after(across);
    constexpr double kLikelier = 0.5;  // log odds
    EXPECT_EQ(belief.turnDue(kLikelier) % 2, 1);
}

TEST(Neighbourhood, ATrackIsNoNeighbourOfItselfNorIsWhatHasJustBegun)
{
    Track self = parkedAt(kSelf, 1.0, 0.0, 0.0);
    Track tentative = parkedAt(1, 1.0, 0.0, 0.0);
    tentative.status = TrackStatus::Tentative;
    EXPECT_EQ(evidence({self, tentative}, {0, 0, 0, 4.3, 1.8}), 0.0);
}

TEST(Neighbourhood, WhoIsNotPublishedYetSpeaksOnceItsAxesAreKnown)
{
    Track waiting = parkedAt(1, 6.0, 0.0, 0.0);
    waiting.status = TrackStatus::Tentative;
    waiting.sightings = 3;
    EXPECT_GT(evidence({waiting}, {0, 0, 0, 4.3, 1.8}), 0.5);
    Track vague = waiting;
    vague.front = HeadingBelief();
    EXPECT_EQ(evidence({vague}, {0, 0, 0, 4.3, 1.8}), 0.0);
    Track piece = waiting;
    piece.state.mean(kLength) = 1.5;
    EXPECT_EQ(evidence({piece}, {0, 0, 0, 4.3, 1.8}), 0.0);
    waiting.sightings = 2;
    EXPECT_EQ(evidence({waiting}, {0, 0, 0, 4.3, 1.8}), 0.0);
}

TEST(Neighbourhood, WhoKnowsNothingOfItsOwnAxesSaysNothing)
{
    Track vague = parkedAt(1, 5.0, 0.0, 0.0);
    vague.front = HeadingBelief();
    HeadingCues told;
    told.neighbours = 3.0;  // by others, in their turn
    vague.front = vague.front.after(told);
    EXPECT_NEAR(evidence({vague}, {0, 0, 0, 4.3, 1.8}), 0.0, 1e-12);
}

// Between two parked cars a piece of the next one's side shows, as long as an end.
TEST(Neighbourhood, WhatItsNeighboursOutvotedTellsOthersNothing)
{
    HeadingCues piece;
    piece.side = FaceExtent{1.3, 0.12};
    Track parked = parkedAt(1, 0.0, 2.7, 0.0);
    parked.front = HeadingBelief();
    for (int k = 0; k < 10; ++k) parked.front = parked.front.after(piece);
    ASSERT_LT(parked.front.axesProbability(), 0.3);
    EXPECT_LT(evidence({parked}, {0, 0, 0, 4.3, 1.8}), -0.5) << "it may lie across";
    piece.neighbours = Neighbourhood::kMostEvidence;
    parked.front = parked.front.after(piece);
    ASSERT_GT(parked.front.axesProbability(), 0.5);
    EXPECT_NEAR(evidence({parked}, {0, 0, 0, 4.3, 1.8}), 0.0, 1e-12);
}

Track surelyParkedAt(std::uint64_t id, double x, double y, double heading)
{
    Track track = parkedAt(id, x, y, heading);
    track.judgement.probability = 1.0;
    track.state.covariance(kHeading, kHeading) = 1e-4;
    return track;
}

Neighbourhood around(const std::vector<Track>& tracks)
{
    return Neighbourhood(tracks, Discriminator({}));
}

TEST(Neighbourhood, HeadingIsThatOfTheVehiclesAround)
{
    const auto row = around({surelyParkedAt(1, 0.0, 2.5, 0.02), surelyParkedAt(2, 0.0, -2.5, 0.04),
                             surelyParkedAt(3, 30.0, 0.0, 0.3)});
    const OrientedBox box{0, 0, 0.2, 4.3, 1.8};
    const auto prior = row.heading(box, kSelf);
    ASSERT_TRUE(prior);
    EXPECT_NEAR(prior->heading, 0.03, 1e-9);
    EXPECT_GT(prior->variance, 1e-3);
    EXPECT_NEAR(row.heading(box, 1)->heading, 0.04, 1e-9) << "nobody is beside itself";
    EXPECT_NEAR(row.heading({0, 0, 0.2 + kPi, 4.3, 1.8}, kSelf)->heading, 0.03 + kPi, 1e-9);
    EXPECT_FALSE(row.heading({0, 0, 1.0, 4.3, 1.8}, kSelf)) << "stands otherwise";
    EXPECT_FALSE(row.heading({0, 30, 0.2, 4.3, 1.8}, kSelf)) << "nobody near";
}

TEST(Neighbourhood, WhatTurnsTellsNothing)
{
    const OrientedBox box{0, 0, 0.25, 4.3, 1.8};
    Track turning = surelyParkedAt(1, 6.0, 0.0, 0.3);
    turning.state.mean(kSpeed) = 5.0;
    ASSERT_GT(around({turning}).axesEvidence(box, kSelf), 0.5) << "drives straight on";
    ASSERT_TRUE(around({turning}).heading(box, kSelf));
    turning.state.mean(kCurvature) = 0.05;
    EXPECT_EQ(around({turning}).axesEvidence(box, kSelf), 0.0);
    EXPECT_FALSE(around({turning}).heading(box, kSelf));
    EXPECT_TRUE(around({turning}).isTaken(turning.box(), kSelf)) << "is there all the same";
}

TEST(Neighbourhood, WhatMayBeNoVehicleTellsNoHeading)
{
    Track shrub = surelyParkedAt(1, 0.0, 2.5, 0.0);
    shrub.judgement.probability = 0.6;
    EXPECT_FALSE(around({shrub}).heading({0, 0, 0.1, 4.3, 1.8}, kSelf));
}

// Hits on a piece of an end at the front of a car, whose heading is off.
Sighting seenInPart(double off, double sigma)
{
    Sighting sighting;
    sighting.measurement.box = {0, 0, off, 4.0, 1.8};
    sighting.measurement.covariance = 0.01 * Matrix5d::Identity();
    sighting.measurement.covariance(2, 2) = sigma * sigma;
    sighting.around = {2.0, 0.0, off, 0.1, 0.6};
    return sighting;
}

TEST(Neighbourhood, NoVehicleStandsInAnother)
{
    const std::vector<Track> car{surelyParkedAt(1, 0.0, 3.0, 0.0)};
    const OrientedBox along{0, 0, 0, 4.3, 1.8};
    const OrientedBox across{0, 1.5, 0.5 * kPi, 4.3, 1.8};
    EXPECT_FALSE(around(car).isTaken(along, kSelf)) << "beside it";
    EXPECT_TRUE(around(car).isTaken(across, kSelf));
    EXPECT_FALSE(around(car).isTaken(across, 1)) << "itself";
    EXPECT_FALSE(around(car).isTaken({0, -0.6, 0.5 * kPi, 4.3, 1.8}, kSelf))
        << "by less than lengths that are assumed may err";
    Track hidden = car.front();
    hidden.misses = 1;
    EXPECT_FALSE(around({hidden}).isTaken(across, kSelf)) << "it may have gone";
    Track shrub = car.front();
    shrub.judgement.probability = 0.6;
    EXPECT_FALSE(around({shrub}).isTaken(across, kSelf));
}

TEST(HeadingOfNeighbours, TurnsWhatIsVagueAboutItsHits)
{
    const auto row = around({surelyParkedAt(1, 0.0, 2.5, 0.0), surelyParkedAt(2, 0.0, -2.5, 0.0)});
    const Sighting seen = seenInPart(0.25, 0.17);
    const Sighting turned = withHeadingOfNeighbours(seen, row, kSelf);
    const OrientedBox& box = turned.measurement.box;
    EXPECT_LT(std::abs(box.heading), 0.1 * 0.25 + 0.02);
    const double turn = 0.25 - box.heading;
    EXPECT_NEAR(box.x, 2.0 - 2.0 * std::cos(turn), 1e-9) << "the hits stay where they are";
    EXPECT_NEAR(box.y, 2.0 * std::sin(turn), 1e-9);
    EXPECT_EQ(turned.measurement.covariance, seen.measurement.covariance);
}

TEST(HeadingOfNeighbours, KeepsWhatIsKnownToStandAlikeInFramesThatTellOtherwise)
{
    const auto row = around({surelyParkedAt(1, 0.0, 2.5, 0.0)});
    VehicleState held = surelyParkedAt(kSelf, 0.02, 0.0, 0.0).state;
    held.covariance(kHeading, kHeading) = 0.05 * 0.05;
    const auto headingOf = [&](double off, double sigma)
    {
        return withHeadingOfNeighbours(seenInPart(off, sigma), row, kSelf, &held)
            .measurement.box.heading;
    };
    EXPECT_LT(headingOf(0.6, 0.17), 0.1) << "by a part of an end, 34 degrees off";
    EXPECT_EQ(headingOf(0.6, 0.05), 0.6) << "by far more than it may err";
    EXPECT_EQ(headingOf(1.5, 0.35), 1.5) << "length and width may be exchanged";
    held.mean(kHeading) = 0.4;
    EXPECT_EQ(headingOf(0.6, 0.17), 0.6) << "known to stand otherwise";
}

TEST(HeadingOfNeighbours, LeavesWhatIsKnownBetterOrStandsOtherwise)
{
    const auto row = around({surelyParkedAt(1, 0.0, 2.5, 0.0)});
    const auto headingOf = [&](double off, double sigma)
    { return withHeadingOfNeighbours(seenInPart(off, sigma), row, kSelf).measurement.box.heading; };
    EXPECT_EQ(headingOf(0.1, 0.01), 0.1) << "it tells its heading itself";
    EXPECT_EQ(headingOf(0.4, 0.05), 0.4) << "by far more than both may err";
    EXPECT_EQ(headingOf(0.8, 0.3), 0.8) << "askew";
    EXPECT_LT(headingOf(0.1, 0.1), 0.06);
}

TEST(RowAlongFace, EndsAtAGapAndLeavesOutWhatLiesBehindTheFace)
{
    Hits hits;
    const auto add = [&](double x, double y)
    {
        hits.x.push_back(x);
        hits.y.push_back(y);
        hits.weight.push_back(1.0);
        hits.totalWeight += 1.0;
    };
    for (int k = 0; k <= 20; ++k) add(8.0, -0.8 + 0.08 * k);  // the end
    for (int k = 0; k < 5; ++k) add(8.1, 2.6 + 0.1 * k);      // something beside it
    for (int k = 0; k < 30; ++k) add(11.0 + 0.1 * k, 0.9);    // through the windows
    const OrientedBox box{10.15, 0.0, 0.0, 4.3, 1.8};
    const FaceRow end = rowAlongFace(hits, box, {0.0, 0.0}, 0);
    EXPECT_NEAR(end.metres, 1.6, 1e-9);
    EXPECT_EQ(end.hits, 21.0);
}
}  // namespace
}  // namespace vdamf
