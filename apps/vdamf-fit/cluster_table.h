// SPDX-License-Identifier: BSD-3-Clause
// clusters.csv, cluster by cluster.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "vdamf/files/csv.h"

namespace vdamf
{
/// The rows of one cluster. Coordinates as in the table: any plane frame, m.
struct TableCluster
{
    std::string id;
    Eigen::Vector2d sensor = Eigen::Vector2d::Zero();
    std::optional<double> heading;  ///< to start with, rad
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;  ///< above the ground; empty where the table has no such column
    int lineNotFinite = 0;  ///< first line with a coordinate like nan or inf; 0: none
};

/// Reads one cluster at a time: holds the largest cluster and the names of all.
class ClusterTable
{
public:
    /// Throws std::runtime_error that names file, line and column, as CsvReader does.
    explicit ClusterTable(const std::filesystem::path& path);

    /// The next cluster, nothing at the end. Throws for a bad number, for a cluster whose rows do
    /// not stand together, and for rows of one cluster that disagree about sensor or heading.
    std::optional<TableCluster> next();

private:
    TableCluster begun();
    void take(TableCluster& cluster);

    CsvReader reader_;
    bool hasRow_ = false;
    std::unordered_set<std::string> done_;
};

}  // namespace vdamf
