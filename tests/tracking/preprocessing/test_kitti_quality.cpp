// SPDX-License-Identifier: BSD-3-Clause
// How well ground removal and clustering do on real drives with labelled vehicles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <utility>

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
    std::size_t scans = 0, clusters = 0;
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

/// The hits of a scan, and which of them ground removal kept.
struct Result
{
    PointCloud points;
    std::vector<bool> kept;
    std::vector<Cluster> clusters;
};

void addRoad(const Label& label, const Result& result, Quality& q)
{
    const PointCloud& points = result.points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (std::abs(points.z[i] - label.bottom) > 0.15) continue;
        if (!inFootprint(label.box, points.x[i], points.y[i], 3.0)) continue;
        if (inFootprint(label.box, points.x[i], points.y[i], 0.3)) continue;
        ++q.roadHits;
        q.roadRemoved += result.kept[i] ? 0 : 1;
    }
}

void addClusters(const Label& label, const Result& result, std::size_t hits, Quality& q)
{
    std::size_t parts = 0;
    std::size_t clustered = 0;
    std::size_t biggest = 0;
    bool foreign = false;
    for (const Cluster& c : result.clusters)
    {
        std::size_t inside = 0;
        std::size_t outside = 0;
        for (std::size_t i = 0; i < c.size(); ++i)
        {
            inside += onBody(label, c.x[i], c.y[i], c.z[i]) ? 1 : 0;
            outside += inFootprint(label.box, c.x[i], c.y[i], 0.5) ? 0 : 1;
        }
        clustered += inside;
        if (inside * 20 >= hits) ++parts;
        if (inside <= biggest) continue;
        biggest = inside;
        foreign = outside * 10 > c.size();
    }
    q.bodyClustered += clustered;
    q.bodyInBiggest += biggest;
    q.underSegmented += foreign ? 1 : 0;
    q.lost += clustered * 2 < hits ? 1 : 0;
    q.clustersPerLabel.push_back(parts);
}

void addLabel(const Label& label, const Result& result, std::size_t minHits, Quality& q)
{
    const PointCloud& points = result.points;
    std::size_t hits = 0;
    std::size_t hitsKept = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        if (!onBody(label, points.x[i], points.y[i], points.z[i])) continue;
        ++hits;
        hitsKept += result.kept[i] ? 1 : 0;
    }
    addRoad(label, result, q);
    if (hits < minHits) return;
    ++q.labels;
    q.bodyHits += hits;
    q.bodyKept += hitsKept;
    addClusters(label, result, hits, q);
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

/// With a twentieth of the objects' hits mirrored in the road, as wet ground does.
PointCloud withMirrorImages(const PointCloud& points)
{
    constexpr float kRoad = -1.73F;
    PointCloud all = points;
    for (std::size_t i = 0; i < points.size(); i += 20)
    {
        if (points.z[i] < kRoad + 0.3F) continue;
        all.x.push_back(points.x[i]);
        all.y.push_back(points.y[i]);
        all.z.push_back(2.0F * kRoad - points.z[i]);
    }
    return all;
}

struct Variant
{
    const char* drive;
    const char* name;
    PointCloud (*change)(const PointCloud&);  ///< of the scan, or null
    std::size_t minHits;                      ///< on the body of a label that is judged
    double bodyKept, bodyInBiggest, roadRemoved, underSegmented, lost;
};

std::ostream& operator<<(std::ostream& out, const Variant& variant)
{
    return out << variant.name;
}

Result process(PointCloud points)
{
    LadarFrame frame;
    frame.points = std::move(points);
    frame.origin = frame.sensor = {731.0, -2500.0, 114.0};
    const AboveGround above = removeGround(frame, {});
    std::vector<bool> kept(frame.points.size(), false);
    for (const std::uint32_t i : above.index) kept[i] = true;
    std::vector<Cluster> clusters = clusterPoints(frame, above, {});
    return {std::move(frame.points), std::move(kept), std::move(clusters)};
}

Quality measure(const std::filesystem::path& drive, const Variant& variant)
{
    Quality q;
    for (const auto& [scan, labels] : test::readLabels(drive / "tracklet_labels.xml"))
    {
        if (scan % 2 != 0) continue;  // neighbours show the same
        PointCloud points = test::readScan(drive, scan);
        if (points.empty()) continue;
        const Result result = process(variant.change ? variant.change(points) : points);
        ++q.scans;
        q.clusters += result.clusters.size();
        for (const Label& label : labels)
            if (isVehicle(label)) addLabel(label, result, variant.minHits, q);
    }
    return q;
}

void print(const Quality& q)
{
    std::cout << "scans " << q.scans << ", labels " << q.labels << "\n  body hits kept "
              << share(q.bodyKept, q.bodyHits) << ", in a cluster "
              << share(q.bodyClustered, q.bodyHits) << ", in the label's biggest cluster "
              << share(q.bodyInBiggest, q.bodyHits) << "\n  road hits removed "
              << share(q.roadRemoved, q.roadHits) << "\n  clusters a label (median) "
              << q.medianClusters() << ", a scan " << q.clusters / std::max<std::size_t>(q.scans, 1)
              << "\n  labels under-segmented " << share(q.underSegmented, q.labels) << ", lost "
              << share(q.lost, q.labels) << "\n";
}

class KittiQuality : public testing::TestWithParam<Variant>
{
};

TEST_P(KittiQuality, StaysWithinBounds)
{
    const char* data = std::getenv("VDAMF_DATA_DIR");
    if (data == nullptr) GTEST_SKIP() << "VDAMF_DATA_DIR is not set: no recordings to measure on";
    const Variant& bounds = GetParam();
    const auto drive = std::filesystem::path(data) / "2011_09_26" / bounds.drive;
    if (!exists(drive)) GTEST_SKIP() << "no " << drive << ": unpack the recording there";
    const Quality q = measure(drive, bounds);
    print(q);
    EXPECT_GT(q.labels, 50U);
    EXPECT_GT(share(q.bodyKept, q.bodyHits), bounds.bodyKept);
    EXPECT_GT(share(q.bodyInBiggest, q.bodyHits), bounds.bodyInBiggest);
    EXPECT_GT(share(q.roadRemoved, q.roadHits), bounds.roadRemoved);
    EXPECT_EQ(q.medianClusters(), 1U);
    EXPECT_LE(share(q.underSegmented, q.labels), bounds.underSegmented);
    EXPECT_LE(share(q.lost, q.labels), bounds.lost);
}

constexpr const char* kDrive1 = "2011_09_26_drive_0001_sync";
constexpr const char* kDrive5 = "2011_09_26_drive_0005_sync";

INSTANTIATE_TEST_SUITE_P(
    Drives, KittiQuality,
    testing::Values(
        Variant{kDrive1, "drive1", nullptr, 50, 0.98, 0.96, 0.998, 0.02, 0.02},
        Variant{kDrive5, "drive5", nullptr, 50, 0.99, 0.97, 0.998, 0.02, 0.02},
        Variant{kDrive1, "drive1_sparse", everyFourthBeam, 15, 0.94, 0.84, 0.998, 0.02, 0.05},
        Variant{kDrive5, "drive5_sparse", everyFourthBeam, 15, 0.97, 0.88, 0.998, 0.02, 0.08},
        Variant{kDrive1, "drive1_mirrors", withMirrorImages, 50, 0.98, 0.96, 0.997, 0.02, 0.02},
        Variant{kDrive5, "drive5_mirrors", withMirrorImages, 50, 0.99, 0.97, 0.998, 0.02, 0.02}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace vdamf
