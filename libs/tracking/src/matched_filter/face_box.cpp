// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/face_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "matched_filter/body_profile.h"
#include "types/box_changes.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
// Where a face is: along its axis, from the middle of the fitted box.
struct FacePlace
{
    double at = 0.0;        // signed, m
    double variance = 0.0;  // m^2, beside what the lines give
    bool onLine = false;
    bool onRow = false;  // at the end of a row of hits
};

// Of cells of hits on a face.
struct RowOnFace
{
    std::vector<double> along;  // outwards, m
    double hits = 0.0;
};

// Hits on a face lie at most so far behind it (round corners) and before it, m.
constexpr double kRowBehind = 0.8;
constexpr double kRowInFront = 0.25;
// A gap that ends a row of hits: so many times the gaps before it, within these bounds, m.
constexpr double kGapRatio = 4.0;
constexpr double kLeastRowGap = 0.25;
constexpr double kLargestRowGap = 1.0;
// The end of a row of hits, of which the filter said `fitted`: half a gap behind the last of them;
// nothing for a row too short.
std::optional<FacePlace> rowEnd(std::vector<double> row, double fitted, double sign, double shape,
                                const FilterParameters& parameters)
{
    constexpr std::size_t kForGap = 4;
    if (row.size() < kForGap) return std::nullopt;
    // The row goes on at least to here: of what lies before, the last ones only need their order.
    const double least = fitted - parameters.lines.fitExcess;
    const auto end =
        std::partition(row.begin(), row.end(), [&](double along) { return along < least; });
    const auto before = static_cast<std::size_t>(end - row.begin());
    if (before > kForGap) std::nth_element(row.begin(), end - kForGap, end);
    std::sort(before > kForGap ? end - kForGap : row.begin(), end);
    std::sort(end, row.end());
    const auto gapBefore = [&](std::size_t last)
    { return (row[last] - row[last + 1 - kForGap]) / (kForGap - 1.0); };
    // The row ends where a gap is wide for one as dense as it is, but not well inside of what the
    // filter found to be the vehicle.
    std::size_t count = kForGap;
    const auto goesOn = [&](std::size_t next)
    {
        const double gap = row[next] - row[next - 1];
        return row[next] < least ||
               gap < std::clamp(kGapRatio * gapBefore(next - 1), kLeastRowGap, kLargestRowGap);
    };
    while (count < row.size() && goesOn(count)) ++count;
    const double gap = gapBefore(count - 1);
    // A far end is out of view where it turns round.
    const double roundness = parameters.hull.roundEnd * shape;
    const double rough = parameters.errors.endRoughness;
    FacePlace place;
    place.at = sign * (row[count - 1] + 0.5 * gap + roundness);
    place.variance = gap * gap / 12.0 + rough * rough + roundness * roundness / 4.0;
    place.onRow = true;
    return place;
}

// Everything in the axes of the turned box, from its middle: 0 along the heading, 1 across it.
class FaceBoxBuilder
{
public:
    FaceBoxBuilder(const Hits& hits, const OrientedBox& fitted, FaceSet seen,
                   const Eigen::Vector2d& sensor, const FaceLines& lines,
                   const MeasureOptions& options)
        : hits_(hits),
          turned_(fitted),
          lines_(lines),
          options_(options),
          half_{0.5 * fitted.length, 0.5 * fitted.width},
          seen_{seen.seesEnd(), seen.seesSide()}
    {
        turned_.heading = wrapAngle(fitted.heading + lines.turn);
        view_ = toBoxFrame(turned_, sensor);
        nearSign_ = {view_.x() > 0.0 ? 1.0 : -1.0, view_.y() > 0.0 ? 1.0 : -1.0};
        for (auto& places : inBox_) places.resize(hits.size());
        const Direction forward = directionOf(turned_.heading);
        inWideLanes([
            c = forward.cos, s = forward.sin, x0 = turned_.x, y0 = turned_.y, px = hits.x.data(),
            py = hits.y.data(), size = hits.size(), toX = inBox_[0].data(), toY = inBox_[1].data()
        ]() __attribute__((always_inline)) {
            VDAMF_INDEPENDENT_LANES
            for (std::size_t i = 0; i < size; ++i)
            {
                const double dx = px[i] - x0;
                const double dy = py[i] - y0;
                toX[i] = c * dx + s * dy;
                toY[i] = c * dy - s * dx;
            }
        });
    }

    FaceBox build() const
    {
        const FitOptions& limits = options_.fit;
        Faces faces;
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (std::size_t end = 0; end < 2; ++end)
                faces[axis][end] = placeOf(axis, end == 0 ? -1.0 : 1.0);
        limit(faces[0], nearSign_[0], limits.minLength, limits.maxLength);
        limit(faces[1], nearSign_[1], limits.minWidth, limits.maxWidth);
        return boxOf(faces);
    }

private:
    using Faces = std::array<std::array<FacePlace, 2>, 2>;  // by axis, low and high

    static void limit(std::array<FacePlace, 2>& faces, double nearSign, double min, double max)
    {
        const double size = std::clamp(faces[1].at - faces[0].at, min, max);
        if (nearSign > 0.0)
            faces[0].at = faces[1].at - size;
        else
            faces[1].at = faces[0].at + size;
    }

    const FaceLine& line(std::size_t axis) const { return axis == 0 ? lines_.end : lines_.side; }

    double nearAt(std::size_t axis) const
    {
        return line(axis).exists ? line(axis).at : nearSign_[axis] * half_[axis];
    }

    FacePlace placeOf(std::size_t axis, double sign) const
    {
        const double unseenSigma = options_.hiddenFaceSigma;
        FacePlace place{sign * half_[axis], unseenSigma * unseenSigma, false, false};
        if (sign == nearSign_[axis] && line(axis).exists)
        {
            place = {line(axis).at, 0.0, true, false};
        }
        else if (seen_[1 - axis])
        {
            const double turns = axis == 1 && areOfCar(hits_.heights) ? outOfView(axis, sign) : 1.0;
            const double shape = turns * std::max(line(0).shape, line(1).shape);
            RowOnFace row = rowAlong(axis, sign);
            const double reach = sign == nearSign_[axis] ? 0.0 : farReach(axis, row.hits);
            if (const auto end =
                    rowEnd(std::move(row.along), half_[axis], sign, shape, options_.parameters))
            {
                place = *end;
                place.at += sign * reach;
                place.variance += reach * reach;
                if (axis == 0) place = roundCorner(place, sign);
            }
        }
        return place;
    }

    // How much of a round corner turns out of view at an end of the fitted box, over what does
    // at 45 degrees: none where the ray that meets it runs along the face behind it.
    double outOfView(std::size_t axis, double sign) const
    {
        constexpr double kAtFortyFive = 0.29289321881345;
        const double ahead = std::max(0.0, half_[axis] - sign * view_[axis]);
        const double before = std::max(0.0, std::abs(view_[1 - axis] - nearAt(1 - axis)));
        const double cosine = before / std::max(1e-6, std::hypot(ahead, before));
        return std::min(1.0, (1.0 - cosine) / kAtFortyFive);
    }

    // Front and rear of a car lie beyond the end of a row of hits on its side, where the corner
    // turns out of view, the farther, the flatter the row is seen: of simulated and labelled cars
    // alike.
    FacePlace roundCorner(FacePlace end, double sign) const
    {
        constexpr double kPower = 1.5;
        constexpr double kError = 0.35;  // of the whole
        const double ahead = sign * (end.at - view_.x());
        if (!areOfCar(hits_.heights) || lines_.arePlanes || ahead <= 0.0) return end;
        const double share = std::pow(ahead / std::hypot(ahead, view_.y() - nearAt(1)), kPower);
        const double recess = share * options_.parameters.hull.farCorner * options_.bodyDepth;
        end.at += sign * recess;
        end.variance += kError * kError * recess * recess;
        return end;
    }

    // How far a body goes on behind the last hit of a row: by simulated and labelled vehicles.
    double farReach(std::size_t axis, double hits) const
    {
        const HullParameters& hull = options_.parameters.hull;
        const double few = options_.parameters.lines.fewInRow;
        const double depths = axis == 0 ? hull.farEnd : hull.farSide;
        return depths * options_.bodyDepth * few / (few + hits);
    }

    // Hits on the near face that runs along `axis`, outwards by `sign`.
    RowOnFace rowAlong(std::size_t axis, double sign) const
    {
        RowOnFace row;
        row.along.resize(hits_.size());
        inWideLanes([
            sign, face = nearAt(1 - axis), nearSign = nearSign_[1 - axis], size = hits_.size(),
            across = inBox_[1 - axis].data(), outwards = inBox_[axis].data(),
            weights = hits_.weight.data(), to = row.along.data(), hits = &row.hits
        ]() __attribute__((always_inline)) {
            Doubles sum{};
            const auto step = [&](std::size_t first, std::size_t count)
                __attribute__((always_inline))
            {
                Doubles side, along, weight;
                load(side, across + first, count);
                load(along, outwards + first, count);
                load(weight, weights + first, count);
                const Doubles depth = nearSign * (face - side);
                along = sign * along;
                const auto isIn = (depth > -kRowInFront) & (depth < kRowBehind) & (along > 0.0);
                sum += isIn ? weight : Doubles{};
                along = isIn ? along : Doubles{};
                std::memcpy(to + first, &along, count * sizeof(double));
            };
            inGroupsOf<kLanes<Doubles>>(size, step);
            *hits = sumOf(sum);
        });
        std::size_t taken = 0;
        for (const double along : row.along)
        {
            // Written always, counted when taken: whether it is, is hard to foretell.
            row.along[taken] = along;
            taken += along > 0.0 ? 1 : 0;
        }
        row.along.resize(taken);
        return row;
    }

    FaceBox boxOf(const Faces& faces) const
    {
        const auto middleOf = [](const auto& f) { return 0.5 * (f[0].at + f[1].at); };
        const Eigen::Vector2d middle(middleOf(faces[0]), middleOf(faces[1]));
        const Eigen::Matrix2d toWorld = rotation(turned_.heading);
        const Eigen::Vector2d centre = turned_.centre() + toWorld * middle;
        FaceBox result;
        result.box = {centre.x(), centre.y(), turned_.heading, faces[0][1].at - faces[0][0].at,
                      faces[1][1].at - faces[1][0].at};

        // d (x, y, heading, length, width) / d (turn, end line, side line)
        Eigen::Matrix<double, 5, 3> byLines = Eigen::Matrix<double, 5, 3>::Zero();
        byLines.block<2, 1>(0, 0) = toWorld * Eigen::Vector2d(-middle.y(), middle.x());
        byLines(2, 0) = 1.0;
        Matrix5d covariance = Matrix5d::Zero();
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (std::size_t end = 0; end < 2; ++end)
            {
                const FacePlace& face = faces[axis][end];
                const auto a = static_cast<int>(axis);
                const Vector5d change = byFace(toWorld, a, static_cast<int>(end));
                if (face.onLine)
                    byLines.col(1 + a) += change;
                else
                    covariance += face.variance * change * change.transpose();
                // The last hit of a row stays in place when the box turns: its coordinate along
                // the axis changes by where it lies across it.
                if (face.onRow)
                    byLines.col(0) += (axis == 0 ? 1.0 : -1.0) * nearAt(1 - axis) * change;
            }
        result.covariance = covariance + byLines * lines_.covariance * byLines.transpose();
        return result;
    }

    const Hits& hits_;
    OrientedBox turned_;
    const FaceLines& lines_;
    const MeasureOptions& options_;
    std::array<double, 2> half_;
    std::array<bool, 2> seen_;
    Eigen::Vector2d view_;  // the sensor
    std::array<double, 2> nearSign_{};
    std::array<std::vector<double>, 2> inBox_;  // the hits, along the heading and across it
};
}  // namespace

FaceBox boxFromFaces(const Hits& hits, const OrientedBox& fitted, FaceSet seen,
                     const Eigen::Vector2d& sensor, const FaceLines& lines,
                     const MeasureOptions& options)
{
    return FaceBoxBuilder(hits, fitted, seen, sensor, lines, options).build();
}

}  // namespace vdamf
