// SPDX-License-Identifier: BSD-3-Clause
// The same results, to the bit, with any number of threads.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "tracking/preprocessing/kitti_drive.h"
#include "tracking/tracker/example_frames.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
namespace
{
// The bits of a frame's result, but for padding.
class Bits
{
public:
    explicit Bits(const FrameResult& frame)
    {
        add(frame.time, frame.points, frame.pointsAboveGround, frame.clusters);
        for (const TrackReport& t : frame.tracks)
        {
            add(t.id, t.status, t.z, t.height, t.speed, t.yawRate, t.points, t.match,
                t.nis.value_or(-1.0), t.facesSeen.bits, t.lengthVariance, t.widthVariance);
            addBox(t.box);
            for (const double c : t.covariance.reshaped()) add(c);
            if (t.measuredBox) addBox(*t.measuredBox);
        }
    }

    bool operator==(const Bits& other) const { return bytes_ == other.bytes_; }

private:
    template <class... Values>
    void add(const Values&... values)
    {
        (bytes_.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
    }
    void addBox(const OrientedBox& b) { add(b.x, b.y, b.heading, b.length, b.width); }

    std::string bytes_;
};

std::vector<Bits> tracked(const std::vector<LadarFrame>& frames, int threads)
{
    TrackerOptions options;
    options.execution.threads = threads;
    Tracker tracker(options);
    std::vector<Bits> results;
    for (const LadarFrame& frame : frames) results.emplace_back(tracker.process(frame));
    return results;
}

void expectSameBits(const std::vector<LadarFrame>& frames)
{
    const std::vector<Bits> alone = tracked(frames, 1);
    for (const int threads : {2, 5, 0})
    {
        const std::vector<Bits> together = tracked(frames, threads);
        ASSERT_EQ(alone.size(), together.size());
        for (std::size_t k = 0; k < alone.size(); ++k)
            EXPECT_TRUE(alone[k] == together[k]) << "frame " << k << ", " << threads << " threads";
    }
}

TEST(Threads, DoNotChangeAMadeScene)
{
    std::vector<LadarFrame> frames;
    for (int k = 0; k < 10; ++k)
    {
        std::vector<ExampleBody> bodies;
        for (int n = 0; n < 12; ++n)
        {
            const double speed = n % 3 == 0 ? 0.8 : -0.4;
            bodies.push_back(
                {{-25.0 + 9.0 * (n % 6) + speed * k, n < 6 ? 7.0 : -8.0, 0.0, 4.4, 1.8}, 1.5});
        }
        frames.push_back(exampleFrame(0.1 * k, {0.5 * k, 0.0}, bodies, 70U + unsigned(k)));
    }
    expectSameBits(frames);
}

TEST(Threads, DoNotChangeARecordedScene)
{
    const char* data = std::getenv("VDAMF_DATA_DIR");
    if (data == nullptr) GTEST_SKIP() << "VDAMF_DATA_DIR is not set: no recordings to track";
    const auto drive = std::filesystem::path(data) / "2011_09_26" / "2011_09_26_drive_0005_sync";
    if (!exists(drive)) GTEST_SKIP() << "no " << drive << ": unpack the recording there";
    std::vector<LadarFrame> frames;
    for (int k = 0; k < 8; ++k)
    {
        LadarFrame frame;
        frame.time = 0.1 * k;
        frame.points = test::readScan(drive, k);
        ASSERT_FALSE(frame.points.empty());
        frames.push_back(std::move(frame));
    }
    expectSameBits(frames);
}

}  // namespace
}  // namespace vdamf
