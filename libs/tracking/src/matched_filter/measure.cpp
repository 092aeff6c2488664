// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/measure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "matched_filter/face_box.h"
#include "matched_filter/face_extent.h"
#include "matched_filter/match_kernel.h"
#include "vdamf/tracking/matched_filter/covariance.h"

namespace vdamf
{
namespace
{
// The filters to run in turn, each from the result of the one before.
std::vector<FilterShape> filterSteps(const MeasureOptions& options)
{
    FilterShape shape = FilterShape::paper();
    shape.sigma = options.sigma;
    std::vector<FilterShape> steps{shape};
    if (options.filter == FilterKind::CoarseToFine)
    {
        shape.endStrip = shape.sideStrip = 0.3;
        shape.sigma = 0.5 * options.sigma;
        steps.push_back(shape);
        shape.endStrip = shape.sideStrip = 0.15;
        shape.sigma = 0.25 * options.sigma;
        steps.push_back(shape);
    }
    return steps;
}

// A start whose hits lie mostly in the surround would gain by leaving them altogether.
OrientedBox betterStart(const Hits& hits, const Eigen::Vector2d& sensor, const FilterShape& shape,
                        const OrientedBox& start)
{
    const OrientedBox moved = movedOntoHits(start, hits, sensor);
    const KernelHits kernel = kernelHits(hits, start.centre());
    const auto match = [&](const OrientedBox& box)
    { return kernelResponse(kernel, shape, box, bearingToSensor(box, sensor)).value; };
    return match(moved) > match(start) ? moved : start;
}

// A step of this length ends the search for where the lines start, m and rad.
constexpr double kBeforeLines = 0.03;

// From the filter's box, up to half a metre too large, to the faces: first with a wide view of
// what lies on them, then with a narrow one.
std::optional<FaceBox> onFaces(const Hits& hits, const OrientedBox& fitted, FaceSet seen,
                               const Eigen::Vector2d& sensor, const MeasureOptions& options)
{
    FaceLineOptions wide;
    wide.rangeNoise = options.rangeNoise;
    wide.gate = 0.7;
    wide.sigma = 0.2;
    wide.iterations = 4;
    const auto first = fitFaceLines(hits, fitted, seen, sensor, wide);
    if (!first) return std::nullopt;
    const OrientedBox box = onFaceLines(fitted, *first);
    FaceLineOptions narrow;
    narrow.rangeNoise = options.rangeNoise;
    const auto lines = fitFaceLines(hits, box, seen, sensor, narrow);
    if (!lines) return std::nullopt;
    return boxFromFaces(hits, box, seen, sensor, *lines, options.hiddenFaceSigma, options.fit);
}
}  // namespace

FaceSet facesSeen(const Hits& hits, const OrientedBox& box, const Eigen::Vector2d& sensor,
                  const MeasureOptions& options)
{
    const FilterShape shape = FilterShape::paper();
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const double l = 0.5 * box.length;
    const double w = 0.5 * box.width;
    // Angle at which the ray meets the face, over its middle.
    const bool front = view.x() > 0.0;
    const bool left = view.y() > 0.0;
    const double endAngle = std::atan2(std::abs(view.x()) - l, std::abs(view.y()));
    const double sideAngle = std::atan2(std::abs(view.y()) - w, std::abs(view.x()));
    double endHits = 0.0;
    double sideHits = 0.0;
    const double c = std::cos(box.heading);
    const double s = std::sin(box.heading);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double dx = hits.x[i] - box.x;
        const double dy = hits.y[i] - box.y;
        // Depth of the hit behind the face towards the sensor, negative in front of it.
        const double depthEnd = l - (front ? 1.0 : -1.0) * (c * dx + s * dy);
        const double depthSide = w - (left ? 1.0 : -1.0) * (c * dy - s * dx);
        if (depthEnd < -shape.endMargin || depthSide < -shape.sideMargin) continue;
        if (depthEnd > box.length + shape.endMargin || depthSide > box.width + shape.sideMargin)
            continue;
        const bool inEnd = depthEnd < shape.endStrip;
        const bool inSide = depthSide < shape.sideStrip;
        if (inEnd && !inSide) endHits += hits.weight[i];
        if (inSide && !inEnd) sideHits += hits.weight[i];
    }
    FaceSet seen;
    if (endAngle > options.minFaceAngle && endHits >= options.minFaceHits)
        seen.add(front ? Face::Front : Face::Back);
    if (sideAngle > options.minFaceAngle && sideHits >= options.minFaceHits)
        seen.add(left ? Face::Left : Face::Right);
    return seen;
}

Measurement measureTarget(const Hits& hits, const Eigen::Vector2d& sensor, const OrientedBox& start,
                          const MeasureOptions& options,
                          const std::optional<Eigen::Vector2d>& knownLengthWidth)
{
    std::optional<SizePrior> prior;
    if (knownLengthWidth && options.sizePriorWeight > 0.0)
        prior = SizePrior{knownLengthWidth->x(), knownLengthWidth->y(), options.sizePriorWeight,
                          options.sizePriorWeight};
    const std::vector<FilterShape> steps = filterSteps(options);
    FitOptions fitOptions = options.fit;
    const bool linesFollow = options.filter == FilterKind::FaceLines;
    if (linesFollow) fitOptions.tolerance = std::max(fitOptions.tolerance, kBeforeLines);
    Measurement m;
    m.box = betterStart(hits, sensor, steps.front(), start);
    m.hits = static_cast<int>(std::lround(hits.totalWeight));
    Fit fit;
    for (const FilterShape& shape : steps)
    {
        fit = fitMatchedFilter(hits, shape, sensor, m.box, fitOptions, prior);
        m.box = fit.box;
        m.iterations += fit.iterations;
    }
    m.match = fit.match;
    m.converged = fit.converged;
    m.facesSeen = facesSeen(hits, m.box, sensor, options);
    if (linesFollow)
    {
        if (const auto faces = onFaces(hits, m.box, m.facesSeen, sensor, options))
        {
            m.box = faces->box;
            m.covariance = faces->covariance;
            return m;
        }
    }
    m.covariance = fitCovariance(hits, steps.back(), m.box, fit.phi, options.hitSigma);
    if (options.reachOverHits) m.box = reachingOverHits(hits, m.box, m.facesSeen, sensor);
    return m;
}

}  // namespace vdamf
