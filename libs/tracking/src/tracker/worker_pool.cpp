// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/worker_pool.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <system_error>

namespace vdamf
{
WorkerPool::WorkerPool(int threads)
{
    const std::size_t all = threads > 0
                                ? static_cast<std::size_t>(threads)
                                : std::max<std::size_t>(1, std::thread::hardware_concurrency());
    others_.reserve(all - 1);
    try
    {
        for (std::size_t worker = 1; worker < all; ++worker)
            others_.emplace_back([this, worker] { serve(worker); });
    }
    catch (const std::system_error& error)
    {
        const std::size_t started = size();
        endOthers();
        throw std::runtime_error("the machine starts " + std::to_string(started) + " of " +
                                 std::to_string(all) + " threads: " + error.what());
    }
}

WorkerPool::~WorkerPool()
{
    endOthers();
}

void WorkerPool::endOthers()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        stop_ = true;
    }
    begin_.notify_all();
    for (std::thread& other : others_) other.join();
}

void WorkerPool::forEach(std::size_t count, const Work& work)
{
    // Waking the others takes longer than a few items do.
    constexpr std::size_t kFew = 4;
    if (others_.empty() || count < kFew)
    {
        for (std::size_t item = 0; item < count; ++item) work(item, 0);
        return;
    }
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        work_ = &work;
        count_ = count;
        // Few enough at once that all end at about the same time.
        share_ = std::max<std::size_t>(1, count / (16 * size()));
        next_ = 0;
        failure_ = nullptr;
        busy_ = others_.size();
        ++round_;
    }
    begin_.notify_all();
    takeItems(0);
    std::unique_lock<std::mutex> lock(mutex_);
    end_.wait(lock, [this] { return busy_ == 0; });
    if (failure_) std::rethrow_exception(failure_);
}

void WorkerPool::serve(std::size_t worker)
{
    std::size_t done = 0;
    std::unique_lock<std::mutex> lock(mutex_);
    while (true)
    {
        begin_.wait(lock, [&] { return stop_ || round_ != done; });
        if (stop_) return;
        done = round_;
        lock.unlock();
        takeItems(worker);
        lock.lock();
        if (--busy_ == 0) end_.notify_one();
    }
}

void WorkerPool::takeItems(std::size_t worker)
{
    for (std::size_t first = next_.fetch_add(share_); first < count_;
         first = next_.fetch_add(share_))
    {
        for (std::size_t item = first; item < std::min(first + share_, count_); ++item)
        {
            try
            {
                (*work_)(item, worker);
            }
            catch (...)
            {
                const std::lock_guard<std::mutex> lock(mutex_);
                if (!failure_ || item < failedItem_)
                {
                    failure_ = std::current_exception();
                    failedItem_ = item;
                }
            }
        }
    }
}

}  // namespace vdamf
