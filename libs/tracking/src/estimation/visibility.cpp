// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/visibility.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr Face kFaces[2][2] = {{Face::Back, Face::Front}, {Face::Right, Face::Left}};

double signOf(int end)
{
    return end == 0 ? -1.0 : 1.0;
}

// How far the measured face lies outside of the predicted one, along its normal, m.
double outside(const OrientedBox& measured, const OrientedBox& predicted, int axis, int end)
{
    const Eigen::Vector2d normal = signOf(end) * rotation(predicted.heading).col(axis);
    const double growth =
        axis == 0 ? measured.length - predicted.length : measured.width - predicted.width;
    return normal.dot(measured.centre() - predicted.centre()) + 0.5 * growth;
}

// Of the two ends of an axis, the one that lies farther outside (sign +1) or inside (-1) than
// predicted; a face that is seen itself is where it is.
int suspect(const Measurement& m, const VehicleState& predicted, int axis, double sign)
{
    for (int end = 0; end < 2; ++end)
        if (m.facesSeen.has(kFaces[axis][end])) return 1 - end;
    const OrientedBox before = predicted.box();
    return sign * outside(m.box, before, axis, 0) > sign * outside(m.box, before, axis, 1) ? 0 : 1;
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

// Whether hits lie beyond an end whose place is hidden: it is there at the least.
bool reachesBeyond(const Measurement& m, const VehicleState& predicted, int axis, int end,
                   const VisibilityOptions& o)
{
    const bool runsAlong = axis == 0 ? m.facesSeen.seesSide() : m.facesSeen.seesEnd();
    const Face face = kFaces[axis][end];
    const double measured = axis == 0 ? m.box.length : m.box.width;
    return runsAlong && m.hiddenEnds.has(face) && !m.facesSeen.has(face) &&
           measured - predicted.size()(axis) > o.sizeSigma &&
           outside(m.box, predicted.box(), axis, end) > o.sizeSigma;
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
    {
        const bool runsAlong = axis == 0 ? m.facesSeen.seesSide() : m.facesSeen.seesEnd();
        for (const Face face : kFaces[axis])
            if (runsAlong && !m.hiddenEnds.has(face)) located.add(face);
    }
    return located;
}

FaceErrors faceErrors(const Measurement& m, const VisibilityOptions& o)
{
    const FaceSet located = locatedFaces(m);
    FaceErrors errors;
    for (int axis = 0; axis < 2; ++axis)
        for (int end = 0; end < 2; ++end)
        {
            const Face face = kFaces[axis][end];
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
        for (int end = 0; end < 2; ++end)
            if (errors.tells(axis, 1 - end) && reachesBeyond(m, predicted, axis, end, o))
                errors.sigma[axis][end] = o.shortfallSigma;
        if (!errors.tells(axis, 0) || !errors.tells(axis, 1)) continue;
        const SizeChange change = sizeChange(m, predicted, axis, o);
        if (change.metres > 0.0) continue;
        const int end = suspect(m, predicted, axis, -1.0);
        if (o.correction == VisibilityCorrection::Faces)
            errors.sigma[axis][end] = std::max(-change.metres, o.shortfallSigma);
        else if (change.sigmas < -kClear)
            errors.sigma[axis][end] = FaceErrors::kNotTold;
    }
    return errors;
}

FaceErrors withShortRows(const FaceErrors& errors, const Measurement& m,
                         const VehicleState& predicted)
{
    FaceErrors next = errors;
    for (int axis = 0; axis < 2; ++axis)
        for (int end = 0; end < 2; ++end)
        {
            const bool isSeen = m.facesSeen.has(kFaces[axis][end]);
            if (isSeen || !errors.tells(axis, end) || errors.tells(axis, 1 - end)) continue;
            double& sigma = next.sigma[axis][end];
            sigma = std::max(sigma, -outside(m.box, predicted.box(), axis, end));
        }
    return next;
}

VehicleState openToGrowth(const VehicleState& predicted, const Measurement& m,
                          const VisibilityOptions& o)
{
    VehicleState next = predicted;
    const FaceSet located = locatedFaces(m);
    for (int axis = 0; axis < 2; ++axis)
    {
        const bool both = located.has(kFaces[axis][0]) && located.has(kFaces[axis][1]);
        const SizeChange change = sizeChange(m, predicted, axis, o);
        if (!both || change.sigmas < kClear) continue;
        const double sign = signOf(suspect(m, predicted, axis, 1.0));
        StateVector byFace = StateVector::Zero();
        byFace.head<2>() = 0.5 * sign * rotation(predicted.mean(kHeading)).col(axis);
        if (axis == 0)
        {
            if (next.steering != Steering::Independent) byFace(kAxis) = 0.5 * sign;
            byFace(kLength) = 1.0;
        }
        else
        {
            next.widthVariance += change.metres * change.metres;
        }
        next.covariance += change.metres * change.metres * byFace * byFace.transpose();
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
    const auto addError = [&](int axis, int end, double sigma)
    {
        Vector5d byFace = Vector5d::Zero();
        byFace.head<2>() = 0.5 * r.col(axis);
        byFace(3 + axis) = signOf(end);
        modelError += sigma * sigma * byFace * byFace.transpose();
    };
    for (int axis = 0; axis < 2; ++axis)
    {
        const bool has[2] = {errors.tells(axis, 0), errors.tells(axis, 1)};
        if (has[0] != has[1]) fixed(axis) = signOf(has[1] ? 1 : 0);
        if (!has[0] || !has[1])
        {
            offset(axis) = 0.5 * fixed(axis) * (size(axis) - known(axis));
            size(axis) = known(axis);
            j.block<2, 1>(0, 3 + axis) = 0.5 * fixed(axis) * r.col(axis);
            j(3 + axis, 3 + axis) = 0.0;
        }
        for (int end = 0; end < 2; ++end)
        {
            const bool vague = m.facesSeen.empty() && signOf(end) * fixed(axis) > 0.0;
            addError(axis, end, vague ? o.unseenSigma : errors.sigma[axis][end]);
        }
    }
    const Eigen::Vector2d lever = -0.5 * fixed.cwiseProduct(size);  // fixed point to centre
    j.block<2, 1>(0, 2) = r * Eigen::Vector2d(-offset.y(), offset.x());
    Vector5d turn = Vector5d::Zero();
    turn.head<2>() = r * Eigen::Vector2d(-lever.y(), lever.x());
    constexpr double kShapeless = 0.25;  // rad, of hits on no face
    const double withoutSide = m.facesSeen.seesEnd() ? o.endOnlyHeadingFloor : kShapeless;
    turn(2) = m.facesSeen.seesSide() ? o.headingFloor : withoutSide;
    turn.head<2>() *= turn(2);

    BoxMeasurement result;
    result.box << m.box.centre() + r * offset, m.box.heading, size;
    result.covariance = j * m.covariance * j.transpose() + modelError + turn * turn.transpose();
    result.fixedPoint = fixed;
    return result;
}

Measurement turnedBy(const Measurement& measurement, int quarters)
{
    Measurement m = measurement;
    // Counter-clockwise, each face becomes the one before it: the left side is the new front.
    constexpr Face kAround[4] = {Face::Front, Face::Left, Face::Back, Face::Right};
    const int turns = ((quarters % 4) + 4) % 4;
    m.box.heading = wrapAngle(m.box.heading + 0.5 * kPi * turns);
    m.facesSeen = m.hiddenEnds = FaceSet();
    for (int k = 0; k < 4; ++k)
    {
        const Face before = kAround[(k + turns) % 4];
        if (measurement.facesSeen.has(before)) m.facesSeen.add(kAround[k]);
        if (measurement.hiddenEnds.has(before)) m.hiddenEnds.add(kAround[k]);
    }
    if (turns % 2 == 1)
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

}  // namespace vdamf
