// SPDX-License-Identifier: BSD-3-Clause
// Tables as text, for tests that write and spoil them.
#pragma once

#include "../files/temporary_folder.h"
#include "vdamf/evaluation/tables.h"

namespace vdamf
{
class TablesTest : public TemporaryFolder
{
protected:
    std::string truthError(const std::string& content)
    {
        const auto path = make("truth.csv", content);
        return errorOf([&] { readTruth(path); });
    }
    std::string tracksError(const std::string& content)
    {
        const auto path = make("tracks.csv", content);
        return errorOf([&] { readTracks(path); });
    }
};

inline constexpr const char* kTruthHeader =
    "time_s,object_id,class,x_m,y_m,z_m,heading_rad,length_m,width_m,height_m,speed_mps,points,"
    "sensor_x_m,sensor_y_m,sensor_heading_rad\n";

inline constexpr const char* kHeaderWithoutSensor =
    "time_s,object_id,class,x_m,y_m,z_m,heading_rad,length_m,width_m,height_m,speed_mps,points\n";

inline constexpr const char* kTracksHeader =
    "time_s,track_id,status,vehicle_probability,is_vehicle,x_m,y_m,z_m,heading_rad,speed_mps,"
    "yaw_rate_radps,length_m,width_m,height_m,points,match,nis,faces_seen,var_x_m2,cov_xy_m2,"
    "var_y_m2,cov_x_heading,cov_y_heading,var_heading_rad2,var_speed,var_length_m2,var_width_m2,"
    "forward_probability,vehicle_type,type_probability,axes_probability\n";

inline constexpr const char* kTrackLine =
    "1317042145.964000,7,confirmed,0.900000,1,1.0000,2.0000,-0.5000,0.100000,8.0000,0.010000,"
    "4.5000,1.8000,1.5000,120,1.25,2.5,FL,0.01,0.001,0.02,0.0001,0.0002,0.0003,0.25,0.04,0.01,0."
    "500000,truck,0.750000,0.875000\n";

}  // namespace vdamf
