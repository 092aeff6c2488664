// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/find_faces.h"

#include <algorithm>
#include <cmath>

#include "matched_filter/body_profile.h"
#include "matched_filter/corner_check.h"
#include "matched_filter/densest_corner.h"
#include "types/box_changes.h"

namespace vdamf
{
namespace
{
// Lines that hold this share of the hits are taken without a second look. Upright walls without
// clutter have 0.75 and more, vehicles on the road from 0.2 to 0.8.
constexpr double kEnough = 0.7;
// The start costs little to try.
constexpr double kEnoughWithoutStart = 0.8;
// Others have to hold so many times the hits: the filter sees more of the vehicle than its lines.
constexpr double kClearlyMore = 1.05;
// What holds only after one of two faces was left out is taken for so much less.
constexpr double kMisplaced = 0.8;
// Of bodies, hits off the lines tell how far they depart from a box, and in what other ways than
// those reckoned with. Lines that hold fewer of the hits than kDoubtful may be any row of them. By
// the errors on the drives.
constexpr double kDoubtful = 0.45;
struct Doubt
{
    double body;   // error (rad, m) over the square of the share off the lines
    double wrong;  // error where half of kDoubtful is left
};
constexpr double kTurnWrong = 0.15;
constexpr double kEndWrong = 0.3;
constexpr double kSideWrong = 0.12;

double varianceOf(const Doubt& doubt, double share, bool isBody)
{
    const double off = 1.0 - share;
    const double missing = std::max(0.0, 2.0 * (kDoubtful - share) / kDoubtful);
    const double body = isBody ? doubt.body * off * off : 0.0;
    const double wrong = doubt.wrong * missing * missing;
    return body * body + wrong * wrong;
}

// Faces with a tenth fewer hits than the best ones are half as likely.
constexpr double kSharpness = 6.0;

struct Tried
{
    FoundFaces faces;
    OrientedBox onHits;  // with its near faces where the hits are, not where the hull is
    double share = 0.0;  // of the hits that lie on the lines
};

// From the filter's box, up to half a metre too large, to the faces: first with a wide view of
// what lies on them, then with a narrow one.
std::optional<Tried> linesFrom(const OrientedBox& box, FaceSet seen, const Hits& hits,
                               const Eigen::Vector2d& sensor, const MeasureOptions& options)
{
    FaceLineOptions wide;
    wide.rangeNoise = options.rangeNoise;
    const FilterParameters& parameters = options.parameters;
    wide.gate = parameters.lines.reach;
    wide.sigma = parameters.lines.reachSigma;
    wide.corner = parameters.lines.corner;
    wide.toHull = false;
    const auto first = fitFaceLines(hits, box, seen, sensor, wide);
    if (!first) return std::nullopt;
    const OrientedBox closer = onFaceLines(box, *first);
    FaceLineOptions narrow;
    narrow.rangeNoise = options.rangeNoise;
    narrow.gate = parameters.lines.gate;
    narrow.sigma = parameters.lines.gateSigma;
    narrow.corner = parameters.lines.corner;
    narrow.hull = parameters.hull;
    narrow.errors = parameters.errors;
    narrow.bodyDepth = options.bodyDepth;
    narrow.tellPlanes = true;
    const auto lines = fitFaceLines(hits, closer, seen, sensor, narrow);
    if (!lines) return std::nullopt;
    const double scale = std::max(0.06, 1.5 * lines->rangeNoise);
    if (!lines->end.exists)
    {
        seen.remove(Face::Front);
        seen.remove(Face::Back);
    }
    if (!lines->side.exists)
    {
        seen.remove(Face::Left);
        seen.remove(Face::Right);
    }
    Tried tried;
    tried.onHits = onFaceLines(closer, throughHits(*lines));
    tried.faces = {boxFromFaces(hits, closer, seen, sensor, *lines, options), seen};
    tried.share = shareOnNearFaces(hits, tried.onHits, sensor, scale);
    return tried;
}

// The same; a face that cannot be one of the vehicle's is left out.
std::optional<Tried> facesFrom(const OrientedBox& box, const Hits& hits,
                               const Eigen::Vector2d& sensor, const MeasureOptions& options)
{
    FaceSet seen = facesSeen(hits, box, sensor, options);
    auto tried = linesFrom(box, seen, hits, sensor, options);
    if (!tried) return std::nullopt;
    const auto misplaced = misplacedFace(hits, tried->onHits, seen);
    if (!misplaced) return tried;
    seen.remove(*misplaced);
    auto rest = linesFrom(box, seen, hits, sensor, options);
    if (!rest) return std::nullopt;
    rest->share *= kMisplaced;
    return rest;
}

// By how much the second box lies elsewhere: (x, y, heading, length, width).
Vector5d difference(const OrientedBox& a, const OrientedBox& b)
{
    Vector5d d;
    d << b.x - a.x, b.y - a.y, wrapAngle(b.heading - a.heading), b.length - a.length,
        b.width - a.width;
    return d;
}

// What is to be added where few hits lie on the faces.
Matrix5d doubtOf(const FoundFaces& faces, double share, bool isBody, const ErrorParameters& errors)
{
    Matrix5d covariance = Matrix5d::Zero();
    covariance(2, 2) = varianceOf({errors.turnDoubt, kTurnWrong}, share, isBody);
    const Eigen::Matrix2d axes = rotation(faces.fit.box.heading);
    for (const int axis : {0, 1})
    {
        if (!faces.seen.seesAcross(axis)) continue;
        const Vector5d change = byFace(axes, axis, faces.seen.has(kFaceAt[axis][1]) ? 1 : 0);
        const Doubt doubt =
            axis == 0 ? Doubt{errors.endDoubt, kEndWrong} : Doubt{errors.sideDoubt, kSideWrong};
        covariance += varianceOf(doubt, share, isBody) * change * change.transpose();
    }
    return covariance;
}

// How far hits lie before the side of a car, where a sensor that looks down on its roof sees
// nothing else of it: such a side may be a row of hits along bonnet or boot. RMS over all hits, m.
double reachBeforeSide(const Hits& hits, const OrientedBox& box, FaceSet seen)
{
    constexpr double kRoof = 0.1;     // share of the hits that tells so
    constexpr double kBefore = 0.25;  // m: mirrors are as well
    const bool isSideAlone = seen.seesSide() && !seen.seesEnd();
    if (!isSideAlone || !isCarWithHeights(hits)) return 0.0;
    const Eigen::Vector2d outwards =
        (seen.has(Face::Left) ? 1.0 : -1.0) * rotation(box.heading).col(1);
    double squares = 0.0;
    double onRoof = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double before =
            outwards.dot(Eigen::Vector2d(hits.x[i], hits.y[i]) - box.centre()) - 0.5 * box.width;
        if (before > kBefore) squares += hits.weight[i] * before * before;
        if (hits.height[i] > kCarRoof) onRoof += hits.weight[i];
    }
    return onRoof < kRoof * hits.totalWeight ? 0.0 : std::sqrt(squares / hits.totalWeight);
}

// All that was tried, with the shares of the hits on the faces.
class TriedFaces
{
public:
    TriedFaces(const Hits& hits, const Eigen::Vector2d& sensor, const MeasureOptions& options)
        : hits_(hits), sensor_(sensor), options_(options)
    {
    }

    void tryFrom(const OrientedBox& box)
    {
        const auto found = facesFrom(box, hits_, sensor_, options_);
        if (!found) return;
        if (tried_.empty() || found->share > kClearlyMore * tried_[best_].share)
            best_ = tried_.size();
        tried_.push_back(*found);
    }

    bool areEnough(double share) const { return !tried_.empty() && tried_[best_].share >= share; }

    // The best ones; where others hold nearly as many hits, with their distance in the covariance.
    std::optional<FoundFaces> best() const
    {
        if (tried_.empty()) return std::nullopt;
        FoundFaces result = tried_[best_].faces;
        for (const Tried& tried : tried_)
        {
            const double ratio = tried.share / std::max(1e-6, tried_[best_].share);
            const double odds = std::min(1.0, std::pow(ratio, kSharpness));
            const Vector5d off = difference(result.fit.box, tried.faces.fit.box);
            result.fit.covariance += odds / (1.0 + odds) * off * off.transpose();
        }
        const Tried& taken = tried_[best_];
        result.fit.covariance +=
            doubtOf(result, taken.share, options_.bodyDepth > 0.0, options_.parameters.errors);
        const double reach = reachBeforeSide(hits_, taken.onHits, result.seen);
        const Vector5d side = reach * byFace(rotation(result.fit.box.heading), 1,
                                             result.seen.has(Face::Left) ? 1 : 0);
        result.fit.covariance += side * side.transpose();
        return result;
    }

private:
    const Hits& hits_;
    const Eigen::Vector2d& sensor_;
    const MeasureOptions& options_;
    std::vector<Tried> tried_;
    std::size_t best_ = 0;
};
}  // namespace

std::optional<FoundFaces> findFaces(const Hits& hits, const FaceSearch& search,
                                    const Eigen::Vector2d& sensor, const MeasureOptions& options)
{
    TriedFaces faces(hits, sensor, options);
    faces.tryFrom(search.fitted);
    if (search.isFirstTaken) return faces.best();
    if (!faces.areEnough(kEnoughWithoutStart)) faces.tryFrom(search.start);
    if (search.filterFromStart && !faces.areEnough(kEnough))
        faces.tryFrom(search.filterFromStart());
    if (!faces.areEnough(kEnough)) faces.tryFrom(boxInDensestCorner(hits, search.start, sensor));
    return faces.best();
}

}  // namespace vdamf
