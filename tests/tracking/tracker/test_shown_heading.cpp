// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/shown_heading.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tracker/track.h"

namespace vdamf
{
namespace
{
constexpr double kOneDegree = kPi / 180.0;
const Eigen::Vector2d kMiddleOfHits(9.0, 4.2);

Measurement shownAt(double heading, double sigma)
{
    Measurement m;
    m.box = {10.0, 5.0, heading, 4.5, 1.8};
    m.covariance.diagonal() << 0.01, 0.01, sigma * sigma, 0.01, 0.01;
    return m;
}

ShownHeading afterSomeViews(ShownHeading shown, double heading, double sigma, int views)
{
    const View first = shown.view;
    for (int k = 1; k <= views; ++k)
        shown = shown.after(shownAt(heading, sigma), {first.bearing + 0.5 * k, first.range});
    return shown;
}

TEST(ShownHeading, EachViewCountsOnce)
{
    const double sigma = 2.0 * kOneDegree;
    const View view{0.3, 12.0};
    ShownHeading same = ShownHeading().after(shownAt(0.1, sigma), view);
    EXPECT_NEAR(same.heading, 0.1, 1e-9);
    EXPECT_NEAR(same.variance, sigma * sigma, 0.01 * sigma * sigma);
    for (int k = 0; k < 10; ++k) same = same.after(shownAt(0.1, sigma), view);
    EXPECT_GT(same.variance, 0.8 * sigma * sigma) << "ten frames of one view";
    EXPECT_NEAR(afterSomeViews(same, 0.1, sigma, 9).variance, 0.1 * sigma * sigma,
                0.03 * sigma * sigma)
        << "nine other views";
    EXPECT_GT(afterSomeViews(same, 0.1, 1e-4, 50).variance, std::pow(0.15 * kOneDegree, 2));
}

TEST(ShownHeading, AViewIsTheSameOneWhenTheAxesAreTurned)
{
    const double sigma = 2.0 * kOneDegree;
    const View view{0.3, 12.0};
    const ShownHeading shown = ShownHeading().after(shownAt(0.1, sigma), view);
    for (const int quarters : {1, 2, 3})
    {
        const View same{wrapAngle(view.bearing - 0.5 * kPi * quarters), view.range};
        const ShownHeading after = turned(shown, quarters).after(shownAt(0.1, sigma), same);
        EXPECT_GT(after.variance, 0.95 * shown.variance) << quarters;
    }
}

TEST(ShownHeading, HoldsWhereItIsSeenInPart)
{
    ShownHeading shown = afterSomeViews(ShownHeading(), 0.2, 0.4 * kOneDegree, 4);
    for (int k = 0; k < 20; ++k)
        shown = shown.after(shownAt(0.2 + 3.0 * kOneDegree, 1.2 * kOneDegree), shown.view);
    EXPECT_NEAR(shown.heading, 0.2, 0.5 * kOneDegree);
    const Measurement part = shownAt(0.2 + 3.0 * kOneDegree, 1.2 * kOneDegree);
    const Measurement turned = turnedTowards(shown, part, kMiddleOfHits);
    EXPECT_NEAR(turned.box.heading, 0.2, 0.6 * kOneDegree);
    EXPECT_EQ(turned.covariance, part.covariance) << "its error lasts";
    // About its hits.
    EXPECT_NEAR((turned.box.centre() - kMiddleOfHits).norm(),
                (part.box.centre() - kMiddleOfHits).norm(), 1e-12);
    EXPECT_GT((turned.box.centre() - part.box.centre()).norm(), 0.02);
}

TEST(ShownHeading, IsThatOfTheBetterViewHoweverVagueTheFirstOnesWere)
{
    ShownHeading shown = afterSomeViews(ShownHeading(), 12.0 * kOneDegree, 1.0 * kOneDegree, 6);
    shown = afterSomeViews(shown, 0.0, 0.3 * kOneDegree, 3);
    EXPECT_NEAR(shown.heading, 0.0, 1.0 * kOneDegree) << "what contradicts it makes it doubtful";
}

TEST(ShownHeading, LeavesAloneWhatIsSharpOrContradictsItOrWhereLittleIsKnown)
{
    const ShownHeading shown = afterSomeViews(ShownHeading(), 0.2, 0.4 * kOneDegree, 4);
    const auto headingAfter = [&](double heading, double sigma)
    { return turnedTowards(shown, shownAt(heading, sigma), kMiddleOfHits).box.heading; };
    EXPECT_EQ(headingAfter(0.21, 0.2 * kOneDegree), 0.21);
    EXPECT_EQ(headingAfter(0.2 + 8.0 * kOneDegree, 1.0 * kOneDegree), 0.2 + 8.0 * kOneDegree);
    const ShownHeading vague = afterSomeViews(ShownHeading(), 0.2, 3.0 * kOneDegree, 4);
    EXPECT_EQ(turnedTowards(vague, shownAt(0.25, 0.2), kMiddleOfHits).box.heading, 0.25);
}

TEST(ShownHeading, IsTheSameForBoxesThatLieAcross)
{
    const ShownHeading shown = afterSomeViews(ShownHeading(), 0.2, 0.4 * kOneDegree, 4);
    for (const int quarters : {1, 2, 3})
    {
        const double across = wrapAngle(0.2 + 0.5 * kPi * quarters);
        const Measurement part = shownAt(across + 2.0 * kOneDegree, 1.2 * kOneDegree);
        EXPECT_NEAR(wrapAngle(turnedTowards(shown, part, kMiddleOfHits).box.heading - across), 0.0,
                    0.5 * kOneDegree)
            << quarters;
        EXPECT_NEAR(shown.after(part, shown.view).heading, 0.2, 0.1 * kOneDegree) << quarters;
    }
}

TEST(ShownHeading, GoesWithThePlatform)
{
    Track track;
    track.shownHeading = afterSomeViews(ShownHeading(), 0.2, 0.4 * kOneDegree, 4);
    PlaneMotion motion;
    motion.turn = 0.05;
    EXPECT_NEAR(movedBy(std::move(track), motion).shownHeading->heading, 0.25, 1e-9);
}

}  // namespace
}  // namespace vdamf
