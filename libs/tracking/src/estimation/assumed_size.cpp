// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/assumed_size.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kPiece = 0.9;  // m, of an end of which something hides the rest
// Hits tell widths to a decimetre or two: what is higher than any car may be narrower.
constexpr double kTallest = 2.6;   // m
constexpr double kLongSide = 5.5;  // m, of vans, trucks and buses
constexpr AssumedSize kTruckWidth{2.1, 0.3};

// The end of a truck or bus alone tells little of its length. What is as wide and low is none: the
// part of a side, or no vehicle.
constexpr double kLeastTruckHeight = 1.9;  // m
constexpr AssumedSize kTruckLength{9.0, 2.0};

// Vans are higher, longer and wider than cars, of the labelled vehicles of KITTI and Argoverse 2:
// wider by the metre over a car's height,
constexpr double kCarHeight = 1.5;   // m
constexpr double kHighestVan = 3.0;  // m
constexpr AssumedSize kWider{0.3, 0.1};
// and longer from one height on, by the metre of width in any case (a robust regression over 104
// vehicles that are lower than 2.45 m).
constexpr double kHighCar = 1.7;  // m
constexpr double kLowVan = 2.0;   // m
constexpr AssumedSize kLonger{0.55, 0.4};
constexpr double kLongerByWidth = 0.9;
constexpr double kOddWidth = 0.35;  // m, over or under a car's: mirrors, or not all of an end

bool couldBeACar(const Measurement& m, double height)
{
    const bool lengthFits = !m.facesSeen.seesSide() || m.box.length < kLongSide;
    const bool widthFits = !m.facesSeen.seesEnd() || m.box.width < widestCar(height);
    const bool carEnd =
        m.facesSeen.seesEnd() && m.box.width > (locatesWidth(m) ? kNarrowestCar : kPiece);
    const bool carSide = m.facesSeen.seesSide() && m.box.length > (locatesLength(m) ? 2.1 : 1.2);
    return lengthFits && widthFits && (carEnd || carSide);
}
}  // namespace

double widestCar(double height)
{
    return height > kTallest ? 2.1 : 2.3;  // m
}

AssumedSize carLength(double height, const std::optional<double>& width, const VisibilityOptions& o)
{
    const double van = std::clamp((height - kHighCar) / (kLowVan - kHighCar), 0.0, 1.0);
    const double told = width ? *width : carWidth(height, o).metres;
    const double wider = std::clamp(told - o.carWidth, -kOddWidth, kOddWidth);
    return {o.carLength + van * kLonger.metres + kLongerByWidth * wider,
            std::hypot(o.carLengthSigma, van * kLonger.sigma)};
}

AssumedSize carWidth(double height, const VisibilityOptions& o)
{
    const double more = std::clamp(height, kCarHeight, kHighestVan) - kCarHeight;
    return {o.carWidth + more * kWider.metres, std::hypot(o.carWidthSigma, more * kWider.sigma)};
}

bool isCarsEnd(double width, double height)
{
    return width >= kNarrowestCar && width < widestCar(height);
}

std::optional<AssumedSize> lengthBehind(double width, double height, const VisibilityOptions& o)
{
    if (width < kNarrowestCar || width > kWidestTruck) return std::nullopt;
    if (width < widestCar(height)) return carLength(height, width, o);
    if (height < kLeastTruckHeight) return std::nullopt;
    return kTruckLength;
}

AssumedSize longerThan(double seen, const AssumedSize& length)
{
    const double least = (seen - length.metres) / length.sigma;
    const double share = 0.5 * std::erfc(least / std::sqrt(2.0));
    const double density = std::exp(-0.5 * least * least) / std::sqrt(2.0 * kPi);
    // Beyond five sigmas by its series.
    const double mean = share > 1e-6 ? density / share : least + 1.0 / least;
    const double variance = std::max(0.01, 1.0 + mean * (least - mean));
    return {length.metres + mean * length.sigma, std::sqrt(variance) * length.sigma};
}

std::optional<AssumedSize> lengthOfMoreThan(double seen, double height)
{
    constexpr double kLongestVan = 6.5;       // m
    constexpr AssumedSize kTrucks{9.5, 2.0};  // trucks and buses alike
    if (seen < kLongestVan || height < kLeastTruckHeight) return std::nullopt;
    return longerThan(seen, kTrucks);
}

std::optional<AssumedSize> widthBehind(double length, double height, const VisibilityOptions& o)
{
    if (length < kShortestCar) return std::nullopt;
    return length < kLongSide ? carWidth(height, o) : kTruckWidth;
}

bool isPieceOfACarsEnd(const Measurement& m, double height)
{
    return m.facesSeen.seesEnd() && !locatesWidth(m) && m.box.width > kPiece &&
           m.box.width < widestCar(height);
}

AssumedSizes assumedSizes(const Measurement& m, double height, const VisibilityOptions& o)
{
    if (!o.assumeVehicleSize) return {};
    if (couldBeACar(m, height)) return {carLength(height, std::nullopt, o), carWidth(height, o)};
    const bool sideAlone = m.facesSeen.seesSide() && !m.facesSeen.seesEnd();
    if (sideAlone && m.box.length > kLongSide) return {std::nullopt, kTruckWidth};
    const bool endAlone = m.facesSeen.seesEnd() && !m.facesSeen.seesSide();
    if (endAlone && m.box.width > widestCar(height))
        return {lengthBehind(m.box.width, height, o), std::nullopt};
    return {};
}

}  // namespace vdamf
