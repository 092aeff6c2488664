// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/range_noise.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kLeastNoise = 0.02;  // m
constexpr double kMostNoise = 0.1;    // m
// The usual value counts as so many hits.
constexpr double kUsual = 0.025;  // m
constexpr double kUsualHits = 6.0;
// Scatter inside over scatter outside: 1.46 for Gaussian hits, 2.3 and more for bodies.
constexpr double kGaussian = 1.75;
constexpr double kBody = 2.2;
}  // namespace

double estimatedRangeNoise(const NearFaces& faces, const LineState& end, const LineState& side)
{
    double squares = kUsualHits * kUsual * kUsual;
    double weight = kUsualHits;
    double outside = 0.0;
    double inside = 0.0;
    for (const std::size_t k : {kEndFace, kSideFace})
    {
        const NearFace& face = faces[k];
        const LineState& line = k == kEndFace ? end : side;
        if (face.hits.empty()) continue;
        const Departure d = departureOf(face, line);
        const double along = face.noise * face.noise;
        squares += d.countOutside * d.outside + d.countInside * d.inside;
        weight += along * (d.countOutside * line.weights.outsideShare +
                           d.countInside * line.weights.insideShare);
        outside += d.outside * d.countOutside;
        inside += d.inside * d.countOutside;
    }
    const double ratio = outside > 0.0 ? std::sqrt(inside / outside) : kBody;
    const double gaussian = std::clamp((kBody - ratio) / (kBody - kGaussian), 0.0, 1.0);
    const double noise = std::clamp(std::sqrt(squares / weight), kLeastNoise, kMostNoise);
    return kLeastNoise + gaussian * (noise - kLeastNoise);
}

}  // namespace vdamf
