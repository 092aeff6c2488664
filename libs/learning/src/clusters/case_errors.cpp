// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/clusters/case_errors.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "vdamf/evaluation/box_overlap.h"

namespace vdamf
{
namespace
{
constexpr Face kFaces[] = {Face::Front, Face::Back, Face::Left, Face::Right};

// Outward normal in box axes, and half the size along it.
struct FaceLine
{
    Eigen::Vector2d normal;
    double half;
};

FaceLine faceLine(const OrientedBox& box, Face face)
{
    switch (face)
    {
        case Face::Front:
            return {{1.0, 0.0}, 0.5 * box.length};
        case Face::Back:
            return {{-1.0, 0.0}, 0.5 * box.length};
        case Face::Left:
            return {{0.0, 1.0}, 0.5 * box.width};
        case Face::Right:
            break;
    }
    return {{0.0, -1.0}, 0.5 * box.width};
}

double cornerError(const OrientedBox& box, const LabelledCluster& sample)
{
    const auto truth = corners(sample.truth);
    const auto nearest =
        *std::min_element(truth.begin(), truth.end(),
                          [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
                          { return (a - sample.sensor).norm() < (b - sample.sensor).norm(); });
    double error = 1e300;
    for (const Eigen::Vector2d& corner : corners(box))
        error = std::min(error, (corner - nearest).norm());
    return error;
}

// Derivative of a face's place along its normal by (x, y, heading, length, width), world axes: the
// middle of a face does not move along the normal when the box turns.
Eigen::Matrix<double, 1, 5> faceRow(const OrientedBox& box, Face face)
{
    const FaceLine line = faceLine(box, face);
    Eigen::Matrix<double, 1, 5> row = Eigen::Matrix<double, 1, 5>::Zero();
    row.head<2>() = (rotation(box.heading) * line.normal).transpose();
    row(line.normal.x() != 0.0 ? 3 : 4) = 0.5;
    return row;
}

// Squared error of heading and faces seen, normalised by the fit's own covariance and what is known
// of the errors of the true box.
void setNees(CaseErrors& errors, const Measurement& m, const LabelledCluster& sample)
{
    const OrientedBox aligned = alignedTo(sample.truth, m.box.heading);
    Eigen::Matrix<double, 5, 5> map = Eigen::Matrix<double, 5, 5>::Zero();
    Vector5d error = Vector5d::Zero();
    map(0, 2) = 1.0;
    error(0) = wrapAngle(aligned.heading - m.box.heading);
    int n = 1;
    for (const Face face : kFaces)
    {
        if (!m.facesSeen.has(face)) continue;
        map.row(n) = faceRow(m.box, face);
        error(n++) = faceOffset(m.box, aligned, face);
    }
    if (n == 1) return;
    const auto rows = map.topRows(n);
    Eigen::MatrixXd covariance = rows * m.covariance * rows.transpose();
    covariance(0, 0) += sample.truthHeading * sample.truthHeading;
    for (int k = 1; k < n; ++k) covariance(k, k) += sample.truthPlace * sample.truthPlace;
    const Eigen::LDLT<Eigen::MatrixXd> factors(covariance);
    errors.nees = error.head(n).dot(factors.solve(error.head(n)));
    errors.neesDimension = n;
}

void setFaceErrors(CaseErrors& errors, const OrientedBox& box, const LabelledCluster& sample)
{
    const OrientedBox aligned = alignedTo(box, sample.truth.heading);
    for (const Face face : kFaces)
    {
        if (!sample.inView.has(face)) continue;
        const bool isEnd = face == Face::Front || face == Face::Back;
        (isEnd ? errors.end : errors.side) = faceOffset(sample.truth, aligned, face);
    }
    if (errors.end && errors.side)
    {
        errors.length = aligned.length - sample.truth.length;
        errors.width = aligned.width - sample.truth.width;
    }
}
}  // namespace

OrientedBox alignedTo(const OrientedBox& box, double heading)
{
    const double quarters = std::round(wrapAngle(heading - box.heading) / (0.5 * kPi));
    OrientedBox turned = box;
    turned.heading = wrapAngle(box.heading + quarters * 0.5 * kPi);
    if (std::abs(std::remainder(quarters, 2.0)) > 0.5) std::swap(turned.length, turned.width);
    return turned;
}

double faceOffset(const OrientedBox& box, const OrientedBox& other, Face face)
{
    const FaceLine mine = faceLine(box, face);
    const FaceLine its = faceLine(other, face);
    const Eigen::Vector2d normal = rotation(box.heading) * mine.normal;
    const Eigen::Vector2d itsNormal = rotation(other.heading) * its.normal;
    const Eigen::Vector2d middle = box.centre() + mine.half * normal;
    const Eigen::Vector2d itsMiddle = other.centre() + its.half * itsNormal;
    return itsNormal.dot(itsMiddle - middle) / itsNormal.dot(normal);
}

CaseErrors errorsOf(const Estimate& estimate, const LabelledCluster& sample)
{
    const OrientedBox& box = estimate.box;
    CaseErrors errors;
    if (estimate.measurement) errors.iterations = estimate.measurement->iterations;
    const bool finite = std::isfinite(box.x + box.y + box.heading + box.length + box.width);
    if (!finite)
    {
        errors.heading90 = 45.0;
        errors.heading180 = 90.0;
        errors.corner = sample.truth.length;
        errors.failed = true;
        return errors;
    }
    const double difference = box.heading - sample.truth.heading;
    errors.heading90 = std::abs(std::remainder(difference, 0.5 * kPi)) / kDegree;
    errors.heading180 = std::abs(std::remainder(difference, kPi)) / kDegree;
    errors.corner = cornerError(box, sample);
    errors.iou = birdsEyeIou(box, sample.truth);
    setFaceErrors(errors, box, sample);
    if (estimate.measurement)
    {
        errors.failed = !estimate.measurement->converged;
        setNees(errors, *estimate.measurement, sample);
    }
    return errors;
}

}  // namespace vdamf
