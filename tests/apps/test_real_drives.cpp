// SPDX-License-Identifier: BSD-3-Clause
// Import and track the recorded KITTI drives, and hold the tracks against the labels. Labels are
// good to about 10 cm and cover the camera's view only.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "apps/command_line.h"
#include "files/temporary_folder.h"
#include "vdamf/evaluation/box_overlap.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr int kMinHits = 50;

struct ObjectScore
{
    int boxes = 0;
    int overlapping = 0;  // by more than half
    double iou = 0.0;
    double speed = 0.0;
    double truthSpeed = 0.0;
    double lastTime = 0.0;
    std::map<std::uint64_t, std::pair<double, double>> seenFromTo;  // by identity, s
};

class RealDrive : public TemporaryFolder
{
protected:
    void SetUp() override
    {
        const char* data = std::getenv("VDAMF_DATA_DIR");
        if (data == nullptr) GTEST_SKIP() << "VDAMF_DATA_DIR is not set: no recordings to track";
        data_ = data;
    }

    // Imports and tracks a drive; false where it is absent.
    void run(const std::string& drive)
    {
        const std::string folder = data_ + "/2011_09_26/" + drive;
        if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
        const Outcome imported = runApp(
            "vdamf-import", "kitti-raw '" + folder + "' --gz-level 0 -o " +
                                at("in.rawlog").string() + " --truth " + at("truth.csv").string());
        ASSERT_EQ(imported.exitCode, 0) << imported.output;
        const Outcome tracked = runApp(
            "vdamf-track", "--set output.gz_level=0 -i " + at("in.rawlog").string() + " -o " +
                               at("out.rawlog").string() + " --tracks " + at("t.csv").string());
        ASSERT_EQ(tracked.exitCode, 0) << tracked.output;
        std::printf("%s\n%s", drive.c_str(), tracked.output.c_str());
        EXPECT_THAT(tracked.output, testing::HasSubstr("NIS of updates"));
        score();
    }

    void score()
    {
        std::map<long, std::vector<TrackReport>> frames;
        for (const TrackRow& row : readTracks(at("t.csv")))
            if (row.report.status == TrackStatus::Confirmed ||
                row.report.status == TrackStatus::Coasting)
                frames[std::lround(1e3 * row.time)].push_back(row.report);
        for (const TruthRow& truth : readTruth(at("truth.csv")))
        {
            firstTime_ = firstTime_ == 0.0 ? truth.time : std::min(firstTime_, truth.time);
            ASSERT_TRUE(truth.sensor);
            if (truth.points < kMinHits) continue;
            // Labels are of what the camera ahead saw.
            const Eigen::Vector2d away =
                truth.box.centre() - Eigen::Vector2d(truth.sensor->x, truth.sensor->y);
            EXPECT_LT(away.norm(), 80.0);
            EXPECT_LT(std::abs(wrapAngle(std::atan2(away.y(), away.x()) - truth.sensor->heading)),
                      0.4 * kPi);
            ObjectScore& object = objects_[truth.objectClass + " " + truth.objectId];
            ++object.boxes;
            object.truthSpeed += truth.speed;
            object.lastTime = truth.time;
            const TrackReport* best = nullptr;
            double iou = 0.1;
            for (const TrackReport& track : frames[std::lround(1e3 * truth.time)])
            {
                const double overlap = birdsEyeIou(track.box, truth.box);
                if (overlap > iou) best = &track;
                iou = std::max(iou, overlap);
            }
            if (best == nullptr) continue;
            object.iou += iou;
            object.speed += best->speed;
            if (iou > 0.5) ++object.overlapping;
            auto [entry, isNew] = object.seenFromTo.try_emplace(best->id, truth.time, truth.time);
            entry->second.second = truth.time;
        }
        print();
    }

    void print() const
    {
        std::printf(
            "\n  object          boxes  IoU > 0.5  mean IoU   speed  (label)  identities\n");
        for (const auto& [name, o] : objects_)
            std::printf("  %-14s %6d %9.0f %% %9.2f %7.1f %8.1f %8zu\n", name.c_str(), o.boxes,
                        100.0 * o.overlapping / o.boxes, o.iou / o.boxes, o.speed / o.boxes,
                        o.truthSpeed / o.boxes, o.seenFromTo.size());
    }

    // Share of the boxes of parked cars and vans that a track overlaps by more than half.
    double parkedShare() const
    {
        int boxes = 0;
        int overlapping = 0;
        for (const auto& [name, o] : objects_)
        {
            const bool vehicle = name.rfind("Car", 0) == 0 || name.rfind("Van", 0) == 0;
            if (!vehicle || std::abs(o.truthSpeed / o.boxes) > 0.5) continue;
            boxes += o.boxes;
            overlapping += o.overlapping;
        }
        const double share = static_cast<double>(overlapping) / std::max(1, boxes);
        std::printf("  parked vehicles: %d of %d boxes (%.0f %%) overlap by more than half\n\n",
                    overlapping, boxes, 100.0 * share);
        return share;
    }

    // Original bytes, from the reader, and as stock rawlog-edit keeps them by label.
    void expectOriginalKept() const
    {
        if (runShell("command -v rawlog-edit").exitCode != 0) return;
        const Outcome info = runShell("rawlog-edit --info -i " + at("out.rawlog").string());
        EXPECT_EQ(info.exitCode, 0);
        EXPECT_THAT(info.output, testing::HasSubstr("vdamf_tracks"));
        ASSERT_EQ(runShell("rawlog-edit --keep-label velodyne,ins,gps -i " +
                           at("out.rawlog").string() + " -o " + at("kept.rawlog").string())
                      .exitCode,
                  0);
        RawlogReader kept(at("kept.rawlog"));
        RawlogReader original(at("in.rawlog"));
        while (const auto expected = original.next())
        {
            const auto entry = kept.next();
            ASSERT_TRUE(entry);
            ASSERT_TRUE(entry->bytes == expected->bytes) << "at byte " << expected->offset;
        }
        EXPECT_FALSE(kept.next());
    }

    std::string data_;
    // One identity, the way and the speed of the label.
    void expectRiderTracked(const std::string& name) const
    {
        SCOPED_TRACE(name);
        const ObjectScore& rider = objects_.at(name);
        EXPECT_EQ(rider.seenFromTo.size(), 1U);
        EXPECT_GT(rider.overlapping, 0.75 * rider.boxes);
        EXPECT_NEAR(rider.speed / rider.boxes, rider.truthSpeed / rider.boxes, 0.5);
    }

    std::map<std::string, ObjectScore> objects_;
    double firstTime_ = 0.0;
};

TEST_F(RealDrive, FollowsTheVanOfDrive0005)
{
    run("2011_09_26_drive_0005_sync");
    if (IsSkipped() || HasFatalFailure()) return;
    expectOriginalKept();
    const ObjectScore& van = objects_.at("Van 0");
    ASSERT_EQ(van.seenFromTo.size(), 1U) << "identities of the van ahead";
    EXPECT_LE(van.seenFromTo.begin()->second.first, firstTime_ + 1.0);
    EXPECT_EQ(van.seenFromTo.begin()->second.second, van.lastTime);
    EXPECT_GT(van.iou / van.boxes, 0.8);
    EXPECT_NEAR(van.speed / van.boxes, van.truthSpeed / van.boxes, 0.4);
    EXPECT_GT(parkedShare(), 0.8);
    expectRiderTracked("Cyclist 1");
}

TEST_F(RealDrive, BoxesTheParkedCarsOfDrive0001)
{
    run("2011_09_26_drive_0001_sync");
    if (IsSkipped() || HasFatalFailure()) return;
    expectOriginalKept();
    EXPECT_GT(parkedShare(), 0.75);
    // Far away and from behind: few hits on its side, none of them near its front.
    const ObjectScore& tram = objects_.at("Tram 3");
    EXPECT_GT(tram.boxes, 50);
    EXPECT_EQ(tram.seenFromTo.size(), 1U) << "identities of the tram";
    EXPECT_NEAR(tram.speed / tram.boxes, tram.truthSpeed / tram.boxes, 0.5);
    expectRiderTracked("Cyclist 10");
}

}  // namespace
}  // namespace vdamf
