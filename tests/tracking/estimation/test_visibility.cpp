// SPDX-License-Identifier: BSD-3-Clause
// Visibility corrections of section 4.5.
#include "vdamf/tracking/estimation/visibility.h"

#include <gtest/gtest.h>

#include <random>

#include "tracking/estimation/measured_vehicles.h"
#include "vdamf/tracking/estimation/start_state.h"
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

namespace vdamf
{
namespace
{
TEST(NearestPoint, IsACornerOrAFacePoint)
{
    const OrientedBox box{10.0, 0.0, 0.0, 4.0, 2.0};
    EXPECT_EQ(nearestPoint(box, {0.0, 5.0}), Eigen::Vector2d(-1.0, 1.0));
    EXPECT_EQ(nearestPoint(box, {0.0, 0.0}), Eigen::Vector2d(-1.0, 0.0));
    EXPECT_EQ(nearestPoint(box, {11.0, -9.0}), Eigen::Vector2d(0.5, -1.0));
}

TEST(LocatedFaces, AreTheEndsOfRowsToo)
{
    Measurement m = measured({10, 3, 0, 4.5, 1.8}, faces({Face::Right}));
    EXPECT_EQ(toString(locatedFaces(m)), "FBR");
    m.hiddenEnds.add(Face::Front);
    EXPECT_EQ(toString(locatedFaces(m)), "BR");
    m.facesSeen = faces({Face::Back});
    EXPECT_EQ(toString(locatedFaces(m)), "BLR");
}

TEST(LocatedFaces, OfUpperPartsTellNoSize)
{
    Measurement m;
    m.facesSeen.add(Face::Left);
    m.upperEnds.add(Face::Front);
    EXPECT_EQ(toString(locatedFaces(m)), "FBL");
    EXPECT_FALSE(locatesLength(m));
    m.upperEnds = FaceSet();
    EXPECT_TRUE(locatesLength(m));
    m.facesSeen.add(Face::Back);
    EXPECT_TRUE(locatesWidth(m));
    m.upperEnds.add(Face::Right);
    EXPECT_FALSE(locatesWidth(m));
    EXPECT_TRUE(locatesLength(m));
}

TEST(BoxThrough, KeepsTheFaceThatIsToldWhereTheOtherIsNot)
{
    // The rear is seen; of the length nothing is.
    const double heading = 0.3;
    const Eigen::Vector2d rear(8.0, 3.0);
    const Eigen::Vector2d seen = rear + rotation(heading) * Eigen::Vector2d(0.5, 0.0);
    const Measurement m = measured({seen.x(), seen.y(), heading, 1.0, 1.8}, faces({Face::Back}));
    const VisibilityOptions options;
    const BoxMeasurement box = boxThrough(m, faceErrors(m, options), {4.5, 1.7}, {0, 0}, options);
    const Eigen::Vector2d expected = rear + rotation(heading) * Eigen::Vector2d(2.25, 0.0);
    EXPECT_LT((box.box.head<2>() - expected).norm(), 1e-12);
    EXPECT_EQ(box.box(3), 4.5);
    EXPECT_EQ(box.box(4), 1.8);  // both ends of the rear are told
    EXPECT_EQ(box.fixedPoint.x(), -1.0);
    // Length and centre are open, the rear is not.
    EXPECT_GT(box.covariance(3, 3), 50.0);
    Vector5d rearFace;
    rearFace << rotation(heading).col(0), 0.0, -0.5, 0.0;
    EXPECT_LT(rearFace.dot(box.covariance * rearFace), 0.05);
}

TEST(BoxThrough, CovarianceEqualsMonteCarlo)
{
    VisibilityOptions options;
    options.positionFloor = options.headingFloor = options.sizeSigma = 0.0;
    options.endOnlyHeadingFloor = 0.0;
    const OrientedBox box{9.0, 4.0, 0.9, 3.0, 1.6};
    Measurement m = measured(box, faces({Face::Back, Face::Right}));
    Matrix5d root = Matrix5d::Zero();
    root << 0.03, 0, 0, 0, 0, 0.01, 0.02, 0, 0, 0, 0.004, -0.003, 0.01, 0, 0, 0.05, 0.01, 0, 0.04,
        0, -0.01, 0.03, 0, 0.01, 0.03;
    m.covariance = root * root.transpose();
    m.hiddenEnds.add(Face::Front);
    const FaceErrors errors = faceErrors(m, options);
    const BoxMeasurement result = boxThrough(m, errors, {4.5, 1.8}, {0, 0}, options);
    std::mt19937_64 generator(3);
    std::normal_distribution<double> gauss;
    Matrix5d sum = Matrix5d::Zero();
    const int runs = 20000;
    for (int k = 0; k < runs; ++k)
    {
        Vector5d u;
        for (int i = 0; i < 5; ++i) u(i) = gauss(generator);
        const Vector5d e = root * u;
        Measurement s = m;
        s.box = {box.x + e(0), box.y + e(1), box.heading + e(2), box.length + e(3),
                 box.width + e(4)};
        const Vector5d d = boxThrough(s, errors, {4.5, 1.8}, {0, 0}, options).box - result.box;
        sum += d * d.transpose();
    }
    // The front is not told: without what that adds, the covariance is the scatter.
    Vector5d byFront = Vector5d::Zero();
    byFront.head<2>() = 0.5 * rotation(box.heading).col(0);
    byFront(3) = 1.0;
    const Matrix5d told = result.covariance - FaceErrors::kNotTold * FaceErrors::kNotTold *
                                                  byFront * byFront.transpose();
    const Matrix5d sampled = sum / runs;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
            EXPECT_NEAR(sampled(i, j), told(i, j), 0.04 * std::sqrt(told(i, i) * told(j, j)) + 1e-9)
                << i << j;
}

TEST(FaceErrorsOf, CountALostEndLess)
{
    const VisibilityOptions options;
    const VehicleState before = known({20.0, 5.0, 0.0, 4.5, 1.8}, 0.1);
    // Passing from behind a pillar: the side is as long as ever, then a metre short in front.
    const FaceSet side = faces({Face::Right});
    const FaceErrors whole =
        faceErrors(measured({20.05, 5.0, 0.0, 4.6, 1.8}, side), before, options);
    EXPECT_EQ(whole.sigma[0][0], options.sizeSigma);
    EXPECT_EQ(whole.sigma[0][1], options.sizeSigma);
    const FaceErrors lost = faceErrors(measured({19.5, 5.0, 0.0, 3.5, 1.8}, side), before, options);
    EXPECT_EQ(lost.sigma[0][0], options.sizeSigma);
    EXPECT_NEAR(lost.sigma[0][1], 1.0, 1e-12);
    // The rear is seen as a face: it is where it is, and the front is what lacks.
    const FaceErrors seen = faceErrors(
        measured({20.5, 5.0, 0.0, 3.5, 1.8}, faces({Face::Right, Face::Back})), before, options);
    EXPECT_EQ(seen.sigma[0][0], options.positionFloor);
    EXPECT_NEAR(seen.sigma[0][1], 1.0, 1e-12);
}

TEST(FaceErrorsOf, HardlyMindAWidthThatIsShortByLessThanRowsErr)
{
    const VisibilityOptions options;
    const VehicleState before = known({20.0, 5.0, 0.0, 4.5, 1.8}, 0.1);
    const auto worst = [&](double width)
    {
        const Measurement m =
            measured({20.0, 5.0 - 0.5 * (1.8 - width), 0.0, 4.5, width}, faces({Face::Back}));
        const FaceErrors errors = faceErrors(m, before, options);
        return std::max(errors.sigma[1][0], errors.sigma[1][1]);
    };
    EXPECT_EQ(worst(1.81), options.sizeSigma);
    EXPECT_EQ(worst(1.77), options.sizeSigma);
    EXPECT_NEAR(worst(1.7), options.shortfallSigma * 2.0 / 3.0, 1e-12);
    EXPECT_EQ(worst(1.6), options.shortfallSigma);
    EXPECT_NEAR(worst(1.2), 0.6, 1e-12);
}

// A car abreast shows a side, and neither end.
TEST(BoxThrough, HoldsTheMiddleOfARowThatIsAsLongAsTheVehicle)
{
    VisibilityOptions options;
    const VehicleState before = known({0.0, 4.0, 0.0, 4.5, 1.8}, 0.1);
    const auto through = [&](double length, double sigma)
    {
        Measurement m = measured({0.3, 4.0, 0.0, length, 1.8}, faces({Face::Right}));
        m.covariance = Matrix5d::Identity() * 1e-4;
        m.covariance(3, 3) = sigma * sigma;
        return boxThrough(m, faceErrors(m, before, options), before.size(), {-1.5, 0.0}, options);
    };
    const auto errorAlong = [](const BoxMeasurement& box)
    { return std::sqrt(measuredPoint(box).covariance(0, 0)); };
    for (const double length : {4.5, 4.6, 4.4})
    {
        const BoxMeasurement box = through(length, 0.08);
        EXPECT_EQ(box.fixedPoint.x(), 0.0);
        EXPECT_LT(errorAlong(box), 0.06) << length;
        EXPECT_GT(std::sqrt(box.covariance(3, 3)), 0.2) << "of the length it tells no more";
    }
    for (const double length : {4.2, 4.8}) EXPECT_NE(through(length, 0.08).fixedPoint.x(), 0.0);
    EXPECT_GT(errorAlong(through(4.5, 0.2)), 0.1) << "a row of few hits";
    options.correction = VisibilityCorrection::Corner;
    EXPECT_NE(through(4.5, 0.08).fixedPoint.x(), 0.0) << "as in the paper";
}

TEST(OpenToGrowth, LetsTheLengthFollowWithTheRearInPlace)
{
    const VisibilityOptions options;
    const VehicleState before = known({20.0, 5.0, 0.0, 3.0, 1.8}, 0.1);
    const FaceSet corner = faces({Face::Back, Face::Right});
    const VehicleState open =
        openToGrowth(before, measured({20.75, 5.0, 0.0, 4.5, 1.8}, corner), false, options);
    EXPECT_NEAR(open.covariance(kLength, kLength), 0.01 + 1.5 * 1.5, 1e-9);
    // The rear is as certain as it was.
    StateVector rear = StateVector::Zero();
    rear(kX) = 1.0;
    rear(kLength) = -0.5;
    EXPECT_NEAR(rear.dot(open.covariance * rear), rear.dot(before.covariance * rear), 1e-9);
    const VehicleState same =
        openToGrowth(before, measured({20.0, 5.0, 0.0, 3.1, 1.8}, corner), false, options);
    EXPECT_EQ(same.covariance, before.covariance);
}

// The rear half of a side, its ends hidden: the hits reach a metre beyond the rear as it was known.
TEST(OpenToGrowth, LetsTheLengthFollowHitsBeyondAHiddenEnd)
{
    const VisibilityOptions options;
    const VehicleState before = known({20.0, 5.0, 0.0, 5.0, 1.8}, 0.5);
    Measurement m = measured({18.5, 5.0, 0.0, 4.0, 1.8}, faces({Face::Right}));
    m.hiddenEnds = faces({Face::Front, Face::Back});
    const VehicleState open = openToGrowth(before, m, true, options);
    EXPECT_NEAR(open.covariance(kLength, kLength), before.covariance(kLength, kLength) + 1.0, 1e-9);
    // The front is as certain as it was.
    StateVector front = StateVector::Zero();
    front(kX) = 1.0;
    front(kLength) = 0.5;
    EXPECT_NEAR(front.dot(open.covariance * front), front.dot(before.covariance * front), 1e-9);
    EXPECT_EQ(openToGrowth(before, m, false, options).covariance, before.covariance);
    Measurement vague = m;
    vague.covariance(2, 2) = 0.05 * 0.05;
    EXPECT_EQ(openToGrowth(before, vague, true, options).covariance, before.covariance)
        << "they may lie beside it";
    Measurement unseen = m;
    unseen.covariance(3, 3) = 2.0;
    EXPECT_EQ(openToGrowth(before, unseen, true, options).covariance, before.covariance)
        << "no hits tell how long it is";
    // Hits within it say nothing.
    m.box.x = 19.6;
    EXPECT_EQ(openToGrowth(before, m, true, options).covariance, before.covariance);
}

TEST(FaceErrors, OfWhatIsNotToldNeverMakeALengthKnown)
{
    VehicleKalmanFilter filter{MotionOptions()};
    const VisibilityOptions o;
    const Measurement rear = measured({20.0, 0.0, 0.0, 1.2, 1.75}, faces({Face::Back}));
    VehicleState state = startState(rear, 1.5, {0, 0}, {0.0, 0.1}, o, MotionOptions());
    const double before = state.covariance(kLength, kLength);
    for (int k = 0; k < 600; ++k)
        state = filter.update(
            state, boxThrough(rear, faceErrors(rear, state, o), state.size(), {0, 0}, o));
    EXPECT_GT(state.covariance(kLength, kLength), 0.9 * before);
}

TEST(AlignedWith, TurnsFrontAndFaces)
{
    const Measurement m = measured({1, 2, 0.1, 4.5, 1.8}, faces({Face::Back, Face::Left}));
    const Measurement same = alignedWith(m, 0.3);
    EXPECT_EQ(toString(same.facesSeen), "BL");
    const Measurement turned = alignedWith(m, 3.0);
    EXPECT_NEAR(turned.box.heading, 0.1 - kPi, 1e-12);
    EXPECT_EQ(toString(turned.facesSeen), "FR");
}

TEST(LiesAcross, FromHalfwayToARightAngleOn)
{
    const Measurement m = measured({1, 2, 0.1, 4.5, 1.8}, faces({Face::Back}));
    for (const double along : {0.1, 0.8, 0.1 + kPi}) EXPECT_FALSE(liesAcross(m, along)) << along;
    for (const double across : {0.95, 1.7, -1.4}) EXPECT_TRUE(liesAcross(m, across)) << across;
}

// Half of a car's rear beside a pole is small; the whole rear is a car's.
TEST(FaceErrors, OfEndsThatAreBothHiddenCountWhereHitsReachBeyondThem)
{
    const VisibilityOptions o;
    // A row along the left side from x = 9 to 12.
    Measurement row = measured({10.5, 0.0, 0.0, 3.0, 1.8}, faces({Face::Left}));
    row.hiddenEnds = faces({Face::Front, Face::Back});
    const FaceErrors inside = faceErrors(row, known({10.0, 0.0, 0.0, 4.5, 1.8}, 0.4), o);
    EXPECT_FALSE(inside.tells(0, 0));
    EXPECT_FALSE(inside.tells(0, 1));
    // The front expected at 11.25.
    const FaceErrors ahead = faceErrors(row, known({9.0, 0.0, 0.0, 4.5, 1.8}, 0.4), o);
    EXPECT_FALSE(ahead.tells(0, 0));
    EXPECT_EQ(ahead.sigma[0][1], o.shortfallSigma);
    const FaceErrors behind = faceErrors(row, known({13.0, 0.0, 0.0, 4.5, 1.8}, 0.4), o);
    EXPECT_EQ(behind.sigma[0][0], o.shortfallSigma);
    EXPECT_FALSE(behind.tells(0, 1));
}

// Another car hides the left part of the end, but more of it is seen than was known.
TEST(FaceErrors, OfAHiddenEndCountWhereHitsReachBeyondIt)
{
    const VisibilityOptions o;
    VehicleState narrow = known({20.0, 0.0, 0.0, 4.0, 1.0}, 0.3);
    narrow.widthVariance = 0.2;
    Measurement m = measured({20.0, 0.35, 0.0, 4.0, 1.7}, faces({Face::Back, Face::Right}));
    m.hiddenEnds.add(Face::Left);
    EXPECT_FALSE(faceErrors(m, o).tells(1, 1));
    EXPECT_TRUE(faceErrors(m, narrow, o).tells(1, 1));
    VehicleKalmanFilter filter{MotionOptions()};
    for (int k = 0; k < 10; ++k)
        narrow = filter.update(
            narrow, boxThrough(m, faceErrors(m, narrow, o), narrow.size(), {0.0, -9.0}, o));
    EXPECT_NEAR(narrow.width, 1.6, 0.1);
    m.box.width = 0.8;
    m.box.y = -0.1;
    EXPECT_FALSE(faceErrors(m, narrow, o).tells(1, 1)) << "what is hidden may be anywhere beyond";
}

}  // namespace
}  // namespace vdamf
