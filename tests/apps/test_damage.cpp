// SPDX-License-Identifier: BSD-3-Clause
// Damaged files through the command line: no program crashes, hangs or eats the memory, and what it
// writes can be read. VDAMF_DAMAGE_RUNS=N runs N files through each instead of a few.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "apps/faults_fixture.h"
#include "apps/mutations.h"
#include "vdamf/files/csv.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

int runs(int fallback)
{
    const char* text = std::getenv("VDAMF_DAMAGE_RUNS");
    return text != nullptr ? std::atoi(text) : fallback;
}

class Damage : public Faults
{
protected:
    /// The program's exit code; its end and resources are checked.
    int run(const std::string& app, const std::vector<std::string>& arguments) const
    {
        ProcessOptions options;
        options.errors = path("errors");
        const ProcessEnd end = runLimited(app, arguments, options);
        EXPECT_EQ(end.signal, 0) << contentOf("errors");
        EXPECT_TRUE(end.exitCode >= 0 && end.exitCode <= 2) << end.exitCode;
        EXPECT_LT(end.seconds, kLongest * kMoreTime);
        EXPECT_LT(end.megabytes, kLargest * kMoreMemory);
        EXPECT_TRUE(end.exitCode == 0 || !contentOf("errors").empty()) << "fails without a word";
        return end.exitCode;
    }

    std::string file(const std::string& name) const
    {
        std::ifstream stream(fs::path(VDAMF_SOURCE_DIR) / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    /// Every scan class and INS source, then a short drive.
    std::string everyClass() const
    {
        std::string bytes;
        for (const char* name : {"others", "gps", "range_camera", "rotating_scan", "sensory_frame",
                                 "VLP-16", "HDL-32E", "HDL-64E"})
            bytes += file(std::string("fuzz/corpus/rawlog/") + name);
        return bytes + file("fuzz/corpus/track/clouds");
    }

    void checkTracked() const
    {
        if (fs::exists(at("t.csv"))) readTracks(at("t.csv"));
        if (!fs::exists(at("a.rawlog"))) return;
        const Contents log(at("a.rawlog"));
        EXPECT_FALSE(log.truncated);
        EXPECT_EQ(brokenEntries(log), 0U);
    }

    /// Kept for whoever mends what a check found.
    void keepIfFailed(const std::string& name, int i) const
    {
        if (!HasFailure()) return;
        const fs::path kept = fs::temp_directory_path() / ("vdamf_" + name + std::to_string(i));
        fs::copy_file(at(name), kept, fs::copy_options::overwrite_existing);
        ADD_FAILURE() << "file " << i << ", kept as " << kept;
    }
};

TEST_F(Damage, OfRawlogs)
{
    const std::string bases[] = {plainStreet(400 << 10), everyClass(),
                                 street().substr(0, 200 << 10)};
    Mutations mutations(6);
    for (int i = 0; i < runs(24) && !HasFailure(); ++i)
    {
        make("in.rawlog", mutations.of(bases[static_cast<std::size_t>(i) % 3]));
        std::vector<std::string> arguments = job(path("in.rawlog"));
        arguments.push_back("--overwrite");
        run("vdamf-track", arguments);
        EXPECT_NO_THROW(checkTracked());
        keepIfFailed("in.rawlog", i);
        for (const char* name : {"a.rawlog", "t.csv"}) fs::remove(at(name));
    }
}

TEST_F(Damage, OfTables)
{
    ASSERT_EQ(track("-q --frames 0:12 -i " + kStreet + " --tracks " + path("good.csv")).exitCode,
              0);
    const std::string tracks = contentOf("good.csv");
    const std::string truth = file("datasets/street/truth.csv").substr(0, 30000);
    const std::string whole = truth.substr(0, truth.rfind('\n') + 1);
    Mutations mutations(7);
    int scored = 0;
    for (int i = 0; i < runs(30) && !HasFailure(); ++i)
    {
        make("tracks.csv", i % 2 == 0 ? mutations.ofText(tracks) : tracks);
        make("truth.csv", i % 2 == 1 ? mutations.ofText(whole) : whole);
        const int code = run("vdamf-evaluate", {"--tracks", path("tracks.csv"), "--truth",
                                                path("truth.csv"), "--json", path("m.json")});
        EXPECT_EQ(code == 0, fs::exists(at("m.json")));
        if (code == 0)
        {
            EXPECT_NO_THROW(nlohmann::json::parse(contentOf("m.json")));
            ++scored;
        }
        keepIfFailed(i % 2 == 0 ? "tracks.csv" : "truth.csv", i);
        fs::remove(at("m.json"));
    }
    EXPECT_GT(scored, 0);
}

TEST_F(Damage, OfClustersAndConfigurations)
{
    const std::string clusters = file("fuzz/corpus/clusters/street");
    const std::string ini = file("config.ini");
    Mutations mutations(8);
    int fitted = 0;
    for (int i = 0; i < runs(30) && !HasFailure(); ++i)
    {
        make("c.csv", i % 2 == 0 ? mutations.ofText(clusters) : clusters);
        make("c.ini", i % 2 == 1 ? mutations.ofText(ini) : ini);
        const int code = run("vdamf-fit", {"-i", path("c.csv"), "-o", path("f.csv"), "-c",
                                           path("c.ini"), "--overwrite"});
        EXPECT_EQ(code == 0, fs::exists(at("f.csv")));
        if (code == 0)
        {
            CsvReader table(at("f.csv"), {"cluster", "points", "converged"});
            while (table.next()) table.integer("points");
            ++fitted;
        }
        keepIfFailed(i % 2 == 0 ? "c.csv" : "c.ini", i);
        fs::remove(at("f.csv"));
    }
    EXPECT_GT(fitted, 0);
}

}  // namespace
}  // namespace vdamf
