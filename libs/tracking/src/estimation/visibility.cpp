// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/visibility.h"

#include <algorithm>
#include <cmath>

#include "estimation/by_size.h"
#include "types/box_changes.h"

namespace vdamf
{
namespace
{
// Of the two ends of an axis, the one that lies farther outside (sign +1) or inside (-1) than
// predicted; a face that is seen itself is where it is.
int suspect(const Measurement& m, const VehicleState& predicted, int axis, double sign)
{
    for (int end = 0; end < 2; ++end)
        if (m.facesSeen.has(kFaceAt[axis][end])) return 1 - end;
    const OrientedBox before = predicted.box();
    return sign * outsideOf(before, m.box, axis, 0) > sign * outsideOf(before, m.box, axis, 1) ? 0
                                                                                               : 1;
}

// Measured size over the known one in standard deviations.
struct SizeChange
{
    double metres = 0.0;
    double sigmas = 0.0;
};

SizeChange sizeChange(const Measurement& m, const VehicleState& predicted, int axis,
                      const VisibilityOptions& o)
{
    const double measured = axis == 0 ? m.box.length : m.box.width;
    const double change = measured - predicted.size()(axis);
    const double variance = predicted.sizeVariance()(axis) +
                            std::min(1.0, m.covariance(3 + axis, 3 + axis)) +
                            o.sizeSigma * o.sizeSigma;
    return {change, change / std::sqrt(variance)};
}

// Whether both ends of an axis are told by the row of hits along a face between them.
bool isWholeRow(const Measurement& m, int axis)
{
    const FaceSet located = locatedFaces(m);
    for (const Face end : kFaceAt[axis])
        if (!located.has(end) || m.facesSeen.has(end)) return false;
    return true;
}

// Of the measured place of a face, along its normal, m.
double placeSigma(const Measurement& m, int axis, int end)
{
    Vector5d byBox = Vector5d::Zero();
    byBox.head<2>() = signOfEnd(end) * rotation(m.box.heading).col(axis);
    byBox(3 + axis) = 0.5;
    return std::sqrt(std::max(0.0, byBox.dot(m.covariance * byBox)));
}

// Whether hits lie beyond an end whose place is hidden: it is there at the least. Where it is
// vague, no hits show it. Where the other end is told, they do so only if they make the whole
// longer.
bool reachesBeyond(const Measurement& m, const VehicleState& predicted, int axis, int end,
                   bool otherIsTold, const VisibilityOptions& o)
{
    const Face face = kFaceAt[axis][end];
    const double growth = (axis == 0 ? m.box.length : m.box.width) - predicted.size()(axis);
    constexpr double kVague = 0.5;  // m
    return m.facesSeen.seesAlong(axis) && m.hiddenEnds.has(face) && !m.facesSeen.has(face) &&
           placeSigma(m, axis, end) < kVague && (!otherIsTold || growth > o.sizeSigma) &&
           outsideOf(predicted.box(), m.box, axis, end) > o.sizeSigma;
}

// Whether a row of hits from end to end is well measured and as long as is known.
bool isAsKnown(const Measurement& m, const VehicleState& predicted, int axis,
               const VisibilityOptions& o)
{
    if (!isWholeRow(m, axis)) return false;
    constexpr double kWellMeasured = 0.8;  // of what rows err
    const double known = std::sqrt(predicted.sizeVariance()(axis));
    const double measured = std::sqrt(m.covariance(3 + axis, 3 + axis));
    return std::abs(sizeChange(m, predicted, axis, o).metres) < o.sizeSigma &&
           known < o.sizeSigma && measured < kWellMeasured * o.sizeSigma;
}

// Model error of a row of hits from end to end: its ends recede alike, where a body is round, so
// its middle is better known than either.
Matrix5d ofWholeRow(const FaceErrors& errors, const Eigen::Matrix2d& axes, int axis)
{
    constexpr double kMiddle = 0.05;  // m
    const Vector5d low = byFace(axes, axis, 0);
    const Vector5d high = byFace(axes, axis, 1);
    const Vector5d shift = kMiddle * (low + high);
    const Vector5d growth =
        0.5 * std::hypot(errors.sigma[axis][0], errors.sigma[axis][1]) * (high - low);
    return shift * shift.transpose() + growth * growth.transpose();
}

// Model error of the heading, rad.
double headingFloorOf(FaceSet seen, const VisibilityOptions& o)
{
    constexpr double kShapeless = 0.25;  // of hits on no face
    if (seen.seesSide()) return o.headingFloor;
    return seen.seesEnd() ? o.endOnlyHeadingFloor : kShapeless;
}

constexpr double kClear = 2.0;  // sigmas from which on a change of size is not noise
}  // namespace

Eigen::Vector2d nearestPoint(const OrientedBox& box, const Eigen::Vector2d& sensor)
{
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    return {std::clamp(view.x() / (0.5 * box.length), -1.0, 1.0),
            std::clamp(view.y() / (0.5 * box.width), -1.0, 1.0)};
}

FaceSet locatedFaces(const Measurement& m)
{
    FaceSet located = m.facesSeen;
    for (int axis = 0; axis < 2; ++axis)
        for (const Face face : kFaceAt[axis])
            if (m.facesSeen.seesAlong(axis) && !m.hiddenEnds.has(face)) located.add(face);
    return located;
}

FaceErrors faceErrors(const Measurement& m, const VisibilityOptions& o)
{
    const FaceSet located = locatedFaces(m);
    FaceErrors errors;
    for (int axis = 0; axis < 2; ++axis)
        for (int end = 0; end < 2; ++end)
        {
            const Face face = kFaceAt[axis][end];
            const double told = located.has(face) ? o.sizeSigma : FaceErrors::kNotTold;
            errors.sigma[axis][end] = m.facesSeen.has(face) ? o.positionFloor : told;
        }
    return errors;
}

FaceErrors faceErrors(const Measurement& m, const VehicleState& predicted,
                      const VisibilityOptions& o)
{
    FaceErrors errors = faceErrors(m, o);
    for (int axis = 0; axis < 2; ++axis)
    {
        const bool told[2] = {errors.tells(axis, 0), errors.tells(axis, 1)};
        for (int end = 0; end < 2; ++end)
            if (reachesBeyond(m, predicted, axis, end, told[1 - end], o))
                errors.sigma[axis][end] = o.shortfallSigma;
        if (!errors.tells(axis, 0) || !errors.tells(axis, 1)) continue;
        const SizeChange change = sizeChange(m, predicted, axis, o);
        errors.isAsKnown[axis] =
            o.correction == VisibilityCorrection::Faces && isAsKnown(m, predicted, axis, o);
        if (change.metres > 0.0) continue;
        const int end = suspect(m, predicted, axis, -1.0);
        if (o.correction == VisibilityCorrection::Faces)
        {
            // A width that is short by less than rows err is hardly cut short.
            const double cut = axis == 1 ? std::min(1.0, -change.metres / o.sizeSigma) : 1.0;
            errors.sigma[axis][end] =
                std::max({errors.sigma[axis][end], cut * o.shortfallSigma, -change.metres});
        }
        else if (change.sigmas < -kClear)
            errors.sigma[axis][end] = FaceErrors::kNotTold;
    }
    return errors;
}

bool isInside(const Measurement& m, const VehicleState& predicted)
{
    constexpr double kSurely = 2.0;  // sigmas
    if (!locatesLength(m)) return false;
    const auto isEndInside = [&](int end)
    {
        const double sigma = std::hypot(predicted.faceSigma(0, end), placeSigma(m, 0, end));
        return outsideOf(predicted.box(), m.box, 0, end) < -kSurely * sigma;
    };
    return isEndInside(0) && isEndInside(1);
}

FaceErrors withShortRows(const FaceErrors& errors, const Measurement& m,
                         const VehicleState& predicted)
{
    FaceErrors next = errors;
    for (int axis = 0; axis < 2; ++axis)
        for (int end = 0; end < 2; ++end)
        {
            const bool isSeen = m.facesSeen.has(kFaceAt[axis][end]);
            if (isSeen || !errors.tells(axis, end)) continue;
            double& sigma = next.sigma[axis][end];
            sigma = std::max(sigma, -outsideOf(predicted.box(), m.box, axis, end));
        }
    return next;
}

VehicleState openToGrowth(const VehicleState& predicted, const Measurement& m, bool mayBeLonger,
                          const VisibilityOptions& o)
{
    // Of a box that may lie turned, hits to its side seem to be beyond its end.
    constexpr double kTurned = 0.04;  // rad
    const bool mayReach = mayBeLonger && m.covariance(2, 2) < kTurned * kTurned;
    VehicleState next = predicted;
    const FaceSet located = locatedFaces(m);
    for (int axis = 0; axis < 2; ++axis)
    {
        const bool has[2] = {located.has(kFaceAt[axis][0]), located.has(kFaceAt[axis][1])};
        const auto grow = [&](int stays, double metres)
        {
            const StateVector growth = bySize(predicted, axis, signOfEnd(stays));
            next.covariance += metres * metres * growth * growth.transpose();
            if (axis == 1) next.widthVariance += metres * metres;
        };
        const SizeChange change = sizeChange(m, predicted, axis, o);
        if (has[0] && has[1] && change.sigmas >= kClear)
            grow(1 - suspect(m, predicted, axis, 1.0), change.metres);
        for (int end = 0; end < 2 && axis == 0 && mayReach; ++end)
            if (reachesBeyond(m, predicted, axis, end, has[1 - end], o))
                grow(1 - end, outsideOf(predicted.box(), m.box, axis, end));
    }
    return next;
}

BoxMeasurement boxThrough(const Measurement& m, const FaceErrors& errors,
                          const Eigen::Vector2d& known, const Eigen::Vector2d& sensor,
                          const VisibilityOptions& o)
{
    const Eigen::Matrix2d r = rotation(m.box.heading);
    Eigen::Vector2d fixed = nearestPoint(m.box, sensor);
    Eigen::Vector2d size(m.box.length, m.box.width);
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();  // of the centre, in the box frame
    Matrix5d j = Matrix5d::Identity();                 // d result / d measured
    Matrix5d modelError = Matrix5d::Zero();
    for (int axis = 0; axis < 2; ++axis)
    {
        const bool has[2] = {errors.tells(axis, 0), errors.tells(axis, 1)};
        if (has[0] != has[1]) fixed(axis) = signOfEnd(has[1] ? 1 : 0);
        if (errors.isAsKnown[axis])
        {
            fixed(axis) = 0.0;
            modelError += ofWholeRow(errors, r, axis);
            continue;
        }
        if (!has[0] || !has[1])
        {
            offset(axis) = 0.5 * fixed(axis) * (size(axis) - known(axis));
            size(axis) = known(axis);
            j.block<2, 1>(0, 3 + axis) = 0.5 * fixed(axis) * r.col(axis);
            j(3 + axis, 3 + axis) = 0.0;
        }
        for (int end = 0; end < 2; ++end)
        {
            const bool vague = m.facesSeen.empty() && signOfEnd(end) * fixed(axis) > 0.0;
            const double sigma = vague ? o.unseenSigma : errors.sigma[axis][end];
            const Vector5d change = byFace(r, axis, end);
            modelError += sigma * sigma * change * change.transpose();
        }
    }
    const Eigen::Vector2d lever = -0.5 * fixed.cwiseProduct(size);  // fixed point to centre
    j.block<2, 1>(0, 2) = r * Eigen::Vector2d(-offset.y(), offset.x());
    const Vector5d turn = headingFloorOf(m.facesSeen, o) * byTurn(r * lever);

    BoxMeasurement result;
    result.box << m.box.centre() + r * offset, m.box.heading, size;
    result.covariance = j * m.covariance * j.transpose() + modelError + turn * turn.transpose();
    result.fixedPoint = fixed;
    return result;
}

Measurement turnedBy(const Measurement& measurement, int quarters)
{
    Measurement m = measurement;
    m.box.heading = wrapAngle(m.box.heading + 0.5 * kPi * quarters);
    for (FaceSet* faces : {&m.facesSeen, &m.hiddenEnds, &m.shadowEdges, &m.upperEnds})
        *faces = turnedBy(*faces, quarters);
    if (quarters % 2 != 0)
    {
        std::swap(m.box.length, m.box.width);
        m.covariance.row(3).swap(m.covariance.row(4));
        m.covariance.col(3).swap(m.covariance.col(4));
    }
    return m;
}

Measurement alignedWith(const Measurement& m, double heading)
{
    return turnedBy(m, std::abs(wrapAngle(m.box.heading - heading)) <= 0.5 * kPi ? 0 : 2);
}

bool liesAcross(const Measurement& m, double heading)
{
    return std::abs(std::remainder(m.box.heading - heading, kPi)) > 0.25 * kPi;
}

}  // namespace vdamf
