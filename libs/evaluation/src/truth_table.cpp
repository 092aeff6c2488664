// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "checked_cells.h"
#include "csv_line.h"
#include "row_order.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/files/csv.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
std::string checkedId(const std::string& id)
{
    if (!id.empty() && id == cellText(id)) return id;
    throw std::runtime_error("object id " + inQuotes(id) +
                             " cannot stand in truth.csv: it must be " + kCellText);
}

std::string classOf(const CsvReader& reader)
{
    const std::vector<std::string>& known = truthClasses();
    const std::string& name = reader.text("class");
    if (std::find(known.begin(), known.end(), name) != known.end()) return name;
    reader.fail("class", "unknown class '" + name + "'; expected one of " + joined(known, ", "));
}

const std::vector<std::string>& sensorColumns()
{
    static const std::vector<std::string> kColumns = {"sensor_x_m", "sensor_y_m",
                                                      "sensor_heading_rad"};
    return kColumns;
}

std::string sensorCells(const std::optional<PlanePose>& sensor)
{
    if (!sensor) return ",,";
    return joined(
        {toFixedText(sensor->x, 4), toFixedText(sensor->y, 4), toFixedText(sensor->heading, 6)},
        ",");
}

/// All three or none: a pose in parts is a mistake of whoever wrote the table.
std::optional<PlanePose> sensorOf(const CsvReader& reader)
{
    std::vector<double> values;
    for (const std::string& column : sensorColumns())
    {
        const auto value = reader.hasColumn(column) ? reader.optionalNumber(column) : std::nullopt;
        if (value) values.push_back(*value);
    }
    if (values.empty()) return std::nullopt;
    if (values.size() == 3) return PlanePose{values[0], values[1], values[2]};
    reader.fail("sensor_x_m", "expected all of " + joined(sensorColumns(), ", ") + ", or none");
}

TruthRow rowOf(const CsvReader& reader)
{
    TruthRow row;
    row.time = reader.number("time_s");
    row.objectId = reader.text("object_id");
    if (row.objectId.empty()) reader.fail("object_id", "it is empty");
    row.objectClass = classOf(reader);
    row.box = {reader.number("x_m"), reader.number("y_m"), reader.number("heading_rad"),
               sizeIn(reader, "length_m"), sizeIn(reader, "width_m")};
    row.z = reader.number("z_m");
    row.height = reader.number("height_m");
    row.speed = reader.number("speed_mps");
    const std::int64_t points = reader.integer("points");
    if (points < -1 || points > std::numeric_limits<int>::max())
    {
        reader.fail("points", "expected a count, or -1 if unknown");
    }
    row.points = static_cast<int>(points);
    row.sensor = sensorOf(reader);
    return row;
}
}  // namespace

const std::vector<std::string>& truthClasses()
{
    static const std::vector<std::string> kClasses = {"Car", "Van",        "Truck",   "Tram",
                                                      "Bus", "Pedestrian", "Cyclist", "Other"};
    return kClasses;
}

const std::vector<std::string>& vehicleClasses()
{
    static const std::vector<std::string> kVehicles = {"Car", "Van", "Truck", "Tram", "Bus"};
    return kVehicles;
}

bool isVehicleClass(const std::string& objectClass)
{
    const std::vector<std::string>& vehicles = vehicleClasses();
    return std::find(vehicles.begin(), vehicles.end(), objectClass) != vehicles.end();
}

const std::vector<std::string>& truthColumns()
{
    static const std::vector<std::string> kColumns = {
        "time_s",      "object_id", "class",   "x_m",      "y_m",       "z_m",
        "heading_rad", "length_m",  "width_m", "height_m", "speed_mps", "points"};
    return kColumns;
}

std::string truthHeader()
{
    return joined(truthColumns(), ",") + ',' + joined(sensorColumns(), ",") + '\n';
}

std::string toCsv(const TruthRow& row)
{
    const OrientedBox& box = row.box;
    return joined({toFixedText(row.time, 6), checkedId(row.objectId), row.objectClass,
                   toFixedText(box.x, 4), toFixedText(box.y, 4), toFixedText(row.z, 4),
                   toFixedText(box.heading, 6), toFixedText(box.length, 4),
                   toFixedText(box.width, 4), toFixedText(row.height, 4), toFixedText(row.speed, 4),
                   std::to_string(row.points), sensorCells(row.sensor)},
                  ",") +
           '\n';
}

std::vector<TruthRow> readTruth(const std::filesystem::path& path)
{
    CsvReader reader(path, truthColumns());
    std::vector<TruthRow> rows;
    RowOrder<std::string> order;
    while (reader.next())
    {
        rows.push_back(rowOf(reader));
        order.check(reader, rows.back().time, rows.back().objectId, "object_id");
    }
    return rows;
}

}  // namespace vdamf
