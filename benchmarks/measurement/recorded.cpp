// SPDX-License-Identifier: BSD-3-Clause
#include "measurement/recorded.h"

#include <algorithm>
#include <stdexcept>

#include "vdamf/learning/clusters/label_hits.h"
#include "vdamf/rawlog/kitti_drive.h"
#include "vdamf/rawlog/kitti_tracklets.h"
#include "vdamf/tracking/preprocessing/clustering.h"
#include "vdamf/tracking/preprocessing/ground.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

constexpr std::size_t kLeastHits = 10;  // as in the tracker
constexpr double kRangeNoise = 0.02;    // m, of the HDL-64E
// Of labels drawn by hand every few frames.
constexpr double kLabelPlace = 0.06;                 // m
constexpr double kLabelHeading = 1.0 * kPi / 180.0;  // rad

// Both samples of one label; their clusters may be too small.
struct LabelSamples
{
    LabelledCluster label;
    LabelledCluster cluster;
};

std::vector<OrientedBox> vehiclesAt(const std::vector<KittiTracklet>& tracklets, std::size_t frame)
{
    std::vector<OrientedBox> boxes;
    for (const KittiTracklet& tracklet : tracklets)
    {
        const std::string& kind = tracklet.objectClass;
        if (kind != "Car" && kind != "Van" && kind != "Truck") continue;
        if (frame < tracklet.firstFrame) continue;
        const std::size_t k = frame - tracklet.firstFrame;
        if (k >= tracklet.poses.size()) continue;
        const KittiTrackletPose& pose = tracklet.poses[k];
        boxes.push_back({pose.x, pose.y, pose.heading, tracklet.length, tracklet.width});
    }
    return boxes;
}

std::vector<LabelSamples> samplesOf(const fs::path& folder)
{
    const KittiDrive drive = readKittiDrive(folder);
    const std::vector<KittiTracklet> tracklets =
        readKittiTracklets(folder / "tracklet_labels.xml", drive.scans.size());
    std::vector<LabelSamples> all;
    for (std::size_t k = 0; k < drive.scans.size(); ++k)
    {
        const std::vector<OrientedBox> boxes = vehiclesAt(tracklets, k);
        if (boxes.empty()) continue;
        // The velodyne's own frame: level enough, and the labels are in it.
        LadarFrame frame;
        frame.points = readKittiScan(drive.scans[k].path);
        const AboveGround above = removeGround(frame, GroundOptions{});
        const std::vector<Cluster> clusters = clusterPoints(frame, above, ClusterOptions{});
        for (const OrientedBox& box : boxes)
        {
            LabelSamples both;
            both.label.truth = both.cluster.truth = box;
            both.label.cluster = hitsInLabel(frame, above, box);
            both.cluster.cluster = clusterOnLabel(clusters, box);
            all.push_back(std::move(both));
        }
    }
    return all;
}

void complete(LabelledClusters& condition, int count, std::uint64_t seed)
{
    std::vector<LabelledCluster>& samples = condition.samples;
    const std::size_t all = samples.size();
    const std::size_t wanted = std::min(all, static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < wanted; ++k) samples[k] = samples[k * all / wanted];
    samples.resize(wanted);
    for (std::size_t k = 0; k < wanted; ++k)
    {
        LabelledCluster& sample = samples[k];
        sample.rangeNoise = kRangeNoise;
        sample.truthPlace = kLabelPlace;
        sample.truthHeading = kLabelHeading;
        sample.start = perturbed(sample.truth, seed, k);
        sample.inView = facesInView(sample.cluster, sample.truth, sample.sensor);
    }
}
}  // namespace

std::vector<LabelledClusters> recordedConditions(const fs::path& folder, int count,
                                                 std::uint64_t seed)
{
    std::vector<fs::path> drives;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().filename() == "tracklet_labels.xml")
            drives.push_back(entry.path().parent_path());
    if (drives.empty())
    {
        throw std::runtime_error(folder.string() +
                                 ": no drive with tracklet_labels.xml in it; unpack KITTI raw "
                                 "drives with their tracklets there");
    }
    std::sort(drives.begin(), drives.end());
    std::vector<LabelledClusters> both = {
        {"drive_label", "real drives, hits in the label's box grown by 0.3 m", {}},
        {"drive_cluster", "real drives, whole cluster of the preprocessing", {}}};
    for (const fs::path& drive : drives)
    {
        for (LabelSamples& one : samplesOf(drive))
        {
            if (one.label.cluster.size() >= kLeastHits) both[0].samples.push_back(one.label);
            if (one.cluster.cluster.size() >= kLeastHits) both[1].samples.push_back(one.cluster);
        }
    }
    for (LabelledClusters& condition : both) complete(condition, count, seed);
    return both;
}

}  // namespace vdamf
