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

}  // namespace
}  // namespace vdamf
