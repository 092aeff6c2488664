// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/measure.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "matched_filter/face_extent.h"
#include "matched_filter/find_faces.h"
#include "matched_filter/insets.h"
#include "matched_filter/match_kernel.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"
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

// The matched filter alone, from a start to its box.
class FilterRun
{
public:
    FilterRun(const Hits& hits, const Eigen::Vector2d& sensor,
              const std::optional<SizePrior>& prior, std::vector<FilterShape> steps)
        : hits_(hits), sensor_(sensor), prior_(prior), steps_(std::move(steps))
    {
    }

    const FilterShape& widest() const { return steps_.front(); }
    const FilterShape& narrowest() const { return steps_.back(); }

    /// Through all steps; counts the iterations of all of them.
    Fit from(const OrientedBox& start, const FitOptions& options) const
    {
        Fit fit;
        fit.box = start;
        int iterations = 0;
        for (const FilterShape& shape : steps_)
        {
            fit = fitMatchedFilter(hits_, shape, sensor_, fit.box, options, prior_);
            iterations += fit.iterations;
        }
        fit.iterations = iterations;
        return fit;
    }

    /// A start whose hits lie mostly in the surround would gain by leaving them altogether; one
    /// that lies about where they are does not.
    OrientedBox betterStart(const OrientedBox& start) const
    {
        constexpr double kAbout = 0.1;  // m
        const OrientedBox moved = movedOntoHits(start, hits_, sensor_);
        if ((moved.centre() - start.centre()).norm() < kAbout) return start;
        const KernelHits kernel = kernelHits(hits_, start.centre());
        const auto match = [&](const OrientedBox& box)
        { return kernelResponse(kernel, widest(), box, bearingToSensor(box, sensor_)).value; };
        return match(moved) > match(start) ? moved : start;
    }

private:
    const Hits& hits_;
    const Eigen::Vector2d& sensor_;
    std::optional<SizePrior> prior_;
    std::vector<FilterShape> steps_;
};

bool isSamePlace(const OrientedBox& a, const OrientedBox& b)
{
    return a.x == b.x && a.y == b.y;
}

// What a filter run has come to, and from where.
struct FilterResult
{
    OrientedBox start;  // that was asked for
    OrientedBox from;   // that or where the hits are
    Fit fit;
};

// From the start; where that is not enough, from where the hits are as well.
FilterResult filterResult(const FilterRun& filter, const Hits& hits, const Eigen::Vector2d& sensor,
                          const OrientedBox& start, const FitOptions& options, double enoughMatch)
{
    FilterResult result{start, filter.betterStart(start), {}};
    result.fit = filter.from(result.from, options);
    if (result.fit.match > enoughMatch) return result;
    const OrientedBox moved = movedOntoHits(start, hits, sensor);
    if (isSamePlace(moved, result.from)) return result;
    Fit other = filter.from(moved, options);
    other.iterations += result.fit.iterations;
    result.fit.iterations = other.iterations;
    return other.match > result.fit.match ? FilterResult{moved, moved, other} : result;
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

// Weights of the hits in the strips of the two faces towards the sensor.
struct StripHits
{
    double end = 0.0;
    double side = 0.0;
};

// The faces lie where the signs say along the axes of the box. A hit in both strips is in neither.
StripHits hitsInStrips(const Hits& hits, const OrientedBox& box, double signX, double signY,
                       const FilterShape& shape)
{
    StripHits strips;
    const Direction forward = directionOf(box.heading);
    inWideLanes([
        =, c = forward.cos, s = forward.sin, size = hits.size(), px = hits.x.data(),
        py = hits.y.data(), weights = hits.weight.data(), result = &strips
    ]() __attribute__((always_inline)) {
        Doubles ends{};
        Doubles sides{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Doubles dx;
            Doubles dy;
            Doubles weight;
            load(dx, px + first, count);
            load(dy, py + first, count);
            load(weight, weights + first, count);
            dx -= box.x;
            dy -= box.y;
            // Behind the faces, negative in front of them.
            const Doubles end = 0.5 * box.length - signX * (c * dx + s * dy);
            const Doubles side = 0.5 * box.width - signY * (c * dy - s * dx);
            const auto beside = (end >= -shape.endMargin) & (end <= box.length + shape.endMargin) &
                                (side >= -shape.sideMargin) &
                                (side <= box.width + shape.sideMargin);
            const auto inEnd = end < shape.endStrip;
            const auto inSide = side < shape.sideStrip;
            ends += (beside & inEnd & ~inSide) ? weight : Doubles{};
            sides += (beside & inSide & ~inEnd) ? weight : Doubles{};
        };
        inGroupsOf<kLanes<Doubles>>(size, add);
        *result = {sumOf(ends), sumOf(sides)};
    });
    return strips;
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
    const bool front = view.x() > 0.0;
    const bool left = view.y() > 0.0;
    // Whether a ray meets a face, over its middle, at more than the least angle.
    const auto shows = [](double before, double beside, const Direction& least)
    { return before * least.cos > beside * least.sin; };
    const bool showsEnd =
        shows(std::abs(view.x()) - l, std::abs(view.y()), directionOf(options.minEndAngle));
    const bool showsSide =
        shows(std::abs(view.y()) - w, std::abs(view.x()), directionOf(options.minSideAngle));
    const StripHits strips = hitsInStrips(hits, box, front ? 1.0 : -1.0, left ? 1.0 : -1.0, shape);
    FaceSet seen;
    if (showsEnd && strips.end >= options.minFaceHits) seen.add(front ? Face::Front : Face::Back);
    if (showsSide && strips.side >= options.minFaceHits) seen.add(left ? Face::Left : Face::Right);
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
                          const std::optional<Eigen::Vector2d>& knownLengthWidth,
                          const SearchEffort& effort)
{
    std::optional<SizePrior> prior;
    if (knownLengthWidth && options.sizePriorWeight > 0.0)
        prior = SizePrior{knownLengthWidth->x(), knownLengthWidth->y(), options.sizePriorWeight,
                          options.sizePriorWeight};
    const FilterRun filter(hits, sensor, prior, filterSteps(options));
    const bool linesFollow = options.filter == FilterKind::FaceLines;
    const FitOptions first = linesFollow ? beforeLines(options.fit) : options.fit;
    const auto [begin, from, coarse] =
        filterResult(filter, hits, sensor, start, first, effort.enoughMatch);
    Fit fit = coarse;
    Measurement m;
    m.hits = static_cast<int>(std::lround(hits.totalWeight));
    const auto take = [&m](const Fit& result)
    {
        m.box = result.box;
        m.iterations += result.iterations;
        m.match = result.match;
        m.converged = result.converged;
    };
    take(fit);
    if (linesFollow)
    {
        FaceSearch search{m.box, begin, {}, effort.isFirstTaken};
        if (!isSamePlace(begin, from))
            search.filterFromStart = [&, &box = begin] { return filter.from(box, first).box; };
        if (const auto faces = findFaces(hits, search, sensor, options))
        {
            m.box = faces->fit.box;
            m.covariance = faces->fit.covariance;
            m.facesSeen = faces->seen;
            // The filter may stop early for the lines, but not where the options cut it short.
            m.converged |= first.maxIterations < options.fit.maxIterations;
            return m;
        }
        if (!effort.isFirstTaken) take(fit = filter.from(m.box, options.fit));
    }
    m.facesSeen = facesSeen(hits, m.box, sensor, options);
    const OrientedBox fitted = m.box;
    if (options.filter == FilterKind::PaperInset)
        m.box = withInsets(m.box, m.facesSeen, sensor, options.parameters.insets);
    // What is added where no face is seen is more by far.
    if (!linesFollow || !effort.isFirstTaken)
        m.covariance = fitCovariance(hits, filter.narrowest(), fitted, fit.phi, options.hitSigma);
    if (linesFollow)
        m.covariance = withNoFaceSeen(m.covariance, m.box.heading, options.hiddenFaceSigma);
    if (options.reachOverHits) m.box = reachingOverHits(hits, m.box, m.facesSeen, sensor);
    return m;
}

}  // namespace vdamf
