// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/face_hull.h"

#include <algorithm>
#include <cmath>

#include "matched_filter/body_profile.h"

namespace vdamf
{
namespace
{
// Squares of how far the surface departs from a plane on either side of the line: what the hits
// scatter more than the sensor's noise makes them.
struct Excess
{
    double outside = 0.0;
    double inside = 0.0;
};

Excess excessOf(const Departure& d, double noise, const LineWeights& weights, bool isBody,
                double prior, double priorHits)
{
    const auto over = [noise](double square, double share, double count, double chances)
    {
        const double byNoise = share * noise * noise * (1.0 + chances * std::sqrt(2.0 / count));
        return std::max(0.0, square - byNoise);
    };
    Excess excess;
    if (d.countInside > 0.0)
        excess.inside = over(d.inside, weights.insideShare, std::max(1.0, d.countInside), 1.0);
    // What chance may have made counts for little.
    const double count = std::max(1.0, d.countOutside);
    if (d.countOutside > 0.0)
        excess.outside = over(d.outside, weights.outsideShare, count, isBody ? 0.0 : 1.0);
    const double chance = (isBody ? 1.0 : 2.0) * noise * noise * std::sqrt(2.0 / count);
    excess.outside *= excess.outside / (excess.outside + chance + 1e-12);
    if (!isBody) return excess;
    const double all = d.countOutside + d.countInside;
    excess.outside = (priorHits * prior * prior + all * excess.outside) / (priorHits + all);
    return excess;
}
}  // namespace

Departure departureOf(const NearFace& face, const LineState& line)
{
    constexpr double kFarthest = 2.5;  // sigmas outside of the line; beyond it are other things
    double squares[2] = {0.0, 0.0};
    double count[2] = {0.0, 0.0};
    double along = 0.0;
    double alongSquares = 0.0;
    for (const FaceHits::Block& block : face.hits.blocks)
        for (std::size_t k = 0; k < FaceHits::Block::kHits; ++k)
        {
            const double a = block.along[k];
            const double r = block.outwards[k] + face.slope * line.turn * a - line.place;
            if (r > kFarthest * line.sigma) continue;
            const int side = r < 0.0 ? 1 : 0;
            const double weight = block.weight[k];
            squares[side] += weight * (r * r + block.spread[k]);
            count[side] += weight;
            along += weight * a;
            alongSquares += weight * a * a;
        }
    const double all = std::max(1.0, count[0] + count[1]);
    const double middle = along / all;
    return {squares[0] / std::max(1.0, count[0]), squares[1] / std::max(1.0, count[1]), count[0],
            count[1], std::sqrt(12.0 * std::max(0.0, alongSquares / all - middle * middle))};
}

Hull hullOf(const Departure& departure, const NearFace& face, const LineState& line,
            const BodyPrior& body)
{
    constexpr double kShortest = 0.5;  // m; shorter rows tell nothing of the direction
    const bool isBody = body.depth > 0.0;
    const ErrorParameters& errors = body.errors;
    const BodyProfile profile = bodyProfile(body.face, body.heights, body.hull);
    const Excess excess = excessOf(departure, face.noise, line.weights, isBody,
                                   body.depth * profile.usualDeparture, body.hull.usualHits);
    const double byNoise = line.weights.shift * face.noise * std::min(1.0, face.noise / line.sigma);
    Hull hull;
    hull.shape = std::sqrt(excess.outside);
    hull.outwards = profile.toHull * hull.shape - byNoise + body.depth * profile.beyond;
    const bool isEnd = body.face == Face::Front || body.face == Face::Back;
    const double inside = std::sqrt(excess.inside);
    hull.error = std::hypot(errors.hull * profile.hullError * hull.shape,
                            (isEnd ? errors.endTaper : errors.taper) * inside, errors.least);
    hull.error = std::hypot(hull.error, body.depth * profile.beyondError);
    hull.turnError = std::hypot(errors.turn * hull.shape, errors.taperTurn * inside) /
                     std::max(kShortest, departure.extent);
    if (isBody) hull.turnError = std::hypot(hull.turnError, errors.bodyTurn);
    return hull;
}

}  // namespace vdamf
