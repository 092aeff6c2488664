// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/face_extent.h"

#include <algorithm>
#include <vector>

namespace vdamf
{
namespace
{
constexpr double kFaceInFront = 0.3;       // m; a hit on a face lies at most this far before it ...
constexpr double kFaceBehind = 0.4;        // ... and this far behind
constexpr double kLargestGapOnFace = 1.0;  // m in a row of hits
constexpr double kTrimmed = 2.0;           // hits at the end of the row that do not count

// A hit near a face: how far out it lies along the face, and its weight.
struct OnFace
{
    double along;
    double weight;
};

// End of the row of hits that goes on from `end` outwards; `end` itself if none does.
double rowEnd(std::vector<OnFace> row, double end)
{
    std::sort(row.begin(), row.end(),
              [](const OnFace& a, const OnFace& b) { return a.along < b.along; });
    std::size_t last = 0;
    double reached = end;
    for (; last < row.size() && row[last].along <= reached + kLargestGapOnFace; ++last)
        reached = std::max(reached, row[last].along);
    double trimmed = 0.0;
    while (last > 0 && trimmed + row[last - 1].weight <= kTrimmed) trimmed += row[--last].weight;
    return last > 0 ? std::max(end, row[last - 1].along) : end;
}
}  // namespace

OrientedBox reachingOverHits(const Hits& hits, const OrientedBox& box, FaceSet seen,
                             const Eigen::Vector2d& sensor)
{
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const double half[2] = {0.5 * box.length, 0.5 * box.width};
    // Ends of the box along its axes, low and high.
    double ends[2][2] = {{-half[0], half[0]}, {-half[1], half[1]}};
    for (int axis = 0; axis < 2; ++axis)
    {
        const int across = 1 - axis;  // the face that runs along `axis` lies at an end of `across`
        if (!seen.seesAlong(axis)) continue;
        const double face = view(across) > 0.0 ? half[across] : -half[across];
        for (int side = 0; side < 2; ++side)
        {
            const double sign = signOfEnd(side);
            // An end that is seen itself is fitted by its own hits.
            if (seen.seesAcross(axis) && sign * view(axis) > 0.0) continue;
            std::vector<OnFace> row;
            for (std::size_t i = 0; i < hits.size(); ++i)
            {
                const Eigen::Vector2d p = toBoxFrame(box, {hits.x[i], hits.y[i]});
                const double depth = (view(across) > 0.0 ? 1.0 : -1.0) * (face - p(across));
                if (depth < -kFaceInFront || depth > kFaceBehind) continue;
                const double along = sign * p(axis);
                if (along > half[axis]) row.push_back({along, hits.weight[i]});
            }
            ends[axis][side] = sign * rowEnd(std::move(row), half[axis]);
        }
    }
    OrientedBox grown = box;
    const Eigen::Vector2d centre =
        box.centre() + rotation(box.heading) * Eigen::Vector2d(0.5 * (ends[0][0] + ends[0][1]),
                                                               0.5 * (ends[1][0] + ends[1][1]));
    grown.x = centre.x();
    grown.y = centre.y();
    grown.length = ends[0][1] - ends[0][0];
    grown.width = ends[1][1] - ends[1][0];
    return grown;
}

}  // namespace vdamf
