// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/annotation_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "vdamf/evaluation/tables.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Finds the columns of a table by name, once for all of its rows.
class Row
{
public:
    explicit Row(const std::vector<std::string>& columns) : columns_(columns) {}

    void moveTo(const double* row) { row_ = row; }

    /// NaN where the table has no such column.
    double operator()(const char* column) const
    {
        const auto found = std::find(columns_.begin(), columns_.end(), column);
        return found != columns_.end() ? row_[found - columns_.begin()] : kNothing;
    }
    double required(const char* column) const
    {
        const double value = (*this)(column);
        if (std::isfinite(value)) return value;
        throw std::runtime_error(std::string("no value for '") + column + "'");
    }
    double orZero(const char* column) const
    {
        const double value = (*this)(column);
        return std::isfinite(value) ? value : 0.0;
    }
    std::optional<double> optional(const char* column) const
    {
        const double value = (*this)(column);
        return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
    }

private:
    const std::vector<std::string>& columns_;
    const double* row_ = nullptr;
};

int wholeNumber(const Row& row, const char* column, double max)
{
    const double value = row.required(column);
    if (value >= 0.0 && value <= max && value == std::floor(value)) return static_cast<int>(value);
    throw std::runtime_error("an impossible " + std::string(column) + ": " + toText(value));
}

std::optional<OrientedBox> measuredBox(const Row& row)
{
    const OrientedBox box{row("measured_x_m"), row("measured_y_m"), row("measured_heading_rad"),
                          row("measured_length_m"), row("measured_width_m")};
    const std::array<double, 5> all{box.x, box.y, box.heading, box.length, box.width};
    const bool known =
        std::all_of(all.begin(), all.end(), [](double value) { return std::isfinite(value); });
    return known ? std::optional<OrientedBox>(box) : std::nullopt;
}

Eigen::Matrix4d covarianceOf(const Row& row)
{
    Eigen::Matrix4d upper = Eigen::Matrix4d::Zero();
    upper(0, 0) = row.orZero("var_x_m2");
    upper(0, 1) = row.orZero("cov_xy_m2");
    upper(1, 1) = row.orZero("var_y_m2");
    upper(0, 2) = row.orZero("cov_x_heading");
    upper(1, 2) = row.orZero("cov_y_heading");
    upper(2, 2) = row.orZero("var_heading_rad2");
    upper(3, 3) = row.orZero("var_speed");
    return upper.selfadjointView<Eigen::Upper>();
}

std::optional<TypeProbability> typeOf(const Row& row)
{
    if (!row.optional("vehicle_type")) return std::nullopt;
    const auto last = static_cast<int>(VehicleType::TwoWheeler);
    return TypeProbability{static_cast<VehicleType>(wholeNumber(row, "vehicle_type", last)),
                           row.optional("type_probability").value_or(1.0)};
}

TrackReport reportOf(const Row& row)
{
    constexpr int kAllFaces = 15;
    TrackReport report;
    report.id =
        static_cast<std::uint64_t>(wholeNumber(row, "track_id", std::numeric_limits<int>::max()));
    report.status =
        static_cast<TrackStatus>(wholeNumber(row, "status", static_cast<int>(TrackStatus::Ended)));
    report.vehicleProbability = row.optional("vehicle_probability");
    if (const std::optional<double> vehicle = row.optional("is_vehicle"))
        report.isVehicle = *vehicle > 0.5;
    report.forwardProbability = row.optional("forward_probability").value_or(0.5);
    report.axesProbability = row.optional("axes_probability").value_or(0.5);
    report.type = typeOf(row);
    report.box = {row.required("x_m"), row.required("y_m"), row.required("heading_rad"),
                  row.required("length_m"), row.required("width_m")};
    report.z = row.orZero("z_m");
    report.height = row.orZero("height_m");
    report.speed = row.orZero("speed_mps");
    report.yawRate = row.orZero("yaw_rate_radps");
    report.points = static_cast<int>(
        std::clamp(row.orZero("points"), 0.0, double{std::numeric_limits<int>::max()}));
    report.match = row.orZero("match");
    report.nis = row.optional("nis");
    report.facesSeen.bits = static_cast<std::uint8_t>(
        static_cast<int>(std::clamp(row.orZero("faces_seen"), 0.0, double{kAllFaces})));
    report.covariance = covarianceOf(row);
    report.lengthVariance = row.orZero("var_length_m2");
    report.widthVariance = row.orZero("var_width_m2");
    report.measuredBox = measuredBox(row);
    return report;
}
}  // namespace

const std::vector<std::string>& annotationColumns()
{
    static const std::vector<std::string> kNames = []
    {
        std::vector<std::string> names = trackColumns();
        for (const char* name : {"measured_x_m", "measured_y_m", "measured_heading_rad",
                                 "measured_length_m", "measured_width_m"})
            names.emplace_back(name);
        return names;
    }();
    return kNames;
}

std::vector<double> annotationRow(double time, const TrackReport& report)
{
    std::vector<double> row = toNumbers(time, report);
    const OrientedBox box =
        report.measuredBox.value_or(OrientedBox{kNothing, kNothing, kNothing, kNothing, kNothing});
    for (const double value : {box.x, box.y, box.heading, box.length, box.width})
        row.push_back(value);
    return row;
}

std::vector<TrackReport> tracksOf(const std::vector<std::string>& columns,
                                  const std::vector<double>& numbers)
{
    if (columns.empty()) throw std::runtime_error("no columns are known");
    if (numbers.size() % columns.size() != 0)
        throw std::runtime_error(std::to_string(numbers.size()) +
                                 " numbers, which is no multiple of its " +
                                 std::to_string(columns.size()) + " columns");
    std::vector<TrackReport> tracks;
    Row row(columns);
    for (std::size_t i = 0; i < numbers.size(); i += columns.size())
    {
        row.moveTo(numbers.data() + i);
        tracks.push_back(reportOf(row));
    }
    return tracks;
}

}  // namespace vdamf
