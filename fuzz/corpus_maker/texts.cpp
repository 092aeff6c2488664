// SPDX-License-Identifier: BSD-3-Clause
// Tables, configurations and files of KITTI: from the small street where it has them.
#include <cstring>

#include "corpus.h"
#include "street.h"
#include "vdamf/files/numbers.h"
#include "vdamf/rawlog/configuration.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf::fuzz
{
namespace
{
FrameResult trackOn(const TruthRow& truth)
{
    TrackReport report;
    report.id = 7;
    report.status = TrackStatus::Confirmed;
    report.vehicleProbability = 0.8;
    report.box = truth.box;
    report.box.x += 0.1;
    report.z = truth.z;
    report.height = truth.height;
    report.speed = truth.speed;
    report.points = 50;
    report.match = 1.2;
    report.nis = 2.5;
    report.facesSeen.add(Face::Back);
    report.covariance = 0.01 * Eigen::Matrix4d::Identity();
    report.lengthVariance = report.widthVariance = 0.1;
    return {truth.time, {report}, 0, 0, 0, {}};
}

std::string clusters()
{
    const Street street = smallStreet("VLP-16", 1, 10.0);
    std::string table = "cluster,sensor_x_m,sensor_y_m,x_m,y_m,z_m,heading_rad\n";
    const PointCloud points = scanFrom(*thinned(*street.observations.at(1), 150))->points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (points.z[i] < -1.5F) continue;  // the road
        const auto cell = [](float value) { return toFixedText(static_cast<double>(value), 3); };
        table += "a,0,0," + cell(points.x[i]) + ',' + cell(points.y[i]) + ',' +
                 cell(points.z[i] + 1.8F) + ",0.1\n";
    }
    return table + "b,0,0,nan,1,1,\nc,1e6,0,1e6,5,0,\nc,1e6,0,1000001,5,0,\nc,1e6,0,1000001,6,0,\n";
}

std::string tracklets()
{
    return "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\" ?>\n"
           "<boost_serialization signature=\"serialization::archive\" version=\"9\">\n"
           "<tracklets class_id=\"0\" "
           "version=\"0\">\n<count>1</count>\n<item_version>1</item_version>"
           "\n<item class_id=\"1\" version=\"1\">\n<objectType>Van</objectType>\n<h>2.0</h>\n"
           "<w>1.8</w>\n<l>4.4</l>\n<first_frame>3</first_frame>\n<poses class_id=\"2\">\n"
           "<count>1</count>\n<item_version>2</item_version>\n<item class_id=\"3\">\n"
           "<tx>15.1</tx>\n<ty>-3.2</ty>\n<tz>-1.7</tz>\n<rx>0</rx>\n<ry>0</ry>\n<rz>-1.57</rz>\n"
           "</item>\n</poses>\n<finished>1</finished>\n</item>\n</tracklets>\n"
           "</boost_serialization>\n";
}

void addKitti(Corpus& corpus)
{
    corpus["kitti_tracklets/one"] = tracklets();
    corpus["kitti_text/times"] = "t2011-09-26 13:02:25.963999987\n2011-09-26 13:02:26.06\n\n";
    corpus["kitti_text/calibration"] =
        "ccalib_time: 15-Mar-2012 11:45:23\nR: 1 0 0 0 1 0 0 0 1\n"
        "T: -0.81 0.32 -8.0e-01\n";
    std::string oxts = "o49.01 8.43 116.4";
    for (int i = 0; i < 27; ++i) oxts += i % 2 == 0 ? " 0.1" : " -3";
    corpus["kitti_text/oxts"] = oxts + "\n";
    const float points[] = {10.0F, 1.0F, -1.0F, 0.3F, 11.0F, 1.0F, -1.0F, 0.0F};
    std::string bytes(1 + sizeof points, 'p');
    std::memcpy(bytes.data() + 1, points, sizeof points);
    corpus["kitti_text/points"] = bytes;
}
}  // namespace

Corpus textCorpus()
{
    std::string truth;
    std::string tracks;
    for (const TruthRow& row : smallStreet("VLP-16", 3, 4.0).truth)
    {
        truth += toCsv(row);
        tracks += toCsv(trackOn(row));
    }
    Corpus corpus = {
        {"truth/street", truthHeader() + truth},
        {"tracks/street", tracksHeader() + tracks},
        {"evaluate/street", truth + "---\n" + tracks},
        {"clusters/street", clusters()},
        {"configuration/all", toIni(Configuration{})},
        {"configuration/some",
         "[scan]\nlabel = velodyne // front\n\n[ins]\nsource = gps"
         "\nmax_gap_s = 1.5e0\n; remark\n[ground]\r\n"},
        {"assignment/some", "clustering.gap_m=0.5\nins.source=auto\nscan.label=a b\n"}};
    addKitti(corpus);
    return corpus;
}

}  // namespace vdamf::fuzz
