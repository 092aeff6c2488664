// SPDX-License-Identifier: BSD-3-Clause
// Threads that share the work on independent items.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace vdamf
{
/// Which thread does an item is left to chance: results are the same every time where each item's
/// depends on that item alone.
class WorkerPool
{
public:
    /// `threads` counts the caller's own; 0: as many as the machine has processors. Throws
    /// std::runtime_error with their numbers where it starts fewer.
    explicit WorkerPool(int threads);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    std::size_t size() const { return others_.size() + 1; }

    /// Calls work(item, worker) for each item below `count`, with worker < size() another number in
    /// each thread, and returns when all are done. The first exception, in the order of the items,
    /// is thrown on.
    void forEach(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work);

private:
    using Work = std::function<void(std::size_t, std::size_t)>;
    void endOthers();
    void serve(std::size_t worker);
    void takeItems(std::size_t worker);

    std::vector<std::thread> others_;
    std::mutex mutex_;
    std::condition_variable begin_;
    std::condition_variable end_;
    std::size_t round_ = 0;  // of work; a change tells the others to begin
    std::size_t busy_ = 0;   // of the others
    bool stop_ = false;
    // Of this round:
    const Work* work_ = nullptr;
    std::size_t count_ = 0;
    std::size_t share_ = 1;  // items taken at once
    std::atomic<std::size_t> next_{0};
    std::size_t failedItem_ = 0;
    std::exception_ptr failure_;
};

}  // namespace vdamf
