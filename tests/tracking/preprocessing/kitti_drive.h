// SPDX-License-Identifier: BSD-3-Clause
// Scans and labels of a KITTI raw drive, read the short way, for measurements in tests.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf::test
{
/// A labelled object in one scan, in the frame of the LADAR.
struct Label
{
    OrientedBox box;
    double bottom = 0.0;  ///< z, m
    double height = 0.0;  ///< m
    std::string type;
};

/// Labels by scan of a tracklet_labels.xml: its elements come one a line and in fixed order.
inline std::map<int, std::vector<Label>> readLabels(const std::filesystem::path& file)
{
    std::map<int, std::vector<Label>> labels;
    std::ifstream in(file);
    std::string line;
    Label label;
    int scan = 0;
    const auto value = [&line] { return std::stod(line.substr(line.find('>') + 1)); };
    const auto is = [&line](const char* tag) { return line.find(tag) != std::string::npos; };
    while (std::getline(in, line))
    {
        if (is("<objectType>"))
        {
            const auto from = line.find('>') + 1;
            label.type = line.substr(from, line.find('<', from) - from);
        }
        else if (is("<h>"))
            label.height = value();
        else if (is("<w>"))
            label.box.width = value();
        else if (is("<l>"))
            label.box.length = value();
        else if (is("<first_frame>"))
            scan = static_cast<int>(value());
        else if (is("<tx>"))
            label.box.x = value();
        else if (is("<ty>"))
            label.box.y = value();
        else if (is("<tz>"))
            label.bottom = value();
        else if (is("<rz>"))
        {
            label.box.heading = wrapAngle(value());
            labels[scan++].push_back(label);
        }
    }
    return labels;
}

/// A scan file: float x, y, z, reflectance a hit. Empty where there is none.
inline PointCloud readScan(const std::filesystem::path& drive, int scan)
{
    char name[32];
    std::snprintf(name, sizeof name, "%010d.bin", scan);
    const auto file = drive / "velodyne_points" / "data" / name;
    std::ifstream in(file, std::ios::binary);
    PointCloud points;
    if (!in) return points;
    std::vector<float> values(std::filesystem::file_size(file) / sizeof(float));
    in.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(float)));
    for (std::size_t i = 0; i + 4 <= values.size(); i += 4)
    {
        points.x.push_back(values[i]);
        points.y.push_back(values[i + 1]);
        points.z.push_back(values[i + 2]);
    }
    return points;
}

}  // namespace vdamf::test
