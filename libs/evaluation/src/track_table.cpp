// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "checked_cells.h"
#include "csv_line.h"
#include "row_order.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/files/csv.h"

namespace vdamf
{
namespace
{
// How a number of the table stands in text. Not a number: an empty cell.
enum class Form
{
    Whole,
    Decimals4,
    Decimals6,
    Significant8,
    Status,
    Faces,
    Type
};

struct Column
{
    const char* name;
    Form form;
};

// Tables of other programs may lack them.
constexpr const char* kForward = "forward_probability";
constexpr const char* kType = "vehicle_type";
constexpr const char* kTypeProbability = "type_probability";
constexpr const char* kAxes = "axes_probability";

// Order of toNumbers().
constexpr std::array<Column, 31> kTrackColumns = {{{"time_s", Form::Decimals6},
                                                   {"track_id", Form::Whole},
                                                   {"status", Form::Status},
                                                   {"vehicle_probability", Form::Decimals6},
                                                   {"is_vehicle", Form::Whole},
                                                   {"x_m", Form::Decimals4},
                                                   {"y_m", Form::Decimals4},
                                                   {"z_m", Form::Decimals4},
                                                   {"heading_rad", Form::Decimals6},
                                                   {"speed_mps", Form::Decimals4},
                                                   {"yaw_rate_radps", Form::Decimals6},
                                                   {"length_m", Form::Decimals4},
                                                   {"width_m", Form::Decimals4},
                                                   {"height_m", Form::Decimals4},
                                                   {"points", Form::Whole},
                                                   {"match", Form::Significant8},
                                                   {"nis", Form::Significant8},
                                                   {"faces_seen", Form::Faces},
                                                   {"var_x_m2", Form::Significant8},
                                                   {"cov_xy_m2", Form::Significant8},
                                                   {"var_y_m2", Form::Significant8},
                                                   {"cov_x_heading", Form::Significant8},
                                                   {"cov_y_heading", Form::Significant8},
                                                   {"var_heading_rad2", Form::Significant8},
                                                   {"var_speed", Form::Significant8},
                                                   {"var_length_m2", Form::Significant8},
                                                   {"var_width_m2", Form::Significant8},
                                                   {kForward, Form::Decimals6},
                                                   {kType, Form::Type},
                                                   {kTypeProbability, Form::Decimals6},
                                                   {kAxes, Form::Decimals6}}};

std::string significant(double value)
{
    std::array<char, 32> buffer = {};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                      std::chars_format::general, 8);
    return std::string(buffer.data(), result.ptr);
}

std::string cellOf(double value, Form form)
{
    if (std::isnan(value)) return "";
    switch (form)
    {
        case Form::Whole:
            return toFixedText(value, 0);
        case Form::Decimals4:
            return toFixedText(value, 4);
        case Form::Decimals6:
            return toFixedText(value, 6);
        case Form::Significant8:
            return significant(value);
        case Form::Status:
            return toString(static_cast<TrackStatus>(static_cast<int>(value)));
        case Form::Faces:
            return toString(FaceSet{static_cast<std::uint8_t>(value)});
        case Form::Type:
            return toString(static_cast<VehicleType>(static_cast<int>(value)));
    }
    return "";
}

TrackStatus statusOf(const CsvReader& reader)
{
    const std::optional<TrackStatus> status = trackStatusFromString(reader.text("status"));
    if (status) return *status;
    reader.fail("status", "unknown status '" + reader.text("status") +
                              "'; expected tentative, confirmed, coasting or ended");
}

FaceSet facesOf(const CsvReader& reader)
{
    const std::string& letters = reader.text("faces_seen");
    FaceSet faces;
    for (const char letter : letters)
    {
        if (letter == 'F') faces.add(Face::Front);
        if (letter == 'B') faces.add(Face::Back);
        if (letter == 'L') faces.add(Face::Left);
        if (letter == 'R') faces.add(Face::Right);
    }
    if (toString(faces).size() == letters.size()) return faces;
    reader.fail("faces_seen",
                "expected letters F, B, L, R, each at most once, found '" + letters + "'");
}

std::int64_t countOf(const CsvReader& reader, const char* column, std::int64_t max)
{
    const std::int64_t value = reader.integer(column);
    if (value >= 0 && value <= max) return value;
    reader.fail(column, "expected a number from 0 to " + std::to_string(max));
}

Eigen::Matrix4d covarianceOf(const CsvReader& reader)
{
    Eigen::Matrix4d upper = Eigen::Matrix4d::Zero();
    upper(0, 0) = varianceIn(reader, "var_x_m2");
    upper(0, 1) = reader.number("cov_xy_m2");
    upper(1, 1) = varianceIn(reader, "var_y_m2");
    upper(0, 2) = reader.number("cov_x_heading");
    upper(1, 2) = reader.number("cov_y_heading");
    upper(2, 2) = varianceIn(reader, "var_heading_rad2");
    upper(3, 3) = varianceIn(reader, "var_speed");
    return upper.selfadjointView<Eigen::Upper>();
}

// What the table may not hold.
double probabilityIn(const CsvReader& reader, const char* column, double unknown)
{
    const auto known = reader.hasColumn(column) ? reader.optionalNumber(column) : std::nullopt;
    const double probability = known.value_or(unknown);
    if (probability >= 0.0 && probability <= 1.0) return probability;
    reader.fail(column, "expected a number from 0 to 1");
}

std::optional<TypeProbability> typeOf(const CsvReader& reader)
{
    if (!reader.hasColumn(kType) || reader.text(kType).empty()) return std::nullopt;
    const std::optional<VehicleType> type = vehicleTypeFromString(reader.text(kType));
    if (!type)
        reader.fail(kType, "unknown type '" + reader.text(kType) +
                               "'; expected car, van, truck, two_wheeler or any");
    return TypeProbability{*type, probabilityIn(reader, kTypeProbability, 1.0)};
}

TrackReport reportOf(const CsvReader& reader)
{
    TrackReport report;
    report.id = static_cast<std::uint64_t>(
        countOf(reader, "track_id", std::numeric_limits<std::int64_t>::max()));
    report.status = statusOf(reader);
    report.vehicleProbability = reader.optionalNumber("vehicle_probability");
    const double probability = report.vehicleProbability.value_or(0.0);
    if (probability < 0.0 || probability > 1.0)
        reader.fail("vehicle_probability", "expected a number from 0 to 1");
    if (const std::optional<double> isVehicle = reader.optionalNumber("is_vehicle"))
    {
        if (*isVehicle != 0.0 && *isVehicle != 1.0) reader.fail("is_vehicle", "expected 0 or 1");
        report.isVehicle = *isVehicle == 1.0;
    }
    report.box = {reader.number("x_m"), reader.number("y_m"), reader.number("heading_rad"),
                  sizeIn(reader, "length_m"), sizeIn(reader, "width_m")};
    report.z = reader.number("z_m");
    report.height = reader.number("height_m");
    report.speed = reader.number("speed_mps");
    report.yawRate = reader.number("yaw_rate_radps");
    report.points = static_cast<int>(countOf(reader, "points", std::numeric_limits<int>::max()));
    report.match = reader.number("match");
    report.nis = reader.optionalNumber("nis");
    if (report.nis.value_or(0.0) < 0.0)
        reader.fail("nis", "a square is not below 0, found '" + reader.text("nis") + "'");
    report.facesSeen = facesOf(reader);
    report.covariance = covarianceOf(reader);
    report.lengthVariance = varianceIn(reader, "var_length_m2");
    report.widthVariance = varianceIn(reader, "var_width_m2");
    report.forwardProbability = probabilityIn(reader, kForward, report.forwardProbability);
    report.axesProbability = probabilityIn(reader, kAxes, report.axesProbability);
    report.type = typeOf(reader);
    return report;
}

std::vector<std::string> requiredColumns()
{
    std::vector<std::string> names = trackColumns();
    for (const char* optional : {kForward, kType, kTypeProbability, kAxes})
        names.erase(std::find(names.begin(), names.end(), optional));
    return names;
}
}  // namespace

const std::vector<std::string>& trackColumns()
{
    static const std::vector<std::string> kNames = []
    {
        std::vector<std::string> names;
        names.reserve(kTrackColumns.size());
        for (const Column& column : kTrackColumns) names.emplace_back(column.name);
        return names;
    }();
    return kNames;
}

std::string tracksHeader()
{
    return joined(trackColumns(), ",") + '\n';
}

std::vector<double> toNumbers(double time, const TrackReport& report)
{
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    const std::optional<double>& probability = report.vehicleProbability;
    const std::optional<bool> vehicle = isCalledVehicle(report);
    const double isVehicle = vehicle ? (*vehicle ? 1.0 : 0.0) : kNothing;
    const OrientedBox& box = report.box;
    const Eigen::Matrix4d& p = report.covariance;
    return {time,
            static_cast<double>(report.id),
            static_cast<double>(report.status),
            probability.value_or(kNothing),
            isVehicle,
            box.x,
            box.y,
            report.z,
            box.heading,
            report.speed,
            report.yawRate,
            box.length,
            box.width,
            report.height,
            static_cast<double>(report.points),
            report.match,
            report.nis.value_or(kNothing),
            static_cast<double>(report.facesSeen.bits),
            p(0, 0),
            p(0, 1),
            p(1, 1),
            p(0, 2),
            p(1, 2),
            p(2, 2),
            p(3, 3),
            report.lengthVariance,
            report.widthVariance,
            report.forwardProbability,
            report.type ? static_cast<double>(report.type->type) : kNothing,
            report.type ? report.type->probability : kNothing,
            report.axesProbability};
}

std::string toCsv(const FrameResult& frame)
{
    std::string lines;
    for (const TrackReport& report : frame.tracks)
    {
        const std::vector<double> numbers = toNumbers(frame.time, report);
        std::vector<std::string> cells;
        for (std::size_t i = 0; i < kTrackColumns.size(); ++i)
            cells.push_back(cellOf(numbers[i], kTrackColumns[i].form));
        lines += joined(cells, ",") + '\n';
    }
    return lines;
}

std::vector<TrackRow> readTracks(const std::filesystem::path& path)
{
    CsvReader reader(path, requiredColumns());
    std::vector<TrackRow> rows;
    RowOrder<std::uint64_t> order;
    while (reader.next())
    {
        rows.push_back({reader.number("time_s"), reportOf(reader)});
        order.check(reader, rows.back().time, rows.back().report.id, "track_id");
    }
    return rows;
}

}  // namespace vdamf
