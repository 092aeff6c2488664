// SPDX-License-Identifier: BSD-3-Clause
// A plane full of moving cars, for the time that the tracker takes for many of them.
#pragma once

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// Lanes of cars on a square around the sensor, one car on 28 m^2 however many there are; the cars
/// of a lane drive at one speed, 5 to 15 m/s, the lanes in turn to either side. Hits are made on
/// the two faces towards the sensor, about 70 a car, as if no car hid another; and on flat ground.
struct StressScene
{
    int targets = 500;

    /// Frames come ten a second. The same number, the same bytes.
    LadarFrame frame(int number) const;
};

}  // namespace vdamf
