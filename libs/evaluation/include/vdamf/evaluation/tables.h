// SPDX-License-Identifier: BSD-3-Clause
// truth.csv and tracks.csv: the tables that programs exchange. Columns: README of apps.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// Where the sensor stood in the plane, for what is said by range, bearing and faces seen.
struct PlanePose
{
    double x = 0.0;        ///< m
    double y = 0.0;        ///< m
    double heading = 0.0;  ///< of the vehicle that carries it, rad
};

/// One labelled object in one frame. World frame: x east, y north, z up.
struct TruthRow
{
    double time = 0.0;                ///< s (UNIX)
    std::string objectId;             ///< kCellText of files/csv.h
    std::string objectClass;          ///< Car, Van, Truck, Tram, Bus, Pedestrian, Cyclist, Other
    OrientedBox box;                  ///< m, rad
    double z = 0.0;                   ///< bottom, m
    double height = 0.0;              ///< m
    double speed = 0.0;               ///< along the heading, m/s
    int points = -1;                  ///< LADAR hits inside the box, -1 if unknown
    std::optional<PlanePose> sensor;  ///< at this time; nothing where the table does not say
};

/// One row of tracks.csv.
struct TrackRow
{
    double time = 0.0;
    TrackReport report;
};

// Times are written with 6 decimals, all other numbers with enough digits for their use (0.1 mm,
// 1e-6 rad, 8 significant digits of variances). Readers throw std::runtime_error that names file,
// line and column: for cells that cannot be read, times that go back, and an object or a track that
// stands twice at one time.

/// The classes of truth.csv.
const std::vector<std::string>& truthClasses();
/// Car, Van, Truck, Tram and Bus.
const std::vector<std::string>& vehicleClasses();
bool isVehicleClass(const std::string& objectClass);
/// Without the columns of `sensor`, which a table may lack.
const std::vector<std::string>& truthColumns();
std::string truthHeader();               ///< with the line's end
std::string toCsv(const TruthRow& row);  ///< with the line's end
std::vector<TruthRow> readTruth(const std::filesystem::path& path);

const std::vector<std::string>& trackColumns();
std::string tracksHeader();                   ///< with the line's end
std::string toCsv(const FrameResult& frame);  ///< one line a track
/// What the table does not hold stays empty: measuredBox, the covariances of the speed. A table
/// without forward_probability or axes_probability knows nothing of it: 0.5; one without
/// vehicle_type of types.
std::vector<TrackRow> readTracks(const std::filesystem::path& path);

/// The columns of tracks.csv as numbers, in order (status by its enum value, faces by their bits,
/// NaN for what is empty): the table inside annotated rawlogs. Column names: trackColumns().
std::vector<double> toNumbers(double time, const TrackReport& report);

}  // namespace vdamf
