// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/simulation/labelled_motion.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kKnotSpacing = 0.25;  ///< s

using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 3>;  ///< x, y, heading a row

/// Uniform cubic B-splines: knot interval i holds the control points i to i + 3.
struct Knots
{
    double begin;
    Eigen::Index intervals;

    Eigen::Index controls() const { return intervals + 3; }
    double timeOf(Eigen::Index control) const
    {
        return begin + static_cast<double>(control - 1) * kKnotSpacing;
    }
};

struct Place
{
    Eigen::Index interval;
    double u;  ///< within it, 0..1
};

Place placeOf(const Knots& knots, double time)
{
    const double at = (time - knots.begin) / kKnotSpacing;
    const auto interval =
        std::clamp<Eigen::Index>(static_cast<Eigen::Index>(at), 0, knots.intervals - 1);
    return {interval, at - static_cast<double>(interval)};
}

std::array<double, 4> basis(double u)
{
    const double v = 1.0 - u;
    return {v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
            (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0, u * u * u / 6.0};
}

/// A second difference of neighbouring control points is the second derivative times the spacing
/// squared.
void addRoughness(std::vector<Eigen::Triplet<double>>& entries, const Knots& knots,
                  double smoothing)
{
    constexpr std::array<double, 3> kDifference{1.0, -2.0, 1.0};
    const double weight = std::pow(smoothing, 4) / std::pow(kKnotSpacing, 3);
    for (Eigen::Index i = 0; i + 2 < knots.controls(); ++i)
    {
        for (int a = 0; a < 3; ++a)
        {
            for (int b = 0; b < 3; ++b)
            {
                const auto ia = static_cast<std::size_t>(a);
                const auto ib = static_cast<std::size_t>(b);
                entries.emplace_back(i + a, i + b, weight * kDifference[ia] * kDifference[ib]);
            }
        }
    }
}

struct Equations
{
    Eigen::SparseMatrix<double> matrix;
    Coefficients right;
};

Equations equationsOf(const std::vector<LabelledPose>& poses, const Knots& knots, double smoothing)
{
    const double span = poses.back().time - poses.front().time;
    const double weight = span / static_cast<double>(poses.size() - 1);
    std::vector<Eigen::Triplet<double>> entries;
    Equations result{Eigen::SparseMatrix<double>(knots.controls(), knots.controls()),
                     Coefficients::Zero(knots.controls(), 3)};
    for (const LabelledPose& pose : poses)
    {
        const Place place = placeOf(knots, pose.time);
        const std::array<double, 4> b = basis(place.u);
        const Eigen::RowVector3d label(pose.x, pose.y, pose.heading);
        for (std::size_t i = 0; i < 4; ++i)
        {
            const Eigen::Index row = place.interval + static_cast<Eigen::Index>(i);
            result.right.row(row) += weight * b[i] * label;
            for (std::size_t k = 0; k < 4; ++k)
            {
                const Eigen::Index column = place.interval + static_cast<Eigen::Index>(k);
                entries.emplace_back(row, column, weight * b[i] * b[k]);
            }
        }
    }
    addRoughness(entries, knots, smoothing);
    result.matrix.setFromTriplets(entries.begin(), entries.end());
    return result;
}

std::optional<Eigen::RowVector3d> standingControl(const std::vector<Standstill>& stands,
                                                  double time)
{
    constexpr double kReach = 0.5 * kKnotSpacing;
    for (const Standstill& stand : stands)
    {
        if (time < stand.begin - kReach || time > stand.end + kReach) continue;
        return Eigen::RowVector3d(stand.pose.x, stand.pose.y, stand.pose.heading);
    }
    return std::nullopt;
}

/// Equations of fixed control points are replaced by what they are, and leave those of the others.
void fix(Equations& equations, Eigen::Index control, const Eigen::RowVector3d& value)
{
    std::vector<Eigen::Index> neighbours;
    for (Eigen::SparseMatrix<double>::InnerIterator i(equations.matrix, control); i; ++i)
    {
        if (i.row() != control) neighbours.push_back(i.row());
        if (i.row() != control) equations.right.row(i.row()) -= i.value() * value;
    }
    for (const Eigen::Index other : neighbours)
    {
        equations.matrix.coeffRef(other, control) = 0.0;
        equations.matrix.coeffRef(control, other) = 0.0;
    }
    equations.matrix.coeffRef(control, control) = 1.0;
    equations.right.row(control) = value;
}

Coefficients controlsOf(const std::vector<LabelledPose>& poses, const Knots& knots,
                        double smoothing)
{
    const std::vector<Standstill> stands = standstills(poses);
    const bool standsAlways = stands.size() == 1 && stands[0].begin == poses.front().time &&
                              stands[0].end == poses.back().time;
    Equations equations = equationsOf(poses, knots, smoothing);
    std::vector<std::optional<Eigen::RowVector3d>> fixed;
    for (Eigen::Index i = 0; i < knots.controls(); ++i)
    {
        const double time = standsAlways ? stands[0].begin : knots.timeOf(i);
        fixed.push_back(standingControl(stands, time));
        if (fixed.back()) fix(equations, i, *fixed.back());
    }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(equations.matrix);
    Coefficients controls = solver.solve(equations.right);
    for (Eigen::Index i = 0; i < knots.controls(); ++i)
    {
        const auto& value = fixed[static_cast<std::size_t>(i)];
        if (value) controls.row(i) = *value;  // without the solver's rounding
    }
    return controls;
}

class SplineMotion : public Motion
{
public:
    SplineMotion(const Knots& knots, double end, Coefficients controls)
        : knots_(knots), end_(end), controls_(std::move(controls))
    {
    }

    MotionState at(double time) const override
    {
        const double inside = std::clamp(time, knots_.begin, end_);
        MotionState state = within(inside);
        if (time == inside) return state;
        state.x += state.speed * (time - inside) * std::cos(state.heading);
        state.y += state.speed * (time - inside) * std::sin(state.heading);
        state.yawRate = 0.0;
        return state;
    }

private:
    MotionState within(double time) const
    {
        const auto [interval, u] = placeOf(knots_, time);
        const double v = 1.0 - u;
        const auto c = [&, first = interval](Eigen::Index i)
        { return Eigen::RowVector3d(controls_.row(first + i)); };
        // By differences from a control point, so that equal ones give exactly their value.
        const std::array<double, 4> b = basis(u);
        const Eigen::RowVector3d origin = c(1);
        const Eigen::RowVector3d pose =
            origin + b[0] * (c(0) - origin) + b[2] * (c(2) - origin) + b[3] * (c(3) - origin);
        const double middle = 0.5 + u * v;
        const Eigen::RowVector3d rate =
            (0.5 * v * v * (c(1) - c(0)) + middle * (c(2) - c(1)) + 0.5 * u * u * (c(3) - c(2))) /
            kKnotSpacing;
        const double speed = rate.x() * std::cos(pose.z()) + rate.y() * std::sin(pose.z());
        return {pose.x(), pose.y(), pose.z(), speed, rate.z()};
    }

    Knots knots_;
    double end_;
    Coefficients controls_;
};
}  // namespace

Trajectory smoothed(std::vector<LabelledPose> poses, double axleOffset, double smoothing)
{
    if (poses.size() < 2) throw std::runtime_error("a motion needs two labels at least");
    for (std::size_t i = 1; i < poses.size(); ++i)
    {
        if (!(poses[i].time > poses[i - 1].time))
        {
            throw std::runtime_error("labels are not in order of time");
        }
        const double turn = wrapAngle(poses[i].heading - poses[i - 1].heading);
        poses[i].heading = poses[i - 1].heading + turn;
    }
    for (LabelledPose& pose : poses)
    {
        pose.x -= axleOffset * std::cos(pose.heading);
        pose.y -= axleOffset * std::sin(pose.heading);
    }
    const double span = poses.back().time - poses.front().time;
    const Knots knots{poses.front().time,
                      std::max<Eigen::Index>(
                          1, static_cast<Eigen::Index>(std::ceil(span / kKnotSpacing - 1e-9)))};
    return Trajectory(std::make_shared<SplineMotion>(knots, poses.back().time,
                                                     controlsOf(poses, knots, smoothing)));
}

}  // namespace vdamf
