// SPDX-License-Identifier: BSD-3-Clause
// What a killed run leaves behind reads up to its last finished frame; files of impossible size end
// soon.
#include <random>

#include "apps/faults_fixture.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

constexpr off_t kSparse = 100LL << 30U;  // bytes

TEST_F(Faults, AKilledRunIsReadableUpToItsLastFrame)
{
    std::mt19937 random(20261121);
    const bool stock = runShell("command -v rawlog-edit").exitCode == 0;
    std::size_t most = 0;
    for (int i = 0; i < 6; ++i)
    {
        fs::remove(at("a.rawlog.partial"));
        fs::remove(at("t.csv.partial"));
        LimitedProcess process("vdamf-track", job(kStreet));
        ASSERT_TRUE(grows("t.csv.partial", random() % (200 << 10)));
        process.send(SIGKILL);
        if (process.wait().signal != SIGKILL) break;  // it was faster
        if (fs::file_size(at("a.rawlog.partial")) == 0) continue;
        const Contents log(at("a.rawlog.partial"));
        EXPECT_EQ(brokenEntries(log), 0U);
        const std::size_t frames = annotatedScans(log);
        most = std::max(most, frames);
        // A second is 10 frames; what two threads compress and what is not yet ended is lost.
        EXPECT_LE(framesIn("t.csv.partial"), frames + 50);
        if (!stock) continue;
        const Outcome info = runShell("rawlog-edit --info -i " + path("a.rawlog.partial"));
        EXPECT_THAT(info.output, testing::HasSubstr("vdamf_tracks"));
    }
    EXPECT_GT(most, 5U);
}

TEST_F(Faults, AKilledRunCanBeTrackedFurther)
{
    LimitedProcess process("vdamf-track", job(kStreet));
    ASSERT_TRUE(grows("a.rawlog.partial", 500 << 10));
    process.send(SIGKILL);
    process.wait();
    const std::size_t frames = annotatedScans(Contents(at("a.rawlog.partial")));
    const Outcome again = track(in("a.rawlog.partial") + out("b.rawlog"));
    EXPECT_NE(again.exitCode, 2);
    EXPECT_GE(annotatedScans(Contents(at("b.rawlog"))), frames);
}

class SparseFiles : public Faults
{
protected:
    void makeSparse(const std::string& name, const std::string& begin) const
    {
        make(name, begin);
        if (::truncate(at(name).c_str(), kSparse) != 0)
            GTEST_SKIP() << "no sparse file of 100 GB can be made here";
    }

    void endsSoon(const std::string& app, const std::vector<std::string>& arguments, int exitCode)
    {
        ProcessOptions options;
        options.errors = path("errors");
        const ProcessEnd end = runLimited(app, arguments, options);
        EXPECT_EQ(end.exitCode, exitCode) << app << ' ' << contentOf("errors");
        EXPECT_LT(end.seconds, kLongest * kMoreTime) << app;
        EXPECT_LT(end.megabytes, kLargest * kMoreMemory) << app;
    }
};

TEST_F(SparseFiles, OfZerosAreRefused)
{
    makeSparse("huge", "");
    endsSoon("vdamf-track", job(path("huge")), 1);
    endsSoon("vdamf-track", {"-i", kStreet, "-c", path("huge"), "--tracks", path("t.csv")}, 2);
    endsSoon("vdamf-fit", {"-i", path("huge"), "-o", path("f.csv")}, 1);
    endsSoon("vdamf-evaluate", {"--tracks", path("huge"), "--truth", path("huge")}, 1);
}

TEST_F(SparseFiles, AreReadAsFarAsTheyHoldScans)
{
    makeSparse("huge", plainStreet(1 << 20));
    endsSoon("vdamf-track", job(path("huge")), 1);
    EXPECT_THAT(contentOf("errors"), testing::HasSubstr("no object in 1 GB"));
    EXPECT_GT(annotatedScans(Contents(at("a.rawlog"))), 2U);
}

TEST_F(SparseFiles, MayHoldAnObjectOfAnySize)
{
    // A cloud that claims to have 2^26 points: its coordinates are all zeros.
    std::string cloud = plainStreet(1 << 20);
    const std::string name = "mrpt::obs::CObservationPointCloud";
    cloud += static_cast<char>(0x80 | name.size()) + name + std::string(1, '\0');
    cloud += std::string(8 + 4, '\0');  // time stamp and an empty label
    const std::string map = "mrpt::maps::CSimplePointsMap";
    cloud += static_cast<char>(0x80 | map.size()) + map + '\x0a';
    cloud += std::string("\x00\x00\x00\x04", 4);
    makeSparse("huge", cloud);
    endsSoon("vdamf-track", job(path("huge")), 1);
}

}  // namespace
}  // namespace vdamf
