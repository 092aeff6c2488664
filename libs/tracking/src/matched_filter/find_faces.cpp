// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/find_faces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "matched_filter/densest_corner.h"

namespace vdamf
{
namespace
{
// Lines that hold this share of the hits are taken without a second look. Upright walls without
// clutter have 0.75 and more, vehicles on the road from 0.2 to 0.8.
constexpr double kEnough = 0.7;
// Others have to hold so many times the hits: the filter sees more of the vehicle than its lines.
constexpr double kClearlyMore = 1.1;
// Faces with a tenth fewer hits than the best ones are half as likely.
constexpr double kSharpness = 6.0;

struct Tried
{
    FoundFaces faces;
    double share = 0.0;  // of the hits that lie on the lines
};

// From the filter's box, up to half a metre too large, to the faces: first with a wide view of
// what lies on them, then with a narrow one.
std::optional<Tried> facesFrom(const OrientedBox& box, const Hits& hits,
                               const Eigen::Vector2d& sensor, const MeasureOptions& options)
{
    const FaceSet seen = facesSeen(hits, box, sensor, options);
    FaceLineOptions wide;
    wide.rangeNoise = options.rangeNoise;
    wide.gate = 0.7;
    wide.sigma = 0.2;
    wide.iterations = 4;
    const auto first = fitFaceLines(hits, box, seen, sensor, wide);
    if (!first) return std::nullopt;
    const OrientedBox closer = onFaceLines(box, *first);
    FaceLineOptions narrow;
    narrow.rangeNoise = options.rangeNoise;
    narrow.bodyDepth = options.bodyDepth;
    const auto lines = fitFaceLines(hits, closer, seen, sensor, narrow);
    if (!lines) return std::nullopt;
    const double scale = std::max(0.06, 1.5 * options.rangeNoise);
    const OrientedBox onHits = onFaceLines(closer, throughHits(*lines));
    return Tried{
        {boxFromFaces(hits, closer, seen, sensor, *lines, options.hiddenFaceSigma, options.fit),
         seen},
        shareOnNearFaces(hits, onHits, sensor, scale)};
}

// By how much the second box lies elsewhere: (x, y, heading, length, width).
Vector5d difference(const OrientedBox& a, const OrientedBox& b)
{
    Vector5d d;
    d << b.x - a.x, b.y - a.y, wrapAngle(b.heading - a.heading), b.length - a.length,
        b.width - a.width;
    return d;
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
        if (count_ == 0 || found->share > kClearlyMore * tried_[best_].share) best_ = count_;
        tried_[count_++] = *found;
    }

    bool areEnough() const { return count_ > 0 && tried_[best_].share >= kEnough; }

    // The best ones; where others hold nearly as many hits, with their distance in the covariance.
    std::optional<FoundFaces> best() const
    {
        if (count_ == 0) return std::nullopt;
        FoundFaces result = tried_[best_].faces;
        for (std::size_t k = 0; k < count_; ++k)
        {
            const double ratio = tried_[k].share / std::max(1e-6, tried_[best_].share);
            const double odds = std::min(1.0, std::pow(ratio, kSharpness));
            const Vector5d off = difference(result.fit.box, tried_[k].faces.fit.box);
            result.fit.covariance += odds / (1.0 + odds) * off * off.transpose();
        }
        return result;
    }

private:
    const Hits& hits_;
    const Eigen::Vector2d& sensor_;
    const MeasureOptions& options_;
    std::array<Tried, 3> tried_;
    std::size_t count_ = 0;
    std::size_t best_ = 0;
};
}  // namespace

std::optional<FoundFaces> findFaces(const Hits& hits, const OrientedBox& fitted,
                                    const OrientedBox& start, const Eigen::Vector2d& sensor,
                                    const MeasureOptions& options)
{
    TriedFaces faces(hits, sensor, options);
    faces.tryFrom(fitted);
    if (!faces.areEnough()) faces.tryFrom(start);
    if (!faces.areEnough()) faces.tryFrom(boxInDensestCorner(hits, start, sensor));
    return faces.best();
}

}  // namespace vdamf
