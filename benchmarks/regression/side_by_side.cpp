// SPDX-License-Identifier: BSD-3-Clause
#include "regression/side_by_side.h"

#include <atomic>
#include <thread>
#include <vector>

namespace vdamf
{
void sideBySide(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work)
{
    std::atomic<std::size_t> next{0};
    const auto some = [&]
    {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    std::vector<std::thread> others;
    for (unsigned k = 1; k < jobs; ++k) others.emplace_back(some);
    some();
    for (std::thread& thread : others) thread.join();
}

}  // namespace vdamf
