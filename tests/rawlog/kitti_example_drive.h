// SPDX-License-Identifier: BSD-3-Clause
// A KITTI drive of three scans that a test writes itself, with everything known.
//
// The vehicle drives north (yaw 90 deg) at 10 m/s from 49 deg north, 8.4 deg east; a scan each
// 0.1 s. The velodyne sits 1 m ahead of the INS and 0.5 m above it, not turned. A parked car
// stands 20 m ahead of the first velodyne position and 3 m to the left, facing the vehicle; a van
// drives 15 m ahead as fast as the vehicle, seen from the second scan on.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
class KittiExampleDrive
{
public:
    static constexpr int kScans = 3;
    static constexpr double kLatitude = 49.0;  // deg

    explicit KittiExampleDrive(const std::filesystem::path& day)
        : folder_(day / "2011_09_26_drive_0042_sync")
    {
        write(day / "calib_imu_to_velo.txt",
              "calib_time: 15-Mar-2012 11:37:16\nR: 1 0 0 0 1 0 0 0 1\nT: -1 0 -0.5\n");
        write(folder_ / "velodyne_points" / "timestamps.txt", timestamps());
        write(folder_ / "oxts" / "timestamps.txt", timestamps());
        for (int i = 0; i < kScans; ++i)
        {
            write(scanFile(i), scan(i));
            write(oxtsFile(i), oxts(i));
        }
        write(trackletFile(), tracklets());
    }

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path scanFile(int i) const
    {
        return folder_ / "velodyne_points" / "data" / (number(i) + ".bin");
    }
    std::filesystem::path oxtsFile(int i) const
    {
        return folder_ / "oxts" / "data" / (number(i) + ".txt");
    }
    std::filesystem::path trackletFile() const { return folder_ / "tracklet_labels.xml"; }

    static void write(const std::filesystem::path& path, const std::string& bytes)
    {
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << bytes;
    }

    /// The drive goes on, at 100 ms a scan, until it has so many.
    void lengthenTo(int scans) const
    {
        std::string times = timestamps();
        for (int i = kScans; i < scans; ++i)
        {
            const int milliseconds = 64 + 100 * (i - 1);
            char line[64];
            std::snprintf(line, sizeof line, "2011-09-26 13:02:%02d.%03d000000\n",
                          26 + milliseconds / 1000, milliseconds % 1000);
            times += line;
            write(scanFile(i), scan(i));
            write(oxtsFile(i), oxts(i));
        }
        for (const char* part : {"velodyne_points", "oxts"})
            write(folder_ / part / "timestamps.txt", times);
    }

    static std::string timestamps()
    {
        return "2011-09-26 13:02:25.963999987\n2011-09-26 13:02:26.064000000\n"
               "2011-09-26 13:02:26.164000049\n";
    }

    // One INS sample; north by 1 m a scan on the Mercator map with the first latitude's scale.
    static std::string oxts(int i)
    {
        constexpr double kEarthRadius = 6378137.0;
        const double scale = std::cos(kLatitude * kDegree);
        const double mercator = std::log(std::tan(0.5 * (90.0 + kLatitude) * kDegree));
        const double latitude =
            2.0 * std::atan(std::exp(mercator + i / (scale * kEarthRadius))) / kDegree - 90.0;
        std::ostringstream text;
        text.precision(17);
        text << latitude << " 8.4 116.5 0 0 " << 90.0 * kDegree;
        for (int value = 6; value < 30; ++value) text << (value == 26 ? " 9" : " 0");
        return text.str() + "\n";
    }

    // Two points on the parked car, one a hand's breadth beside it, one on the road.
    static std::string scan(int i)
    {
        const float ahead = static_cast<float>(20 - i);
        const std::vector<float> values = {ahead,        3.0F, -1.0F, 0.25F,  //
                                           ahead - 1.9F, 2.1F, -0.5F, 0.5F,   //
                                           ahead,        1.9F, -1.0F, 0.75F,  //
                                           5.0F,         0.0F, -1.7F, 0.0F};
        std::string bytes(values.size() * sizeof(float), '\0');
        std::memcpy(bytes.data(), values.data(), bytes.size());
        return bytes;
    }

    static std::string tracklets()
    {
        return "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\" ?>\n"
               "<!DOCTYPE boost_serialization>\n"
               "<boost_serialization signature=\"serialization::archive\" version=\"9\">\n"
               "<tracklets class_id=\"0\" tracking_level=\"0\" version=\"0\">\n"
               "<count>2</count>\n<item_version>1</item_version>\n" +
               tracklet("Car", 0, {{20, 3}, {19, 3}, {18, 3}}, 3.14159265358979323846) +
               tracklet("Van", 1, {{15, 0}, {15, 0}}, 0.0) +
               "</tracklets>\n</boost_serialization>\n";
    }

private:
    static std::string number(int i)
    {
        char text[16] = {};
        std::snprintf(text, sizeof text, "%010d", i);
        return text;
    }

    static std::string tracklet(const std::string& type, int first,
                                const std::vector<std::pair<double, double>>& places,
                                double heading)
    {
        std::ostringstream xml;
        xml.precision(17);
        xml << "<item>\n<objectType>" << type << "</objectType>\n<h>1.5</h>\n<w>2</w>\n<l>4</l>\n"
            << "<first_frame>" << first << "</first_frame>\n<poses>\n<count>" << places.size()
            << "</count>\n<item_version>2</item_version>\n";
        for (const auto& [x, y] : places)
        {
            xml << "<item><tx>" << x << "</tx><ty>" << y << "</ty><tz>-1.75</tz>"
                << "<rx>0</rx><ry>0</ry><rz>" << heading << "</rz><state>2</state></item>\n";
        }
        xml << "</poses>\n<finished>1</finished>\n</item>\n";
        return xml.str();
    }

    std::filesystem::path folder_;
};

}  // namespace vdamf
