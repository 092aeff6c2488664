// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/mistakes.h"

#include <gtest/gtest.h>

#include "vdamf/evaluation/evaluation.h"

namespace vdamf
{
namespace
{
/// An object that drives along x, and tracks on it, ten frames a second.
class Scene
{
public:
    void truth(int frame, const std::string& id, double y)
    {
        TruthRow row;
        row.time = timeOf(frame);
        row.objectId = id;
        row.objectClass = "Car";
        row.box = {static_cast<double>(frame), y, 0.0, 4.0, 2.0};
        row.speed = 10.0;
        row.points = 50;
        truth_.push_back(row);
    }
    TrackReport& track(int frame, std::uint64_t id, double y)
    {
        TrackRow row;
        row.time = timeOf(frame);
        row.report.id = id;
        row.report.status = TrackStatus::Confirmed;
        row.report.box = {static_cast<double>(frame), y, 0.0, 4.0, 2.0};
        row.report.speed = 10.0;
        tracks_.push_back(row);
        return tracks_.back().report;
    }
    std::vector<Mistake> mistakes() const
    {
        const Sequence sequence = makeSequence(truth_, tracks_, {});
        return mistakesOf(sequence, matchFrames(sequence, 0.5),
                          poseErrors(sequence, matchFrames(sequence, kPairOverlap)));
    }
    static double timeOf(int frame) { return 100.0 + 0.1 * frame; }

private:
    std::vector<TruthRow> truth_;
    std::vector<TrackRow> tracks_;
};

TEST(Mistakes, AreNoneWhereTracksAreRight)
{
    Scene scene;
    for (int f = 0; f < 20; ++f)
    {
        scene.truth(f, "a", 0.0);
        if (f >= 3) scene.track(f, 1, 0.1);
    }
    EXPECT_TRUE(scene.mistakes().empty()) << "found within half a second";
}

TEST(Mistakes, TellOfWhatIsMissed)
{
    Scene scene;
    for (int f = 0; f < 40; ++f)
    {
        scene.truth(f, "late", 0.0);
        scene.truth(f, "never", 10.0);
        if (f >= 10 && (f < 20 || f >= 30)) scene.track(f, 1, 0.0);
    }
    const std::vector<Mistake> all = scene.mistakes();
    ASSERT_EQ(all.size(), 3U);
    const auto expect =
        [&](const Mistake& m, MistakeKind kind, const char* object, int first, int last)
    {
        EXPECT_EQ(m.kind, kind) << nameOf(m.kind);
        EXPECT_EQ(m.objectId, object);
        EXPECT_DOUBLE_EQ(m.firstTime, Scene::timeOf(first));
        EXPECT_DOUBLE_EQ(m.lastTime, Scene::timeOf(last));
        EXPECT_EQ(m.frames, static_cast<std::size_t>(last - first + 1));
        EXPECT_FALSE(m.track.has_value());
    };
    expect(all[0], MistakeKind::FoundLate, "late", 0, 9);
    expect(all[1], MistakeKind::NeverFound, "never", 0, 39);
    expect(all[2], MistakeKind::Lost, "late", 20, 29);
}

TEST(Mistakes, TellOfIdentitySwitchesAndFalseTracks)
{
    Scene scene;
    for (int f = 0; f < 20; ++f)
    {
        scene.truth(f, "a", 0.0);
        scene.track(f, f < 10 ? 1 : 2, 0.0);
        if (f >= 4) scene.track(f, 5, 30.0);
    }
    const std::vector<Mistake> all = scene.mistakes();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].kind, MistakeKind::FalseTrack);
    EXPECT_EQ(all[0].track, 5U);
    EXPECT_EQ(all[0].frames, 16U);
    EXPECT_EQ(all[1].kind, MistakeKind::IdentitySwitch);
    EXPECT_EQ(all[1].trackBefore, 1U);
    EXPECT_EQ(all[1].track, 2U);
    EXPECT_DOUBLE_EQ(all[1].firstTime, Scene::timeOf(10));
}

TEST(Mistakes, TellOfLargeErrorsWithTheWorstFrame)
{
    Scene scene;
    for (int f = 0; f < 20; ++f)
    {
        scene.truth(f, "a", 0.0);
        TrackReport& track = scene.track(f, 1, 0.0);
        if (f == 8 || f == 9) track.speed = f == 8 ? 13.0 : 14.5;
        if (f == 15) track.box.heading = kPi;
    }
    const std::vector<Mistake> all = scene.mistakes();
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].kind, MistakeKind::Speed);
    EXPECT_NEAR(all[0].worst, 4.5, 1e-9);
    EXPECT_DOUBLE_EQ(all[0].worstTime, Scene::timeOf(9));
    EXPECT_EQ(all[0].frames, 2U);
    EXPECT_EQ(all[1].kind, MistakeKind::Flip);
    EXPECT_EQ(all[2].kind, MistakeKind::Speed) << "forwards became backwards";
    EXPECT_NEAR(all[2].worst, 20.0, 1e-9);
}

TEST(Mistakes, TellOfABoxThatOverlapsTooLittleOnce)
{
    Scene scene;
    for (int f = 0; f < 20; ++f)
    {
        scene.truth(f, "a", 0.0);
        scene.track(f, 1, f < 10 ? 0.0 : 1.2);
    }
    const std::vector<Mistake> all = scene.mistakes();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].kind, MistakeKind::BoxOff);
    EXPECT_EQ(all[0].track, 1U);
    EXPECT_NEAR(all[0].worst, 0.8 / 3.2, 1e-6);
    EXPECT_EQ(all[1].kind, MistakeKind::Position);
    EXPECT_NEAR(all[1].worst, 1.2, 1e-9);
}

TEST(Mistakes, ShortBreaksDoNotEndAnEpisode)
{
    Scene scene;
    for (int f = 0; f < 30; ++f)
    {
        scene.truth(f, "a", 0.0);
        const bool isMissed = f >= 10 && f < 20 && f != 14;
        if (!isMissed) scene.track(f, 1, 0.0);
    }
    const std::vector<Mistake> all = scene.mistakes();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].frames, 9U);
    EXPECT_DOUBLE_EQ(all[0].lastTime, Scene::timeOf(19));
}

}  // namespace
}  // namespace vdamf
