// SPDX-License-Identifier: BSD-3-Clause
// Section 4.5: the size assumed of a vehicle where it is not seen.
#pragma once

#include <optional>

#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
struct AssumedSize
{
    double metres = 0.0;
    double sigma = 0.0;  ///< m
};

/// What a measurement suggests; nothing of what is measured, or could be anything.
struct AssumedSizes
{
    std::optional<AssumedSize> length;
    std::optional<AssumedSize> width;
};

inline constexpr double kNarrowestCar = 1.3;   ///< m
inline constexpr double kWidestTruck = 2.8;    ///< m
inline constexpr double kShortestUsual = 3.5;  ///< m: of 265 labelled cars and vans two are shorter
inline constexpr double kShortestCar = 3.0;    ///< m: longer than a motorcycle

/// Widest that an end of a car or van of that height seems to be, m.
double widestCar(double height);

/// Of a car or van of that height, m; longer or shorter by its width where that is known.
AssumedSize carLength(double height, const std::optional<double>& width,
                      const VisibilityOptions& options);
AssumedSize carWidth(double height, const VisibilityOptions& options);

/// Of the vehicle behind an end of that width and height (m); nothing where it is no vehicle's.
std::optional<AssumedSize> lengthBehind(double width, double height,
                                        const VisibilityOptions& options);

/// Of a bus: most are 12 m long, articulated ones 18, small ones 9.
inline constexpr AssumedSize kBusLength{12.0, 2.0};

/// Of a vehicle whose length was held to be that, and of which more is seen (m) than ends in sight:
/// mean and standard deviation of the normal distribution without what is shorter.
AssumedSize longerThan(double seen, const AssumedSize& length);

/// Of a truck or bus of that height of which that length is seen, and that goes on out of sight
/// (m); nothing where it may be a van.
std::optional<AssumedSize> lengthOfMoreThan(double seen, double height);

/// Of the vehicle behind a side of that length and height (m).
std::optional<AssumedSize> widthBehind(double length, double height,
                                       const VisibilityOptions& options);

/// Whether a part of an end is seen, beside what hides the rest, that is as high (m) and wide as
/// one of a car's.
bool isPieceOfACarsEnd(const Measurement& measurement, double height);

/// Of a vehicle of that height (m) that was seen once.
AssumedSizes assumedSizes(const Measurement& measurement, double height,
                          const VisibilityOptions& options);

/// Whether an end of that width and height (m) may be all of one of a car or van.
bool isCarsEnd(double width, double height);

}  // namespace vdamf
