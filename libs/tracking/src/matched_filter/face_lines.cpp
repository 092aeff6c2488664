// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/face_lines.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "matched_filter/face_hull.h"
#include "matched_filter/near_faces.h"
#include "matched_filter/range_noise.h"
#include "types/cholesky.h"

namespace vdamf
{
namespace
{
// Of LADARs, m.
constexpr double kUsualNoise = 0.03;
// A step this small ends the reweighting, m and rad.
constexpr double kSettled = 5e-4;
// The prior of the scale, twice the sensor's noise, counts as so many hits.
constexpr double kPriorHits = 4.0;

// (turn, outwards place of the end, of the side, of the upper side).
struct Lines
{
    Eigen::Vector4d q = Eigen::Vector4d::Zero();
    Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
    Eigen::Vector2d ofTurn = Eigen::Vector2d::Zero();  // what end and side tell of the turn
    double sigma = 0.0;
    LineWeights weights = kTowardsHull;

    LineState state(int k) const { return {q(0), q(1 + k), sigma, weights}; }
};

// One step of reweighted least squares; whether it still moved something.
bool reweigh(const NearFaces& faces, double rangeNoise, Lines& lines)
{
    // The weak hold of the heading keeps a short row of hits from turning freely.
    Eigen::Matrix4d information = Eigen::Vector4d(1e-3, 1e-9, 1e-9, 1e-9).asDiagonal();
    Eigen::Vector4d pull = Eigen::Vector4d::Zero();
    lines.ofTurn.setZero();
    double squares = kPriorHits * 4.0 * rangeNoise * rangeNoise;
    double count = kPriorHits;
    double parameters = 1.0;
    for (int k = 0; k < static_cast<int>(faces.size()); ++k)
    {
        const NearFace& face = faces[static_cast<std::size_t>(k)];
        if (face.hits.empty())
        {
            information(1 + k, 1 + k) = 1.0;
            continue;
        }
        parameters += 1.0;
        const LineSums sums = lineSums(face, lines.state(k));
        information(0, 0) += sums.waa;
        information(0, 1 + k) = information(1 + k, 0) = -sums.wa;
        information(1 + k, 1 + k) += sums.w;
        const int ofFace = std::min(k, static_cast<int>(kSideFace));  // upper sides are sides
        if (sums.w > 0.0) lines.ofTurn(ofFace) += sums.waa - sums.wa * sums.wa / sums.w;
        pull(0) -= sums.war;
        pull(1 + k) += sums.wr;
        squares += sums.squares;
        count += sums.count;
    }
    const Eigen::Vector4d step = Cholesky<4>(information).solve(pull);
    lines.q += step;
    lines.information = information;
    // For Gaussian residuals the weights keep this share of the variance.
    constexpr double kKept = kLineTuning * kLineTuning / (1.0 + kLineTuning * kLineTuning);
    const double shift = lines.weights.shift;
    const double next =
        std::sqrt(squares / std::max(1.0, count - parameters) / kKept / (1.0 + shift * shift));
    const double before = lines.sigma;
    lines.sigma = std::clamp(next, 0.5 * before, 0.2);
    return step.cwiseAbs().maxCoeff() > kSettled || std::abs(lines.sigma - before) > 0.05 * before;
}

// Whether the hits scatter no more than the sensor's noise makes them.
bool arePlanes(const NearFaces& faces, const Lines& lines)
{
    constexpr double kShareOfNoise = 0.6;
    double noise = 0.0;
    double hits = 0.0;
    for (const NearFace& face : faces)
    {
        if (face.hits.empty()) continue;
        noise += face.weight * face.noise * face.noise;
        hits += face.weight;
    }
    return noise > kShareOfNoise * hits * lines.sigma * lines.sigma;
}

Face faceAt(int axis, double sign)
{
    if (axis == 0) return sign > 0.0 ? Face::Front : Face::Back;
    return sign > 0.0 ? Face::Left : Face::Right;
}

// By how much the side of a body seems to turn where it is seen at a grazing angle: it is nearest
// to the sensor where it recedes most. Measured on simulated and on recorded vehicles alike.
double turnOfSide(const Lines& lines, const OrientedBox& box, const Eigen::Vector2d& sensor,
                  double perTangent)
{
    constexpr double kLeastTangent = 0.08;
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const double before = std::max(0.0, std::abs(view.y()) - 0.5 * box.width);
    const double tangent = std::max(kLeastTangent, before / std::max(0.1, std::abs(view.x())));
    const double share = lines.ofTurn(1) / std::max(1e-9, lines.ofTurn.sum());
    return std::copysign(share * perTangent / tangent, view.x() * view.y());
}

FaceLines throughHits(const NearFaces& faces, const Lines& lines)
{
    FaceLines result;
    result.turn = lines.q(0);
    result.end = {!faces[0].hits.empty(), faces[0].sign * lines.q(1), 0.0, 0.0};
    result.side = {!faces[1].hits.empty(), faces[1].sign * lines.q(2), 0.0, 0.0};
    return result;
}
}  // namespace

std::optional<FaceLines> fitFaceLines(const Hits& hits, const OrientedBox& box, FaceSet seen,
                                      const Eigen::Vector2d& sensor, const FaceLineOptions& o)
{
    const bool isTold = o.rangeNoise > 0.0;
    double rangeNoise = isTold ? o.rangeNoise : kUsualNoise;
    NearFaces faces = nearFaces(hits, box, seen, sensor,
                                {o.gate, o.corner, isTold ? o.rangeNoise : 1.0, o.minHits});
    if (faces[0].hits.empty() && faces[1].hits.empty()) return std::nullopt;
    Lines lines;
    lines.q = {0.0, 0.5 * box.length, 0.5 * box.width, 0.5 * box.width};
    lines.sigma = o.sigma;
    for (int i = 0; i < o.iterations && reweigh(faces, rangeNoise, lines);) ++i;
    if (!o.toHull) return throughHits(faces, lines);
    if (!isTold)
    {
        rangeNoise = estimatedRangeNoise(faces, lines.state(0), lines.state(1));
        for (NearFace& face : faces) face.noise *= rangeNoise;
    }
    const bool isPlane = o.tellPlanes && arePlanes(faces, lines);
    if (isPlane)
    {
        constexpr int kMore = 2;
        lines.weights = kThroughHits;
        for (int i = 0; i < kMore && reweigh(faces, rangeNoise, lines);) ++i;
    }
    FaceLines result;
    result.rangeNoise = rangeNoise;
    result.turn = lines.q(0);
    result.arePlanes = isPlane;
    if (!isPlane && !faces[1].hits.empty())
        result.turn += turnOfSide(lines, box, sensor, o.hull.sideTurn * o.bodyDepth);
    const Eigen::Matrix4d inverse = lines.information.inverse();
    result.covariance =
        lines.weights.efficiency * lines.sigma * lines.sigma * inverse.topLeftCorner<3, 3>();
    for (int k = 0; k < 2; ++k)
    {
        const NearFace& face = faces[static_cast<std::size_t>(k)];
        FaceLine& line = k == 0 ? result.end : result.side;
        if (face.hits.empty())
        {
            result.covariance.row(1 + k).setZero();
            result.covariance.col(1 + k).setZero();
            continue;
        }
        const BodyPrior body{hits.heights, faceAt(k, face.sign), o.bodyDepth, o.hull, o.errors};
        const Hull hull = hullOf(departureOf(face, lines.state(k)), face, lines.state(k), body);
        line.exists = true;
        line.shape = hull.shape;
        line.outside = hull.outwards;
        line.at = face.sign * (lines.q(1 + k) + line.outside);
        // The two of a face with a sign: places are along the axes from here on.
        result.covariance.row(1 + k) *= face.sign;
        result.covariance.col(1 + k) *= face.sign;
        result.covariance(1 + k, 1 + k) += hull.error * hull.error;
        if (k == 1 || faces[1].hits.empty())
            result.covariance(0, 0) += hull.turnError * hull.turnError;
    }
    return result;
}

FaceLines throughHits(const FaceLines& lines)
{
    FaceLines moved = lines;
    for (FaceLine* line : {&moved.end, &moved.side})
    {
        line->at -= line->at < 0.0 ? -line->outside : line->outside;
        line->outside = 0.0;
    }
    return moved;
}

OrientedBox onFaceLines(const OrientedBox& box, const FaceLines& lines)
{
    OrientedBox b = box;
    b.heading = wrapAngle(box.heading + lines.turn);
    const auto grown = [](const FaceLine& line, double size)
    { return line.exists ? std::abs(line.at) - 0.5 * size : 0.0; };
    const double length = grown(lines.end, box.length);
    const double width = grown(lines.side, box.width);
    const Eigen::Vector2d middle(0.5 * std::copysign(1.0, lines.end.at) * length,
                                 0.5 * std::copysign(1.0, lines.side.at) * width);
    const Eigen::Vector2d centre = box.centre() + rotation(b.heading) * middle;
    b.x = centre.x();
    b.y = centre.y();
    b.length += length;
    b.width += width;
    return b;
}

}  // namespace vdamf
