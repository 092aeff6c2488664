// SPDX-License-Identifier: BSD-3-Clause
// vdamf-sweep on a real Slurm of one machine, started in the test's own folder. Needs root and
// Debian's slurm-wlm and munge.
#include <gmock/gmock.h>
#include <unistd.h>

#include "apps/sweep_fixture.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using ::testing::StartsWith;
namespace fs = std::filesystem;

constexpr const char* kSlurm = "[slurm]\ntime_min = 5\nmemory_mb = 500\npoll_s = 0.2\n";

class SweepOnSlurm : public SweepProgram
{
protected:
    void SetUp() override
    {
        if (runShell("command -v sbatch slurmctld slurmd munged").exitCode != 0)
            GTEST_SKIP() << "there is no Slurm here: apt-get install slurm-wlm munge";
        if (::geteuid() != 0) GTEST_SKIP() << "the test's own Slurm needs root";
        isStarted_ = true;
        const Outcome outcome = cluster("start");
        ASSERT_EQ(outcome.exitCode, 0) << outcome.output;
        ::setenv("SLURM_CONF", at("cluster/slurm.conf").c_str(), 1);
    }
    void TearDown() override
    {
        if (!isStarted_) return;
        runShell("scancel -u root");
        cluster("stop");
    }

    Outcome cluster(const std::string& action) const
    {
        return runShell("'" VDAMF_SOURCE_DIR "/tests/experiments/slurm/cluster.sh' " + action +
                        " '" + at("cluster").string() + "'");
    }

    static std::string queue() { return runShell("squeue -h -r -o '%F_%K %T'").output; }

    static std::string firstJob()
    {
        const std::string job = runShell("squeue -h -o '%F' | head -n 1").output;
        return job.substr(0, job.find('\n'));
    }

    // The first task that runs: "<array job>_<index>".
    static std::string runningTask()
    {
        std::string task;
        waitFor(
            [&]
            {
                task = runShell("squeue -h -r -t running -o '%F_%K' | head -n 1").output;
                return !task.empty();
            });
        return task.substr(0, task.find('\n'));
    }

private:
    bool isStarted_ = false;
};

class SweepWithoutSlurm : public SweepProgram
{
};

TEST_F(SweepWithoutSlurm, SaysAtOnceThatTheControllerDoesNotAnswer)
{
    make("bin/squeue", "#!/bin/sh\necho 'Unable to contact slurm controller'\nexit 1\n");
    fs::permissions(at("bin/squeue"), fs::perms::owner_all);
    writeSweep("", "measurement.sigma_m = 0.1, 0.2", "[slurm]\npoll_s = 0.05\npatience_s = 0.5\n");
    const Outcome outcome =
        runShell("PATH='" + at("bin").string() + "':$PATH '" VDAMF_APPS_DIR "/vdamf-sweep' " +
                 arguments("out") + " --engine slurm");
    EXPECT_EQ(outcome.exitCode, 1);
    const std::string said =
        "Slurm's controller does not answer (Unable to contact slurm controller); it is asked "
        "again for 0.5 s (slurm.patience_s)\n";
    EXPECT_THAT(outcome.output, StartsWith(said + "vdamf-sweep: "));
    EXPECT_THAT(outcome.output,
                HasSubstr("for 0.5 s: Unable to contact slurm controller; no job was submitted"));
}

TEST_F(SweepOnSlurm, GivesTheTableOfTheLocalEngine)
{
    writeSweep("", "measurement.sigma_m = 0.1 : 0.1 : 0.4",
               std::string(kSlurm) + "partition = test\nat_once = 1\narray_size = 3\n");
    ASSERT_EQ(sweep("local").exitCode, 0);
    const Outcome outcome = sweep("slurm", "--engine slurm");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output << contentOf("slurm/slurm/messages.txt");
    EXPECT_EQ(contentOf("slurm/table.csv"), contentOf("local/table.csv"));
    EXPECT_EQ(runsIn("slurm"), 4U);
    EXPECT_TRUE(fs::is_empty(at("slurm/tasks")));
}

TEST_F(SweepOnSlurm, KilledTasksAreSubmittedAgain)
{
    writeSweep("", "measurement.sigma_m = 0.10 : 0.05 : 0.35",
               std::string(kSlurm) + "extra = --begin=now+2\n");
    const pid_t process = start("slurm", "--engine slurm");
    ASSERT_TRUE(waitFor([] { return queue().find("PENDING") != std::string::npos; }));
    EXPECT_EQ(runShell("scancel " + firstJob() + "_1").exitCode, 0);
    // Running ones, if they still do by then: one is cancelled, the worker of another dies.
    runShell("scancel " + runningTask());
    runShell("kill -9 $(pgrep -f '" + at("slurm").string() + "/tasks' | head -n 1)");
    EXPECT_EQ(waitForExit(process), 0) << contentOf("out.txt");
    EXPECT_EQ(runsIn("slurm"), 6U);
    EXPECT_TRUE(fs::exists(at("slurm/slurm/list-2.txt"))) << "nothing was submitted again";
}

TEST_F(SweepOnSlurm, GivesUpATaskThatIsKilledTooOften)
{
    writeSweep("", "measurement.sigma_m = 0.1, 0.2",
               std::string(kSlurm) + "retries = 0\nextra = --begin=now+2\n");
    const pid_t process = start("slurm", "--engine slurm");
    ASSERT_TRUE(waitFor([] { return queue().find("PENDING") != std::string::npos; }));
    runShell("scancel " + firstJob() + "_1");
    EXPECT_EQ(waitForExit(process), 1);
    EXPECT_THAT(contentOf("out.txt"), HasSubstr("setting 2 failed: job "));
    EXPECT_THAT(contentOf("out.txt"), HasSubstr("ended without a result, attempt 1 of 1"));
    EXPECT_EQ(runsIn("slurm"), 1U);
}

TEST_F(SweepOnSlurm, LivesThroughARestartOfTheController)
{
    writeSweep("", "measurement.sigma_m = 0.10 : 0.05 : 0.35", kSlurm);
    const pid_t process = start("slurm", "--engine slurm");
    ASSERT_FALSE(runningTask().empty());
    cluster("stop-controller");
    EXPECT_NE(runShell("squeue").exitCode, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    const Outcome back = cluster("start-controller");
    EXPECT_EQ(back.exitCode, 0) << back.output;
    EXPECT_EQ(waitForExit(process), 0) << contentOf("out.txt");
    EXPECT_EQ(runsIn("slurm"), 6U);
}

TEST_F(SweepOnSlurm, KilledItFindsItsJobsAgain)
{
    writeSweep("", "measurement.sigma_m = 0.10 : 0.05 : 0.45", kSlurm);
    const pid_t process = start("slurm", "--engine slurm");
    ASSERT_FALSE(runningTask().empty());
    ::kill(process, SIGKILL);
    waitForExit(process);
    const Outcome again = sweep("slurm", "--engine slurm");
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_EQ(runsIn("slurm"), 8U);
    // All in the first array: nothing was submitted twice.
    EXPECT_FALSE(fs::exists(at("slurm/slurm/list-2.txt")));
}

TEST_F(SweepOnSlurm, StoppedItCancelsItsJobs)
{
    writeSweep("", "measurement.sigma_m = 0.10 : 0.01 : 0.45", kSlurm);
    const pid_t process = start("slurm", "--engine slurm");
    ASSERT_FALSE(runningTask().empty());
    ::kill(process, SIGTERM);
    EXPECT_EQ(waitForExit(process), 1);
    EXPECT_TRUE(waitFor([] { return queue().empty(); })) << queue();
}

TEST_F(SweepOnSlurm, JobsThatTheClusterRefuses)
{
    writeSweep("", "measurement.sigma_m = 0.1, 0.2", std::string(kSlurm) + "partition = no_such\n");
    const Outcome outcome = sweep("slurm", "--engine slurm");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.output, HasSubstr("sbatch: "));
    EXPECT_THAT(outcome.output, HasSubstr("invalid partition"));
}

}  // namespace
}  // namespace vdamf
