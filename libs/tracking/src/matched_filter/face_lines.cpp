// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/face_lines.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vdamf
{
namespace
{
// Welsch's weight exp(-r^2 / (2 k^2 sigma^2)) with this k has 95 % efficiency on Gaussian hits.
constexpr double kTuning = 2.11;
// Weight of hits inside of a line against those outside. Of Gaussian hits the line then lies
// kShift of their standard deviation outwards, and the hits outside of it have kOutside of their
// variance about it.
constexpr double kInside = 0.3;
constexpr double kShift = 0.481;
constexpr double kOutside = 0.69;
constexpr double kInsideShare = 1.48;  // and those inside of it
// From a line to the hull, in units of the departure outside of the line, and the error of that in
// units of the departures on both sides: by measurement on labelled and simulated vehicles
// (benchmarks/measurement).
constexpr double kToHull = 1.5;
constexpr double kHullError = 0.7;
constexpr double kTaperError = 0.2;
constexpr double kLeastError = 0.002;  // m
// Sides are flatter than ends.
constexpr double kSideDepth = 0.25;
// On average the hull lies so far outside of what is seen, in units of its error.
constexpr double kUnseenShift = 0.6;
// A step this small ends the reweighting, m and rad.
constexpr double kSettled = 5e-4;
// The prior of the scale counts as so many hits.
constexpr double kPriorHits = 4.0;

// A hit near a face: its coordinate across the face, positive outwards, and along it, both from the
// middle of the box.
struct FaceHit
{
    double outwards;
    double along;
    double weight;
    double spread;  // variance of the hits of its cell across the face, m^2
};

// One of the two faces towards the sensor with its hits.
struct NearFace
{
    std::vector<FaceHit> hits;
    double weight = 0.0;  // of all hits
    double sign = 1.0;    // +1 where it lies at the positive end of its axis
    double slope = 1.0;   // d outwards / d turn of a hit, over its place along
    double noise = 0.0;   // of the sensor, across the face, m
    double prior = 0.0;   // of the scatter's variance, m^2
};
using NearFaces = std::array<NearFace, 2>;  // end, side

NearFaces nearFaces(const Hits& hits, const OrientedBox& box, FaceSet seen,
                    const Eigen::Vector2d& sensor, const FaceLineOptions& o)
{
    const double c = std::cos(box.heading);
    const double s = std::sin(box.heading);
    const double signX = seen.has(Face::Front) ? 1.0 : -1.0;
    const double signY = seen.has(Face::Left) ? 1.0 : -1.0;
    const Eigen::Vector2d view = toBoxFrame(box, sensor).normalized();
    NearFaces faces;
    faces[0].sign = faces[0].slope = signX;
    faces[1].sign = signY;
    faces[1].slope = -signY;
    faces[0].noise = o.rangeNoise * std::abs(view.x());
    faces[1].noise = o.rangeNoise * std::abs(view.y());
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double dx = hits.x[i] - box.x;
        const double dy = hits.y[i] - box.y;
        const double x = c * dx + s * dy;
        const double y = c * dy - s * dx;
        const double behindEnd = 0.5 * box.length - signX * x;
        const double behindSide = 0.5 * box.width - signY * y;
        const bool beside = behindEnd > -o.gate && behindEnd < box.length + o.gate &&
                            behindSide > -o.gate && behindSide < box.width + o.gate;
        if (!beside) continue;
        if (seen.seesEnd() && behindEnd < o.gate && (!seen.seesSide() || behindSide > o.corner))
            faces[0].hits.push_back({signX * x, y, hits.weight[i], hits.varianceAlong(i, c, s)});
        else if (seen.seesSide() && behindSide < o.gate &&
                 (!seen.seesEnd() || behindEnd > o.corner))
            faces[1].hits.push_back({signY * y, x, hits.weight[i], hits.varianceAlong(i, -s, c)});
    }
    for (NearFace& face : faces)
    {
        face.prior = 4.0 * o.rangeNoise * o.rangeNoise;
        for (const FaceHit& hit : face.hits) face.weight += hit.weight;
        if (face.weight < o.minHits) face.hits.clear();
    }
    return faces;
}

// (turn, outwards place of the end, of the side); a hit's residual is outwards + slope turn along -
// place.
struct Lines
{
    Eigen::Vector3d q = Eigen::Vector3d::Zero();
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double sigma = 0.0;
};

double residual(const FaceHit& hit, const NearFace& face, double turn, double place)
{
    return hit.outwards + face.slope * turn * hit.along - place;
}

// exp(-u) by its limit (1 - u / 16)^16, in a tenth of the time: a little narrower, and nothing
// beyond five and a half of its widths.
double welsch(double u)
{
    const double base = std::max(0.0, 1.0 - u / 16.0);
    const double square = base * base;
    const double fourth = square * square;
    const double eighth = fourth * fourth;
    return eighth * eighth;
}

// One step of reweighted least squares; whether it still moved something.
bool reweigh(const NearFaces& faces, Lines& lines)
{
    const double perWidth = 1.0 / (2.0 * kTuning * kTuning * lines.sigma * lines.sigma);
    // The weak hold of the heading keeps a short row of hits from turning freely.
    Eigen::Matrix3d information = Eigen::Vector3d(1e-3, 1e-9, 1e-9).asDiagonal();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    double squares = 0.0;
    double count = 0.0;
    double parameters = 1.0;
    for (int k = 0; k < 2; ++k)
    {
        const NearFace& face = faces[static_cast<std::size_t>(k)];
        if (face.hits.empty())
        {
            information(1 + k, 1 + k) = 1.0;
            continue;
        }
        parameters += 1.0;
        double w = 0.0, wa = 0.0, waa = 0.0, wr = 0.0, war = 0.0;
        for (const FaceHit& hit : face.hits)
        {
            const double r = residual(hit, face, lines.q(0), lines.q(1 + k));
            const double even = hit.weight * welsch(r * r * perWidth);
            const double keep = r < 0.0 ? kInside * even : even;
            const double a = face.slope * hit.along;
            w += keep;
            wa += keep * a;
            waa += keep * a * a;
            wr += keep * r;
            war += keep * a * r;
            squares += even * (r * r + hit.spread);
            count += even;
        }
        information(0, 0) += waa;
        information(0, 1 + k) = information(1 + k, 0) = -wa;
        information(1 + k, 1 + k) += w;
        pull(0) -= war;
        pull(1 + k) += wr;
    }
    const Eigen::Vector3d step = information.ldlt().solve(pull);
    lines.q += step;
    lines.information = information;
    // For Gaussian residuals the weights keep this share of the variance.
    constexpr double kKept = kTuning * kTuning / (1.0 + kTuning * kTuning);
    squares += kPriorHits * faces[0].prior;
    count += kPriorHits;
    const double next =
        std::sqrt(squares / std::max(1.0, count - parameters) / kKept / (1.0 + kShift * kShift));
    const double before = lines.sigma;
    lines.sigma = std::clamp(next, 0.5 * before, 0.2);
    return step.cwiseAbs().maxCoeff() > kSettled || std::abs(lines.sigma - before) > 0.05 * before;
}

// How far a surface departs from a plane on either side of the line: what the hits there scatter
// more than the sensor's noise makes them, and more than chance makes of that. Standard deviations,
// m.
struct Departure
{
    double outside = 0.0;
    double inside = 0.0;
};

Departure departureOf(const NearFace& face, const Lines& lines, int k)
{
    constexpr double kFarthest = 2.5;  // sigmas outside of the line; beyond it are other things
    double squares[2] = {0.0, 0.0};
    double count[2] = {0.0, 0.0};
    for (const FaceHit& hit : face.hits)
    {
        const double r = residual(hit, face, lines.q(0), lines.q(1 + k));
        if (r > kFarthest * lines.sigma) continue;
        const int side = r < 0.0 ? 1 : 0;
        squares[side] += hit.weight * (r * r + hit.spread);
        count[side] += hit.weight;
    }
    const auto excess = [&](int side, double share)
    {
        if (count[side] < 3.0) return 0.0;
        const double byNoise =
            share * face.noise * face.noise * (1.0 + std::sqrt(2.0 / count[side]));
        return std::sqrt(std::max(0.0, squares[side] / count[side] - byNoise));
    };
    return {excess(0, kOutside), excess(1, kInsideShare)};
}

// A near face brought from its line to the hull, and the error of that, m.
struct Hull
{
    FaceLine line;
    double error = 0.0;
};

Hull hullOf(const NearFace& face, const Lines& lines, int k, double unseenDepth)
{
    const Departure departure = departureOf(face, lines, k);
    const double byNoise = kShift * face.noise * std::min(1.0, face.noise / lines.sigma);
    const double depth = (k == 0 ? 1.0 : kSideDepth) * unseenDepth;
    Hull hull;
    hull.line.exists = true;
    hull.line.shape = departure.outside;
    hull.line.outside = kToHull * departure.outside - byNoise + kUnseenShift * depth;
    hull.line.at = face.sign * (lines.q(1 + k) + hull.line.outside);
    const double shapeError =
        std::hypot(kHullError * departure.outside, kTaperError * departure.inside);
    hull.error = std::hypot(shapeError, depth, kLeastError);
    return hull;
}
}  // namespace

std::optional<FaceLines> fitFaceLines(const Hits& hits, const OrientedBox& box, FaceSet seen,
                                      const Eigen::Vector2d& sensor, const FaceLineOptions& o)
{
    const NearFaces faces = nearFaces(hits, box, seen, sensor, o);
    if (faces[0].hits.empty() && faces[1].hits.empty()) return std::nullopt;
    Lines lines;
    lines.q = {0.0, 0.5 * box.length, 0.5 * box.width};
    lines.sigma = o.sigma;
    for (int i = 0; i < o.iterations && reweigh(faces, lines);) ++i;

    // B / A of the M-estimator with A the sum of the weights is 0.56 for Gaussian hits of known
    // scale; by Monte Carlo, beside the least error.
    constexpr double kEfficiency = 0.485;
    FaceLines result;
    result.turn = lines.q(0);
    const double unseenDepth = o.bodyDepth * (1.0 - lowerBodyShare(hits));
    result.covariance = kEfficiency * lines.sigma * lines.sigma * lines.information.inverse();
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
        const Hull hull = hullOf(face, lines, k, unseenDepth);
        line = hull.line;
        // The two of a face with a sign: places are along the axes from here on.
        result.covariance.row(1 + k) *= face.sign;
        result.covariance.col(1 + k) *= face.sign;
        result.covariance(1 + k, 1 + k) += hull.error * hull.error;
        const double along = k == 0 ? box.width : box.length;
        const double turnError = hull.error / (0.5 * along);
        if (k == 1 || faces[1].hits.empty()) result.covariance(0, 0) += turnError * turnError;
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
