// SPDX-License-Identifier: BSD-3-Clause
// Tables of clusters, and vdamf-fit run on them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "apps/command_line.h"
#include "files/temporary_folder.h"
#include "vdamf/files/csv.h"
#include "vdamf/files/numbers.h"
#include "vdamf/simulation/random_stream.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
inline const std::string kFitHeader = "cluster,sensor_x_m,sensor_y_m,x_m,y_m\n";
// A car seen from behind right, from the origin of the frame.
inline const OrientedBox kCar{14.0, 3.0, -0.4, 4.4, 1.8};

/// Rows of a cluster: hits 5 cm apart on the rear and the right side of the box, 1 cm off.
inline std::string twoFaces(const std::string& id, const OrientedBox& box,
                            const Eigen::Vector2d& sensor, const std::string& more = "")
{
    RandomStream random(1, 0);
    std::string rows;
    const double l = 0.5 * box.length;
    const double w = 0.5 * box.width;
    const int count = static_cast<int>(std::lround((box.length + box.width) / 0.05));
    for (int i = 0; i < count; ++i)
    {
        const double along = 0.05 * i;
        const Eigen::Vector2d onFace = along < box.length
                                           ? Eigen::Vector2d(along - l, -w)
                                           : Eigen::Vector2d(-l, along - box.length - w);
        const Eigen::Vector2d off(0.01 * random.gaussian(), 0.01 * random.gaussian());
        const Eigen::Vector2d hit = box.centre() + rotation(box.heading) * (onFace + off);
        rows += id + "," + toText(sensor.x()) + "," + toText(sensor.y()) + "," + toText(hit.x()) +
                "," + toText(hit.y()) + more + "\n";
    }
    return rows;
}

class FitProgram : public TemporaryFolder
{
protected:
    /// Runs the program on a table; its exit code. Output of both streams: output_.
    int fit(const std::string& table, const std::string& arguments = "")
    {
        make("clusters.csv", table);
        return run("-i clusters.csv -o fits.csv --overwrite " + arguments);
    }

    int run(const std::string& arguments)
    {
        const Outcome outcome =
            runShell("cd '" + at("").string() + "' && '" VDAMF_APPS_DIR "/vdamf-fit' " + arguments);
        output_ = outcome.output;
        return outcome.exitCode;
    }

    CsvReader fits() const { return {at("fits.csv"), {"cluster", "converged", "reason"}}; }

    void expectNearCar(const CsvReader& row, double tolerance, const Eigen::Vector2d& offset) const
    {
        EXPECT_NEAR(row.number("x_m") - offset.x(), kCar.x, tolerance);
        EXPECT_NEAR(row.number("y_m") - offset.y(), kCar.y, tolerance);
        EXPECT_NEAR(row.number("heading_rad"), kCar.heading, 0.02);
        EXPECT_NEAR(row.number("length_m"), kCar.length, 2.0 * tolerance);
        EXPECT_NEAR(row.number("width_m"), kCar.width, 2.0 * tolerance);
        EXPECT_EQ(row.text("faces_seen"), "BR");
        EXPECT_EQ(row.integer("converged"), 1);
        EXPECT_EQ(row.text("reason"), "");
    }

    std::string output_;
};

}  // namespace vdamf
