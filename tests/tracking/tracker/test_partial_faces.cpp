// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/partial_faces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tracking/tracker/rear_seen.h"

namespace vdamf
{
namespace
{
TEST(PartialFaces, APieceOfAnEndTellsLittleOfTheHeading)
{
    Sighting piece = rearSeen(0.6);
    piece.measurement.hiddenEnds.add(Face::Right);
    const Measurement m = withTurnOfPieces(piece);
    EXPECT_NEAR(std::sqrt(m.covariance(2, 2)), 0.395, 0.01) << "a bumper is bowed";
    Sighting trucks = piece;
    trucks.height = 3.0;
    EXPECT_NEAR(std::sqrt(withTurnOfPieces(trucks).covariance(2, 2)), 0.165, 0.01)
        << "a truck's box is not";
    // The piece itself stays where it was seen.
    EXPECT_NEAR(varianceAt(m, 20.05, 0.6), varianceAt(piece.measurement, 20.05, 0.6), 0.002);
    EXPECT_GT(varianceAt(m, 20.0, -0.9), varianceAt(piece.measurement, 20.0, -0.9) + 0.05);
}

TEST(PartialFaces, AnEndNarrowerThanCarsAreIsAPieceWhateverShowsPastIt)
{
    const Sighting narrow = rearSeen(1.2);
    EXPECT_NEAR(std::sqrt(withTurnOfPieces(narrow).covariance(2, 2)), 0.12, 0.002);
    Sighting trucks = narrow;
    trucks.height = 3.0;
    EXPECT_EQ(withTurnOfPieces(trucks).covariance, narrow.measurement.covariance);
}

TEST(PartialFaces, AWholeFaceTellsItAsMeasured)
{
    const Sighting whole = rearSeen(1.8);
    EXPECT_EQ(withTurnOfPieces(whole).covariance, whole.measurement.covariance);
    Sighting withSide = rearSeen(0.6);
    withSide.measurement.hiddenEnds.add(Face::Right);
    withSide.measurement.facesSeen.add(Face::Left);
    withSide.side.metres = 4.2;
    EXPECT_EQ(withTurnOfPieces(withSide).covariance, withSide.measurement.covariance);
}

// With its left side beside the rear, of that many metres.
Sighting rearAndSideSeen(double metres)
{
    Sighting s = rearSeen(1.8);
    s.measurement.facesSeen.add(Face::Left);
    s.measurement.box = {20.0 + 0.5 * metres, 0.0, 0.0, metres, 1.8};
    return s;
}

TEST(PartialFaces, ASideTooShortForACarDoesNotTellItsFarEnd)
{
    EXPECT_TRUE(withoutEndOfShortSide(rearAndSideSeen(3.0)).hiddenEnds.has(Face::Front));
    EXPECT_TRUE(withoutEndOfShortSide(rearAndSideSeen(3.9)).hiddenEnds.empty());
    Sighting many = rearAndSideSeen(3.0);
    many.side.hits = 300.0;
    EXPECT_TRUE(withoutEndOfShortSide(many).hiddenEnds.empty()) << "of a short car";
    for (const double width : {0.8, 2.6})  // ends of a motorcycle, or of a bush
    {
        Sighting other = rearAndSideSeen(3.0);
        other.measurement.box.width = width;
        EXPECT_TRUE(withoutEndOfShortSide(other).hiddenEnds.empty()) << width;
    }
    Sighting cut = rearAndSideSeen(3.0);
    cut.measurement.facesSeen.remove(Face::Back);
    EXPECT_TRUE(withoutEndOfShortSide(cut).hiddenEnds.empty()) << "a side of anything";
}

TEST(PartialFaces, ATruckGoesOnPastTheRowOnItsSide)
{
    // 6 m by the filter, of which two hits behind the rear show the first 2.4 m.
    Sighting truck = rearAndSideSeen(6.0);
    truck.measurement.box.width = 2.5;
    truck.height = 3.0;
    truck.side = {2.4, 5.0, {21.2, 1.25}};
    EXPECT_EQ(toString(withoutEndPastRowOfTruck(truck).hiddenEnds), "F");
    EXPECT_EQ(withoutEndPastRowOfTruck(truck).box.length, 6.0);
    Sighting ahead = truck;
    ahead.sensor = {50.0, 0.0};
    ahead.measurement.facesSeen.remove(Face::Back);
    ahead.measurement.facesSeen.add(Face::Front);
    ahead.side.middle.x() = 24.8;
    EXPECT_EQ(toString(withoutEndPastRowOfTruck(ahead).hiddenEnds), "B");
    Sighting bare = truck;
    bare.side = {};
    EXPECT_EQ(toString(withoutEndPastRowOfTruck(bare).hiddenEnds), "F");

    Sighting whole = truck;
    whole.side = {5.2, 40.0, {22.6, 1.25}};
    EXPECT_TRUE(withoutEndPastRowOfTruck(whole).hiddenEnds.empty()) << "the row reaches its end";
    Sighting car = truck;
    car.measurement.box.width = 1.8;
    EXPECT_TRUE(withoutEndPastRowOfTruck(car).hiddenEnds.empty());
    Sighting low = truck;
    low.height = 1.6;
    EXPECT_TRUE(withoutEndPastRowOfTruck(low).hiddenEnds.empty()) << "a car beside a hedge";
    Sighting side = truck;
    side.measurement.facesSeen.remove(Face::Back);
    EXPECT_TRUE(withoutEndPastRowOfTruck(side).hiddenEnds.empty()) << "a side of anything";
}

TEST(PartialFaces, ASideTooLongForACarEndsAtItsGap)
{
    // The next one's hits begin 1.6 m behind a row of 4 m, and something stands before that gap.
    SegmentedFrame blocked;
    blocked.profile.nearest = {5.0F};
    Sighting both = rearAndSideSeen(5.8);
    both.side = {4.0, 30.0, {22.0, 0.9}};
    const Measurement m = withinRowOfSide(both, blocked);
    EXPECT_NEAR(m.box.length, 4.0, 1e-12);
    EXPECT_NEAR(m.box.x - 0.5 * m.box.length, 20.0, 1e-12);
    EXPECT_EQ(toString(m.hiddenEnds), "F");
    // Seen from ahead, its rear is the far end.
    Sighting ahead = both;
    ahead.sensor = {50.0, 0.0};
    ahead.measurement.facesSeen.remove(Face::Back);
    ahead.measurement.facesSeen.add(Face::Front);
    ahead.side.middle.x() = 23.8;
    EXPECT_EQ(toString(withinRowOfSide(ahead, blocked).hiddenEnds), "B");
    EXPECT_NEAR(withinRowOfSide(ahead, blocked).box.x, 20.0 + 5.8 - 2.0, 1e-12);
    // With its rear hidden too it is where the row is.
    Sighting between = both;
    between.measurement.facesSeen.remove(Face::Back);
    between.measurement.hiddenEnds.add(Face::Back);
    between.measurement = withinRowOfSide(between, blocked);
    const OrientedBox box = withRowsBetweenHiddenEnds(between).box;
    EXPECT_NEAR(box.x, both.measurement.box.x - 0.9, 1e-12);
    EXPECT_NEAR(box.length, 4.0, 1e-12);
    // A truck is open between its axles, and hits are missing on a car.
    Sighting truck = both;
    truck.height = 3.0;
    EXPECT_EQ(withinRowOfSide(truck, blocked).box.length, 5.8);
    Sighting trucks = rearAndSideSeen(16.0);
    trucks.height = 3.0;
    trucks.side = {10.0, 90.0, {25.0, 0.9}};
    EXPECT_NEAR(withinRowOfSide(trucks, blocked).box.length, 10.0, 1e-12);
    Sighting car = rearAndSideSeen(4.6);
    car.side = {3.0, 30.0, {21.5, 0.9}};
    EXPECT_EQ(withinRowOfSide(car, blocked).box.length, 4.6);
    Sighting none = rearAndSideSeen(5.8);
    EXPECT_EQ(withinRowOfSide(none, blocked).box.length, 5.8);
    Sighting whole = rearAndSideSeen(5.8);
    whole.side = {5.6, 30.0, {22.9, 0.9}};
    EXPECT_TRUE(withinRowOfSide(whole, blocked).hiddenEnds.empty());
}

TEST(PartialFaces, TheGapIsWiderThanHitsScatter)
{
    for (const double gap : {0.5, 0.8})
    {
        Sighting both = rearAndSideSeen(5.8);
        both.side = {5.8 - gap, 60.0, {20.0 + 0.5 * (5.8 - gap), 0.9}};
        EXPECT_NEAR(withinRowOfSide(both, {}).box.length, gap < 0.6 ? 5.8 : 5.0, 1e-12) << gap;
    }
}

// Something is found to go on past the near end only after the far one was cut off.
TEST(PartialFaces, TheRowStaysWhereItIsAsTheBoxIsCut)
{
    SegmentedFrame blocked;
    blocked.profile.nearest = {5.0F};
    Sighting both = rearAndSideSeen(5.8);
    both.side = {3.8, 30.0, {22.1, 0.9}};
    both.measurement = withinRowOfSide(both, blocked);
    EXPECT_NEAR(both.measurement.box.x, 22.0, 1e-12);
    both.measurement.facesSeen.remove(Face::Back);
    both.measurement.hiddenEnds.add(Face::Back);
    const OrientedBox box = withRowsBetweenHiddenEnds(both).box;
    EXPECT_NEAR(box.x, 22.1, 1e-12);
    EXPECT_NEAR(box.length, 3.8, 1e-12);
}

TEST(PartialFaces, WhereTheViewThroughTheGapIsFreeTheSideEndsThere)
{
    const SegmentedFrame open;
    Sighting both = rearAndSideSeen(5.8);
    both.side = {4.0, 30.0, {22.0, 0.9}};
    both.measurement.hiddenEnds.add(Face::Front);  // the next one's
    both.sensor = {20.0, -8.0};
    const Measurement m = withinRowOfSide(both, open);
    EXPECT_NEAR(m.box.length, 4.0, 1e-12);
    EXPECT_TRUE(m.hiddenEnds.empty());
    // What stands in the gap, here from 1.2 m past the row on, may be the rest of it.
    SegmentedFrame filled = open;
    filled.profile.nearest = {9.2F};
    EXPECT_EQ(toString(withinRowOfSide(both, filled).hiddenEnds), "F");
    // With its rear hidden it is as far as the row goes, and no farther.
    both.measurement.facesSeen.remove(Face::Back);
    both.measurement.hiddenEnds.add(Face::Back);
    const Measurement front = withinRowOfSide(both, open);
    EXPECT_EQ(toString(front.hiddenEnds), "B");
    EXPECT_NEAR(front.box.x + 0.5 * front.box.length, 24.0, 1e-12);
    // Along a side seen at a grazing angle a gap lies between any two hits.
    both.sensor = {0.0, -1.5};
    EXPECT_TRUE(withinRowOfSide(both, open).hiddenEnds.has(Face::Front));
}

TEST(PartialFaces, BetweenHiddenEndsTheBoxIsAsLongAsTheRow)
{
    Sighting side = rearSeen(0.0);
    Measurement& m = side.measurement;
    m.box.heading = 0.5 * kPi;
    m.facesSeen = FaceSet();
    m.facesSeen.add(Face::Left);
    m.hiddenEnds.add(Face::Front);
    m.hiddenEnds.add(Face::Back);
    side.side = {2.0, 30.0, {21.35, -0.7}};
    const OrientedBox box = withRowsBetweenHiddenEnds(side).box;
    EXPECT_NEAR(box.x, m.box.x, 1e-12);
    EXPECT_NEAR(box.y, m.box.y - 0.7, 1e-12);
    EXPECT_EQ(box.length, 2.0);
    EXPECT_EQ(box.width, m.box.width);
    m.hiddenEnds.remove(Face::Back);
    EXPECT_EQ(withRowsBetweenHiddenEnds(side).box.length, m.box.length);
}

TEST(PartialFaces, FacesAreAsHighAsTheHitsOnThem)
{
    const Measurement m = rearSeen(1.8).measurement;
    Cluster hits = *hitsOnRear(0.5).each;
    const auto seenNow = [&] { return seenAs(hits); };
    const auto height = [&] { return heightOfFaces(m, Eigen::Vector2d::Zero(), seenNow()); };
    EXPECT_NEAR(height(), 0.8, 1e-6);
    // A tree's, over its roof and beside it, and two higher ones that may be anything's.
    const auto add = [&](float x, float y, float z)
    {
        hits.x.push_back(x);
        hits.y.push_back(y);
        hits.height.push_back(z);
    };
    for (int k = 0; k < 5; ++k) add(21.0F + 0.1F * static_cast<float>(k), 0.0F, 2.9F);
    for (int k = 0; k < 5; ++k) add(20.0F, 1.2F + 0.1F * static_cast<float>(k), 2.9F);
    for (int k = 0; k < 2; ++k) add(20.0F, 0.0F, 2.9F);
    EXPECT_NEAR(height(), 0.8, 1e-6);
    add(20.1F, 0.3F, 2.8F);
    EXPECT_NEAR(height(), 2.8, 1e-6);
    HitsAtOneTime level = seenNow();
    Hits projected = projectHits(hits, 0.0);
    projected.heights = 0;
    level.hits = projected;
    EXPECT_EQ(heightOfFaces(m, Eigen::Vector2d::Zero(), level), 0.0);
}

}  // namespace
}  // namespace vdamf
