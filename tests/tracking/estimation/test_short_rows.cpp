// SPDX-License-Identifier: BSD-3-Clause
// Rows of hits that are shorter than the vehicle that stands.
#include <gtest/gtest.h>

#include "tracking/estimation/measured_vehicles.h"
#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
namespace
{
TEST(ShortRows, TellNothingOfWhereWhatStandsIsAtEitherEndThatTheyFallShortOf)
{
    const VisibilityOptions options;
    const VehicleState before = known({0.0, 4.0, 0.0, 4.0, 1.7}, 0.1);
    const auto sigmas = [&](double x, double length)
    {
        const Measurement m = measured({x, 4.0, 0.0, length, 1.7}, faces({Face::Right}));
        return withShortRows(faceErrors(m, before, options), m, before);
    };
    const FaceErrors both = sigmas(-0.2, 1.6);  // by 1.0 m behind, 1.4 m ahead
    EXPECT_NEAR(both.sigma[0][0], 1.0, 1e-9);
    EXPECT_GT(both.sigma[0][1], 1.4);
    const FaceErrors moved = sigmas(0.5, 4.0);  // beyond the front: it has moved
    EXPECT_EQ(moved.sigma[0][1], options.sizeSigma);
}

TEST(ShortRows, LieInsideWhereTheVehicleSurelyIs)
{
    VehicleState before = known({0.0, 4.0, 0.0, 4.0, 1.7}, 0.1);
    const auto lies = [&](double x, double length) {
        return isInside(measured({x, 4.0, 0.0, length, 1.7}, faces({Face::Right})), before);
    };
    before.covariance(kX, kX) = 0.04;
    EXPECT_TRUE(lies(0.2, 1.6));
    EXPECT_FALSE(lies(1.0, 1.6)) << "to within the front";
    EXPECT_FALSE(lies(-1.0, 1.6)) << "to within the rear";
    EXPECT_FALSE(lies(0.0, 3.8));
    Measurement hidden = measured({0.2, 4.0, 0.0, 1.6, 1.7}, faces({Face::Right}));
    hidden.hiddenEnds.add(Face::Back);
    EXPECT_FALSE(isInside(hidden, before)) << "the front alone is told";
    before.covariance(kX, kX) = 1.0;
    EXPECT_FALSE(lies(0.2, 1.6)) << "where it is, is not known";
}

}  // namespace
}  // namespace vdamf
