// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/descriptor_numbers.h"

namespace vdamf
{
namespace
{
namespace knots
{
constexpr double kLength[] = {0.3, 1.0, 1.8, 3.0, 4.3, 6.0, 11.0};
constexpr double kWidth[] = {0.2, 0.8, 1.4, 1.8, 2.5};
constexpr double kTop[] = {0.6, 1.1, 1.4, 1.7, 2.1, 2.7, 3.0};
constexpr double kBottom[] = {0.22, 0.5, 1.0};
constexpr double kShoulder[] = {0.5, 0.9, 1.2, 1.5, 2.0, 2.6};
constexpr double kMiddle[] = {0.3, 0.6, 0.9, 1.3, 2.0};
constexpr double kColumns[] = {0.1, 0.3, 0.6, 1.0, 1.6};
constexpr double kHigh[] = {0.0, 0.05, 0.2, 0.6};
constexpr double kOutside[] = {0.0, 0.1, 0.3, 0.7};
constexpr double kDensity[] = {-3.0, -1.5, -0.5, 0.5, 1.5};
constexpr double kBearing[] = {0.0, 0.3, 0.8, 1.3, 1.57};
constexpr double kBreadth[] = {0.5, 1.2, 2.0, 4.0, 8.0};
constexpr double kCoverage[] = {0.3, 0.6, 0.85, 1.0};
constexpr double kDepth[] = {0.02, 0.1, 0.25, 0.6};
constexpr double kShare[] = {0.0, 0.3, 0.7, 1.0};
constexpr double kStraightness[] = {0.01, 0.05, 0.12, 0.3};
constexpr double kMatch[] = {0.0, 0.3, 0.6, 1.0};

constexpr double kThickness[] = {0.01, 0.035, 0.08, 0.15, 0.35};
constexpr double kBend[] = {0.03, 0.1, 0.2, 0.35, 0.7};
constexpr double kSlope[] = {-0.2, 0.0, 0.05, 0.15, 0.4};
constexpr double kRagged[] = {0.0, 0.02, 0.08, 0.3, 1.0};
constexpr double kLowWidth[] = {0.1, 0.5, 1.2, 1.8, 2.6};
constexpr double kHighWidth[] = {0.15, 0.7, 1.3, 1.8, 3.0};
constexpr double kScatter[] = {0.004, 0.02, 0.05, 0.1, 0.16};
constexpr double kTilt[] = {0.0, 0.02, 0.1, 0.3, 1.0};
constexpr double kLeast[] = {0.0, 0.03, 0.1, 0.25, 0.6};
constexpr double kMiddleSpan[] = {0.02, 0.2, 0.35, 0.6, 0.95};
constexpr double kGreatest[] = {0.2, 0.5, 0.8, 1.5, 3.9};
constexpr double kBandX[] = {0.0, 0.3, 0.8, 2.0, 5.0};
constexpr double kBandXScatter[] = {0.015, 0.07, 0.4, 1.1, 2.5};
constexpr double kBandY[] = {0.0, 0.2, 0.4, 0.8, 1.6};
constexpr double kBandYScatter[] = {0.01, 0.06, 0.25, 0.5, 1.0};
}  // namespace knots

template <auto number>
std::optional<double> ofLowHits(const Descriptors& d)
{
    if (!d.low) return std::nullopt;
    return (*d.low).*number;
}

template <auto number>
std::optional<double> direct(const Descriptors& d)
{
    return d.*number;
}

template <auto number>
std::optional<double> ofSilhouette(const Descriptors& d)
{
    return d.silhouette.*number;
}

template <auto number>
std::optional<double> ofFlatness(const Descriptors& d)
{
    return d.flatness.*number;
}

template <auto face, auto number>
std::optional<double> ofFace(const Descriptors& d)
{
    return (d.flatness.*face).*number;
}

template <std::size_t band, auto number>
std::optional<double> ofBand(const Descriptors& d)
{
    if (!d.profile[band]) return std::nullopt;
    return (*d.profile[band]).*number;
}

using D = Descriptors;
using F = FaceShape;
using O = Flatness;
using B = HeightBand;
using L = Descriptors::LowHits;
using S = Silhouette;

constexpr std::array<DescriptorNumber, 46> kEachNumber = {{
    {"length", knotsOf(knots::kLength), Needs::Nothing, Role::Core, direct<&D::length>},
    {"width", knotsOf(knots::kWidth), Needs::Nothing, Role::Core, direct<&D::width>},
    {"outside", knotsOf(knots::kOutside), Needs::Nothing, Role::Other, direct<&D::outside>},
    {"beyond", knotsOf(knots::kOutside), Needs::Nothing, Role::Other, direct<&D::beyond>},
    {"density", knotsOf(knots::kDensity), Needs::Nothing, Role::Other, direct<&D::density>},
    {"bearing", knotsOf(knots::kBearing), Needs::Nothing, Role::Core, direct<&D::bearing>},
    {"breadth", knotsOf(knots::kBreadth), Needs::Nothing, Role::Other, ofSilhouette<&S::breadth>},
    {"coverage", knotsOf(knots::kCoverage), Needs::Nothing, Role::Other,
     ofSilhouette<&S::coverage>},
    {"thickness", knotsOf(knots::kThickness), Needs::Nothing, Role::Other,
     ofSilhouette<&S::thickness>},
    {"bend", knotsOf(knots::kBend), Needs::Nothing, Role::Other, ofSilhouette<&S::bend>},
    {"match", knotsOf(knots::kMatch), Needs::Nothing, Role::Other, direct<&D::match>},
    {"depth", knotsOf(knots::kDepth), Needs::Nothing, Role::Other, ofLowHits<&L::depth>},
    {"near", knotsOf(knots::kShare), Needs::Nothing, Role::Other, ofLowHits<&L::near>},
    {"straightness", knotsOf(knots::kStraightness), Needs::Nothing, Role::Other,
     ofLowHits<&L::straightness>},
    {"on_side", knotsOf(knots::kShare), Needs::Nothing, Role::Core, ofLowHits<&L::onSide>},
    {"side_share", knotsOf(knots::kShare), Needs::Nothing, Role::Other,
     ofFace<&O::side, &F::share>},
    {"end_share", knotsOf(knots::kShare), Needs::Nothing, Role::Other, ofFace<&O::end, &F::share>},
    {"middle_span", knotsOf(knots::kMiddleSpan), Needs::Heights, Role::Other,
     ofFlatness<&O::middle>},
    {"greatest_span", knotsOf(knots::kGreatest), Needs::Heights, Role::Other,
     ofFlatness<&O::greatest>},
    {"top", knotsOf(knots::kTop), Needs::Heights, Role::Core, direct<&D::top>},
    {"shoulder", knotsOf(knots::kShoulder), Needs::Heights, Role::Other, direct<&D::shoulder>},
    {"middle", knotsOf(knots::kMiddle), Needs::Heights, Role::Other, direct<&D::middle>},
    {"bottom", knotsOf(knots::kBottom), Needs::Heights, Role::Other, direct<&D::bottom>},
    {"columns", knotsOf(knots::kColumns), Needs::Heights, Role::Other, direct<&D::columns>},
    {"high", knotsOf(knots::kHigh), Needs::Heights, Role::Other, direct<&D::high>},
    {"slope", knotsOf(knots::kSlope), Needs::Heights, Role::Other, ofSilhouette<&S::slope>},
    {"ragged", knotsOf(knots::kRagged), Needs::Heights, Role::Other, ofSilhouette<&S::ragged>},
    {"low_width", knotsOf(knots::kLowWidth), Needs::Heights, Role::Other, direct<&D::lowWidth>},
    {"high_width", knotsOf(knots::kHighWidth), Needs::Heights, Role::Other, direct<&D::highWidth>},
    {"least_span", knotsOf(knots::kLeast), Needs::Heights, Role::Other, ofFlatness<&O::least>},
    {"side_scatter", knotsOf(knots::kScatter), Needs::Heights, Role::Other,
     ofFace<&O::side, &F::scatter>},
    {"side_tilt", knotsOf(knots::kTilt), Needs::Heights, Role::Other, ofFace<&O::side, &F::tilt>},
    {"end_scatter", knotsOf(knots::kScatter), Needs::Heights, Role::Other,
     ofFace<&O::end, &F::scatter>},
    {"end_tilt", knotsOf(knots::kTilt), Needs::Heights, Role::Other, ofFace<&O::end, &F::tilt>},
    {"low_x", knotsOf(knots::kBandX), Needs::Heights, Role::Band, ofBand<0, &B::x>},
    {"low_x_scatter", knotsOf(knots::kBandXScatter), Needs::Heights, Role::Band,
     ofBand<0, &B::xScatter>},
    {"low_y", knotsOf(knots::kBandY), Needs::Heights, Role::Band, ofBand<0, &B::y>},
    {"low_y_scatter", knotsOf(knots::kBandYScatter), Needs::Heights, Role::Band,
     ofBand<0, &B::yScatter>},
    {"window_x", knotsOf(knots::kBandX), Needs::Heights, Role::Band, ofBand<1, &B::x>},
    {"window_x_scatter", knotsOf(knots::kBandXScatter), Needs::Heights, Role::Band,
     ofBand<1, &B::xScatter>},
    {"window_y", knotsOf(knots::kBandY), Needs::Heights, Role::Band, ofBand<1, &B::y>},
    {"window_y_scatter", knotsOf(knots::kBandYScatter), Needs::Heights, Role::Band,
     ofBand<1, &B::yScatter>},
    {"high_x", knotsOf(knots::kBandX), Needs::Heights, Role::Band, ofBand<2, &B::x>},
    {"high_x_scatter", knotsOf(knots::kBandXScatter), Needs::Heights, Role::Band,
     ofBand<2, &B::xScatter>},
    {"high_y", knotsOf(knots::kBandY), Needs::Heights, Role::Band, ofBand<2, &B::y>},
    {"high_y_scatter", knotsOf(knots::kBandYScatter), Needs::Heights, Role::Band,
     ofBand<2, &B::yScatter>},
}};
}  // namespace

const std::array<DescriptorNumber, kDescriptorNumbers>& descriptorNumbers()
{
    return kEachNumber;
}

}  // namespace vdamf
