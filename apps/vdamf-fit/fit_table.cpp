// SPDX-License-Identifier: BSD-3-Clause
#include "fit_table.h"

#include <array>
#include <charconv>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
// The upper triangle of the covariance of (x, y, heading, length, width), column by column: each
// parameter with those before it, then its variance.
constexpr std::array<const char*, 15> kCovariance = {
    "var_x_m2",         "cov_xy_m2",    "var_y_m2",          "cov_x_heading",      "cov_y_heading",
    "var_heading_rad2", "cov_x_length", "cov_y_length",      "cov_heading_length", "var_length_m2",
    "cov_x_width",      "cov_y_width",  "cov_heading_width", "cov_length_width",   "var_width_m2"};

std::string significant(double value)
{
    std::array<char, 32> buffer = {};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::general, 8);
    return {buffer.data(), end.ptr};
}
}  // namespace

std::string fitsHeader()
{
    std::string header =
        "cluster,points,x_m,y_m,heading_rad,length_m,width_m,match,iterations,converged,reason,"
        "faces_seen";
    for (const char* column : kCovariance) header += std::string(",") + column;
    return header + "\n";
}

std::string toCsv(const TableCluster& cluster, const ClusterFit& fit)
{
    std::string row = cluster.id + "," + std::to_string(cluster.x.size()) + ",";
    if (!fit.measurement)
        return row + ",,,,,,0,0," + fit.reason + "," + std::string(kCovariance.size(), ',') + "\n";
    const Measurement& m = *fit.measurement;
    row += toFixedText(m.box.x, 4) + "," + toFixedText(m.box.y, 4) + "," +
           toFixedText(m.box.heading, 6) + "," + toFixedText(m.box.length, 4) + "," +
           toFixedText(m.box.width, 4) + "," + significant(m.match) + "," +
           std::to_string(m.iterations) + "," + (fit.converged ? "1," : "0,") + fit.reason + "," +
           toString(m.facesSeen);
    for (int column = 0; column < 5; ++column)
        for (int line = 0; line <= column; ++line)
            row += "," + significant(m.covariance(line, column));
    return row + "\n";
}

}  // namespace vdamf
