// SPDX-License-Identifier: BSD-3-Clause
// The engine of this machine, with workers that end in all ways there are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <map>

#include "files/temporary_folder.h"
#include "vdamf/experiments/engine.h"

namespace vdamf
{
namespace
{
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class LocalEngine : public TemporaryFolder
{
protected:
    LocalEngine()
    {
        make("worker.sh",
             "echo working in $1\n"
             "case $1 in\n"
             "  *crash) kill -SEGV $$ ;;\n"
             "  *refuse) echo no such scan >&2; exit 1 ;;\n"
             "  *nothing) exit 0 ;;\n"
             "  *slow) sleep 100 ;;\n"
             "esac\n"
             "mkdir $1.result\n");
    }

    std::vector<EngineTask> tasks(const std::vector<std::string>& names) const
    {
        std::vector<EngineTask> all;
        for (const std::string& name : names)
        {
            std::filesystem::create_directory(at(name));
            all.push_back({at(name), at(name + ".result")});
        }
        return all;
    }

    Engine engine(unsigned jobs) const
    {
        return localEngine({"/bin/sh", at("worker.sh").string()}, jobs);
    }
};

TEST_F(LocalEngine, OneThatFailsDoesNotStopTheOthers)
{
    const auto all = tasks({"a", "crash", "b", "refuse", "nothing", "c"});
    std::map<std::string, std::string> told;
    const std::atomic<bool> never{false};
    engine(2)(all, never,
              [&](std::size_t i, const std::string& failure)
              { EXPECT_TRUE(told.emplace(all[i].folder.filename(), failure).second); });
    ASSERT_EQ(told.size(), 6U);
    for (const char* good : {"a", "b", "c"}) EXPECT_THAT(told[good], IsEmpty());
    EXPECT_THAT(told["crash"], AllOf(HasSubstr("signal 11"), HasSubstr("crash/log.txt")));
    EXPECT_THAT(told["refuse"], AllOf(HasSubstr("code 1"), HasSubstr("no such scan")));
    EXPECT_THAT(told["nothing"], HasSubstr("ended with code 0"));
    EXPECT_THAT(contentOf("a/log.txt"), HasSubstr("working in"));
}

TEST_F(LocalEngine, StopsSoon)
{
    const auto all = tasks({"a", "slow", "b", "c.slow", "d"});
    std::atomic<bool> stop{false};
    std::size_t told = 0;
    const auto begin = std::chrono::steady_clock::now();
    engine(1)(all, stop,
              [&](std::size_t, const std::string&)
              {
                  ++told;
                  stop = true;
              });
    EXPECT_EQ(told, 1U);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

}  // namespace
}  // namespace vdamf
