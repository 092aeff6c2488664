// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/worker_pool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

namespace vdamf
{
namespace
{
TEST(WorkerPool, DoesEveryItemOnce)
{
    for (const int threads : {1, 2, 5})
    {
        WorkerPool pool(threads);
        ASSERT_EQ(pool.size(), static_cast<std::size_t>(threads));
        for (const std::size_t count : {0U, 1U, 3U, 4U, 100U, 1000U})
        {
            std::vector<int> done(count, 0);
            std::vector<std::size_t> worker(count, 0);
            pool.forEach(count,
                         [&](std::size_t item, std::size_t by)
                         {
                             ++done[item];
                             worker[item] = by;
                         });
            for (std::size_t item = 0; item < count; ++item)
            {
                EXPECT_EQ(done[item], 1) << item << " of " << count;
                EXPECT_LT(worker[item], pool.size());
            }
        }
    }
}

TEST(WorkerPool, WorkersHaveNumbersOfTheirOwn)
{
    WorkerPool pool(4);
    std::vector<std::vector<std::thread::id>> threads(pool.size());
    pool.forEach(400, [&](std::size_t, std::size_t by)
                 { threads[by].push_back(std::this_thread::get_id()); });
    for (const auto& ids : threads)
        for (const std::thread::id& id : ids) EXPECT_EQ(id, ids.front());
}

#ifndef __SANITIZE_ADDRESS__
// In a process of its own whose memory has room for a few stacks.
TEST(WorkerPool, TellsOfThreadsThatDoNotStart)
{
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    const auto start = []
    {
        const rlimit little{std::size_t{1} << 30U, std::size_t{1} << 30U};
        setrlimit(RLIMIT_AS, &little);
        try
        {
            const WorkerPool pool(4096);
        }
        catch (const std::runtime_error& error)
        {
            std::fprintf(stderr, "%s\n", error.what());
            std::_Exit(3);
        }
    };
    EXPECT_EXIT(start(), testing::ExitedWithCode(3), "of 4096 threads");
}
#endif

TEST(WorkerPool, ThrowsOnTheFirstItemsException)
{
    WorkerPool pool(3);
    for (int round = 0; round < 20; ++round)
    {
        try
        {
            pool.forEach(200,
                         [](std::size_t item, std::size_t)
                         {
                             if (item % 50 == 49) throw std::runtime_error(std::to_string(item));
                         });
            FAIL() << "nothing thrown";
        }
        catch (const std::runtime_error& error)
        {
            EXPECT_STREQ(error.what(), "49");
        }
    }
    std::size_t sum = 0;
    pool.forEach(3, [&](std::size_t item, std::size_t) { sum += item; });
    EXPECT_EQ(sum, 3U);
}

TEST(WorkerPool, ZeroMeansAllProcessors)
{
    EXPECT_GE(WorkerPool(0).size(), 1U);
    EXPECT_EQ(WorkerPool(0).size(), std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace
}  // namespace vdamf
