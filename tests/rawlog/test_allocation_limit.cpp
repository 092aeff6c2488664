// SPDX-License-Identifier: BSD-3-Clause
// This program links the guard, as the programs of the project do.
#include "vdamf/rawlog/allocation_limit.h"

#include <gtest/gtest.h>
#include <mrpt/math/CMatrixDynamic.h>

#include <limits>
#include <thread>
#include <vector>

namespace vdamf
{
namespace
{
constexpr std::size_t kMegabyte = 1 << 20;

void allocate(std::size_t bytes)
{
    std::vector<char>(bytes).at(0) = 1;
}

TEST(AllocationLimit, RefusesWhatIsLarger)
{
    allocate(2 * kMegabyte);
    {
        const AllocationLimit limit(kMegabyte);
        allocate(kMegabyte);
        EXPECT_THROW(allocate(kMegabyte + 1), std::bad_alloc);
    }
    allocate(2 * kMegabyte);
}

TEST(AllocationLimit, RefusesWhatIsTooMuchInAll)
{
    const AllocationLimit limit(kMegabyte, 3 * kMegabyte);
    allocate(kMegabyte);
    {
        const AllocationLimit inner(AllocationLimit::kNone);
        allocate(9 * kMegabyte);
    }
    allocate(kMegabyte);
    EXPECT_THROW(
        {
            for (int i = 0; i < 100; ++i) allocate(kMegabyte / 50);
        },
        std::bad_alloc);
}

TEST(AllocationLimit, Nests)
{
    const AllocationLimit outer(kMegabyte);
    {
        const AllocationLimit inner(std::numeric_limits<std::size_t>::max());
        allocate(2 * kMegabyte);
    }
    EXPECT_EQ(kMegabyte, AllocationLimit::current());
    EXPECT_THROW(allocate(2 * kMegabyte), std::bad_alloc);
}

TEST(AllocationLimit, HoldsForMatricesOfMrpt)
{
    // They allocate by aligned_malloc(), which knows no exceptions.
    const AllocationLimit limit(kMegabyte);
    mrpt::math::CMatrixDynamic<float> matrix(100, 100);
    EXPECT_THROW(matrix.resize(1000, 1000), std::bad_alloc);
}

TEST(AllocationLimit, IsOfOneThread)
{
    const AllocationLimit limit(kMegabyte);
    bool allocated = false;
    std::thread(
        [&allocated]
        {
            allocate(2 * kMegabyte);
            allocated = true;
        })
        .join();
    EXPECT_TRUE(allocated);
}

}  // namespace
}  // namespace vdamf
