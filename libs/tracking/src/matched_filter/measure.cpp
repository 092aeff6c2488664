// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/measure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "matched_filter/face_extent.h"
#include "matched_filter/find_faces.h"
#include "matched_filter/insets.h"
#include "matched_filter/match_kernel.h"
#include "vdamf/tracking/matched_filter/covariance.h"

namespace vdamf
{
namespace
{
// The filters to run in turn, each from the result of the one before.
std::vector<FilterShape> filterSteps(const MeasureOptions& options)
{
    FilterShape shape = options.parameters.shape;
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

// The filter has to come within reach of the lines only.
FitOptions beforeLines(const FitOptions& options)
{
    constexpr double kTolerance = 0.15;  // m and rad
    // What goes on longer moves a face that no hits show.
    constexpr int kIterations = 8;
    FitOptions coarse = options;
    coarse.tolerance = std::max(options.tolerance, kTolerance);
    coarse.maxIterations = std::min(options.maxIterations, kIterations);
    return coarse;
}

// What is known where no face is: nothing shows any of them, and any heading near the fitted one
// may be right.
Matrix5d withNoFaceSeen(const Matrix5d& covariance, double heading, double unseenSigma)
{
    constexpr double kHeadingSigma = 0.25;  // rad
    const double each = unseenSigma * unseenSigma;
    Vector5d unseen;
    unseen << 0.5 * each, 0.5 * each, kHeadingSigma * kHeadingSigma, 2.0 * each, 2.0 * each;
    // An end may lie anywhere along the vehicle's length, a side along its smaller width.
    constexpr double kSideToEnd = 0.25;
    unseen(1) *= kSideToEnd;
    unseen(4) *= kSideToEnd;
    Matrix5d all = covariance;
    all += unseen.asDiagonal();
    const Eigen::Matrix2d toWorld = rotation(heading);
    all.topLeftCorner<2, 2>() = covariance.topLeftCorner<2, 2>() +
                                toWorld * unseen.head<2>().asDiagonal() * toWorld.transpose();
    return all;
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

MeasureOptions withFilter(const MeasureOptions& options, const FilterParameters& parameters)
{
    MeasureOptions own = options;
    own.parameters = parameters;
    own.sigma = parameters.shape.sigma;
    own.hitSigma = parameters.errors.hitSigma;
    return own;
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
    const bool linesFollow = options.filter == FilterKind::FaceLines;
    const OrientedBox onHits = betterStart(hits, sensor, steps.front(), start);
    Measurement m;
    m.box = onHits;
    m.hits = static_cast<int>(std::lround(hits.totalWeight));
    Fit fit;
    const auto optimise = [&](const FilterShape& shape, const FitOptions& fitOptions)
    {
        fit = fitMatchedFilter(hits, shape, sensor, m.box, fitOptions, prior);
        m.box = fit.box;
        m.iterations += fit.iterations;
        m.match = fit.match;
        m.converged = fit.converged;
    };
    const FitOptions first = linesFollow ? beforeLines(options.fit) : options.fit;
    for (const FilterShape& shape : steps) optimise(shape, first);
    if (linesFollow)
    {
        const auto filterFrom = [&](const OrientedBox& from)
        { return fitMatchedFilter(hits, steps.front(), sensor, from, first, prior).box; };
        if (const auto faces = findFaces(hits, m.box, start, filterFrom, sensor, options))
        {
            m.box = faces->fit.box;
            m.covariance = faces->fit.covariance;
            m.facesSeen = faces->seen;
            // The filter may stop early for the lines, but not where the options cut it short.
            m.converged |= first.maxIterations < options.fit.maxIterations;
            return m;
        }
        optimise(steps.front(), options.fit);
    }
    m.facesSeen = facesSeen(hits, m.box, sensor, options);
    const OrientedBox fitted = m.box;
    if (options.filter == FilterKind::PaperInset)
        m.box = withInsets(m.box, m.facesSeen, sensor, options.parameters.insets);
    m.covariance = fitCovariance(hits, steps.back(), fitted, fit.phi, options.hitSigma);
    if (linesFollow)
        m.covariance = withNoFaceSeen(m.covariance, m.box.heading, options.hiddenFaceSigma);
    if (options.reachOverHits) m.box = reachingOverHits(hits, m.box, m.facesSeen, sensor);
    return m;
}

}  // namespace vdamf
