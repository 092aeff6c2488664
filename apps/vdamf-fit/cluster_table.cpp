// SPDX-License-Identifier: BSD-3-Clause
#include "cluster_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
// Words for what is no number or beyond all numbers, as programs print them.
bool isNotFinite(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.erase(0, 1);
    return text == "nan" || text == "inf" || text == "infinity";
}

// A finite number, or not a number for the words above. Anything else is an error.
double coordinate(const CsvReader& reader, const char* column)
{
    if (isNotFinite(reader.text(column))) return std::numeric_limits<double>::quiet_NaN();
    return reader.number(column);
}

std::optional<double> headingOf(const CsvReader& reader)
{
    if (!reader.hasColumn("heading_rad")) return std::nullopt;
    return reader.optionalNumber("heading_rad");
}

bool same(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}
}  // namespace

ClusterTable::ClusterTable(const std::filesystem::path& path)
    : reader_(path, {"cluster", "sensor_x_m", "sensor_y_m", "x_m", "y_m"})
{
    hasRow_ = reader_.next();
    if (!hasRow_)
    {
        throw std::runtime_error(path.string() +
                                 ": the table has no rows; expected a row for each hit");
    }
}

std::optional<TableCluster> ClusterTable::next()
{
    if (!hasRow_) return std::nullopt;
    TableCluster cluster = begun();
    do
    {
        take(cluster);
        hasRow_ = reader_.next();
    } while (hasRow_ && reader_.text("cluster") == cluster.id);
    return cluster;
}

TableCluster ClusterTable::begun()
{
    TableCluster cluster;
    cluster.id = reader_.text("cluster");
    if (cluster.id.empty())
        reader_.fail("cluster", "expected the name of a cluster, found nothing");
    if (!done_.insert(cluster.id).second)
    {
        reader_.fail("cluster", "the cluster " + inQuotes(cluster.id) +
                                    " comes back after others; the rows of a cluster must stand "
                                    "together: sort the table by cluster");
    }
    cluster.sensor = {coordinate(reader_, "sensor_x_m"), coordinate(reader_, "sensor_y_m")};
    cluster.heading = headingOf(reader_);
    return cluster;
}

void ClusterTable::take(TableCluster& cluster)
{
    const double sensorX = coordinate(reader_, "sensor_x_m");
    const double sensorY = coordinate(reader_, "sensor_y_m");
    if (!same(sensorX, cluster.sensor.x()))
        reader_.fail("sensor_x_m", "differs from the first row of the cluster");
    if (!same(sensorY, cluster.sensor.y()))
        reader_.fail("sensor_y_m", "differs from the first row of the cluster");
    if (headingOf(reader_) != cluster.heading)
        reader_.fail("heading_rad", "differs from the first row of the cluster");
    cluster.x.push_back(coordinate(reader_, "x_m"));
    cluster.y.push_back(coordinate(reader_, "y_m"));
    double sum = sensorX + sensorY + cluster.x.back() + cluster.y.back();
    if (reader_.hasColumn("z_m"))
    {
        cluster.z.push_back(coordinate(reader_, "z_m"));
        sum += cluster.z.back();
    }
    if (std::isnan(sum) && cluster.lineNotFinite == 0) cluster.lineNotFinite = reader_.line();
}

}  // namespace vdamf
