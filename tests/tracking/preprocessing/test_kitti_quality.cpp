// SPDX-License-Identifier: BSD-3-Clause
// How well ground removal and clustering do on real drives with labelled vehicles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "tracking/preprocessing/kitti_drive.h"
#include "vdamf/tracking/preprocessing/clustering.h"

namespace vdamf
{
namespace
{
using test::Label;

bool isVehicle(const Label& label)
{
    return label.type == "Car" || label.type == "Van" || label.type == "Truck" ||
           label.type == "Tram";
}

bool inFootprint(const OrientedBox& box, float x, float y, double grown)
{
    const Eigen::Vector2d p = toBoxFrame(box, {x, y});
    return std::abs(p.x()) <= 0.5 * box.length + grown &&
           std::abs(p.y()) <= 0.5 * box.width + grown;
}

double share(std::size_t part, std::size_t whole)
{
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

struct Quality
{
    std::size_t scans = 0, clusters = 0, kept = 0;
    std::size_t labels = 0, underSegmented = 0, lost = 0;
    std::size_t bodyHits = 0, bodyKept = 0, bodyClustered = 0, bodyInBiggest = 0;
    std::size_t roadHits = 0, roadRemoved = 0;
    std::vector<std::size_t> clustersPerLabel;

    std::size_t medianClusters() const
    {
        std::vector<std::size_t> sorted = clustersPerLabel;
        std::sort(sorted.begin(), sorted.end());
        return sorted.empty() ? 0 : sorted[sorted.size() / 2];
    }
};

/// The part of a label's box that ground removal has to leave alone.
bool onBody(const Label& label, float x, float y, float z)
{
    const double height = z - label.bottom;
    return height > 0.25 && height < std::min(label.height, 2.8) &&
           inFootprint(label.box, x, y, 0.0);
}

void addLabel(const Label& label, const PointCloud& points, const std::vector<bool>& kept,
              const std::vector<Cluster>& clusters, Quality& q)
{
    std::size_t hits = 0;
    std::size_t hitsKept = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const float x = points.x[i];
        const float y = points.y[i];
        if (!inFootprint(label.box, x, y, 3.0)) continue;
        if (onBody(label, x, y, points.z[i]))
        {
            ++hits;
            hitsKept += kept[i];
        }
        if (std::abs(points.z[i] - label.bottom) < 0.15 && !inFootprint(label.box, x, y, 0.3))
        {
            ++q.roadHits;
            q.roadRemoved += !kept[i];
        }
    }
    if (hits < (std::getenv("MODE") && strchr(std::getenv("MODE"), 'v') ? 15u : 50u)) return;
    std::size_t parts = 0;
    std::size_t clustered = 0;
    std::size_t biggest = 0;
    std::size_t foreign = 0;
    std::size_t ofBiggest = 0;
    for (const Cluster& c : clusters)
    {
        std::size_t inside = 0;
        std::size_t outside = 0;
        for (std::size_t i = 0; i < c.size(); ++i)
        {
            inside += onBody(label, c.x[i], c.y[i], c.z[i]);
            outside += !inFootprint(label.box, c.x[i], c.y[i], 0.5);
        }
        if (inside == 0) continue;
        clustered += inside;
        if (inside * 20 >= hits) ++parts;
        if (inside <= biggest) continue;
        biggest = inside;
        foreign = outside;
        ofBiggest = c.size();
    }
    ++q.labels;
    q.bodyHits += hits;
    q.bodyKept += hitsKept;
    q.bodyClustered += clustered;
    q.bodyInBiggest += biggest;
    q.underSegmented += foreign * 10 > ofBiggest;
    q.lost += clustered * 2 < hits;
    q.clustersPerLabel.push_back(parts);
    if (std::getenv("VV")) std::cerr << label.type << " " << label.box.x << " " << label.box.y << " hits " << hits << " kept " << hitsKept << " clustered " << clustered << " parts " << parts << " foreign " << foreign << "/" << ofBiggest << "\n";
}

/// A coarser scanner: every fourth elevation of the HDL-64E, as a VLP-16 has them.
PointCloud everyFourthBeam(const PointCloud& points)
{
    PointCloud kept;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double range = std::hypot(points.x[i], points.y[i]);
        const double beam = std::atan2(points.z[i], range) / (0.42 * kPi / 180.0);
        if ((static_cast<int>(std::floor(beam)) & 3) != 0) continue;
        kept.x.push_back(points.x[i]);
        kept.y.push_back(points.y[i]);
        kept.z.push_back(points.z[i]);
    }
    return kept;
}

Quality measure(const std::filesystem::path& drive)
{
    Quality q;
    const char* mode = std::getenv("MODE");
    for (auto [scan, labels] : test::readLabels(drive / "tracklet_labels.xml"))
    {
        LadarFrame frame;
        frame.points = test::readScan(drive, scan);
        if (frame.points.empty()) continue;
        if (mode && strchr(mode, 'v')) frame.points = everyFourthBeam(frame.points);
        const double sl = mode && strchr(mode, 's') ? 0.12 : 0.0;
        if (sl > 0)
            for (size_t i = 0; i < frame.points.size(); ++i)
                frame.points.z[i] += float(sl) * (frame.points.x[i] - 0.4F * frame.points.y[i]);
        if (mode && strchr(mode, 'm'))
            for (size_t i = 0, n = frame.points.size(); i < n; i += 20)
            {
                if (frame.points.z[i] < -1.4F) continue;
                frame.points.x.push_back(frame.points.x[i]);
                frame.points.y.push_back(frame.points.y[i]);
                frame.points.z.push_back(-3.46F - frame.points.z[i]);
            }
        frame.origin = frame.sensor = {731.0, -2500.0, 114.0};
        const AboveGround above = removeGround(frame, {});
        const std::vector<Cluster> clusters = clusterPoints(frame, above, {});
        std::vector<bool> kept(frame.points.size(), false);
        for (const std::uint32_t i : above.index) kept[i] = true;
        ++q.scans;
        q.kept += above.index.size();
        q.clusters += clusters.size();
        for (Label& label : labels)
            label.bottom += sl * (label.box.x - .4 * label.box.y);
        for (const Label& label : labels)
            if (isVehicle(label)) addLabel(label, frame.points, kept, clusters, q);
    }
    std::cout << "labels " << q.labels << ": body hits kept " << share(q.bodyKept, q.bodyHits)
              << ", clustered " << share(q.bodyClustered, q.bodyHits) << ", in the biggest cluster "
              << share(q.bodyInBiggest, q.bodyHits) << "; road hits removed "
              << share(q.roadRemoved, q.roadHits) << "; clusters a label, median "
              << q.medianClusters() << "; labels under-segmented "
              << share(q.underSegmented, q.labels) << ", lost " << share(q.lost, q.labels)
              << "; a scan: hits kept " << q.kept / std::max<std::size_t>(q.scans, 1)
              << ", clusters " << q.clusters / std::max<std::size_t>(q.scans, 1) << "\n";
    return q;
}

class KittiQuality : public testing::TestWithParam<const char*>
{
};

TEST_P(KittiQuality, StaysWithinBounds)
{
    const char* data = std::getenv("VDAMF_DATA_DIR");
    if (data == nullptr) GTEST_SKIP() << "VDAMF_DATA_DIR is not set: no recordings to measure on";
    const auto drive = std::filesystem::path(data) / "2011_09_26" / GetParam();
    if (!exists(drive)) GTEST_SKIP() << "no " << drive << ": unpack the recording there";
    const Quality q = measure(drive);
    EXPECT_GT(q.labels, 50U);
}

INSTANTIATE_TEST_SUITE_P(Drives, KittiQuality,
                         testing::Values("2011_09_26_drive_0001_sync",
                                         "2011_09_26_drive_0005_sync"),
                         [](const auto& drive)
                         { return std::string(drive.param).substr(11, 10); });

}  // namespace
}  // namespace vdamf
