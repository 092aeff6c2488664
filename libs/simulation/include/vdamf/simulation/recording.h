// SPDX-License-Identifier: BSD-3-Clause
// Labelled real traffic, from tables that others made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vdamf/simulation/labelled_motion.h"
#include "vdamf/simulation/object_class.h"

namespace vdamf
{
struct LabelledObject
{
    std::string name;
    ObjectClass objectClass = ObjectClass::Box;
    BodySize size;
    std::vector<LabelledPose> poses;  ///< of the box's centre, in order of time
};

/// Time 0 is the first label's; none is further away than the longest scene lasts.
struct Recording
{
    std::vector<LabelledPose> platform;  ///< empty where the table does not say
    std::vector<LabelledObject> objects;
};

/// A log folder of the Argoverse 2 sensor data set: annotations.csv and city_SE3_egovehicle.csv
/// (the data set's feather files as tables). Axes of the city frame, origin at the platform's
/// first pose. The platform is the ego frame (rear axle); what the log says of the platform's own
/// body is left out. Objects stand on the scenario's ground, whatever height their labels have.
/// Throws std::runtime_error that names file, line and column.
Recording readArgoverseLog(const std::filesystem::path& folder);

/// A truth.csv (evaluation/tables.h), in its own frame. The platform is where the sensor was.
/// Throws std::runtime_error that names the file and the cell or the time, or the file without
/// objects.
Recording readTruthTable(const std::filesystem::path& path);

}  // namespace vdamf
