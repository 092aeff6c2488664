// SPDX-License-Identifier: BSD-3-Clause
#include "endurance/endurance.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "endurance/monitor.h"
#include "endurance/rounds.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf::endurance
{
namespace
{
/// A pipe that a thread fills with rounds.
class Feed
{
public:
    Feed(Rounds& rounds, std::uint64_t count)
    {
        if (::pipe2(ends_, O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
        writer_ = std::thread(
            [this, &rounds, count]
            {
                // When the run fails nobody reads any more: that must not end the program.
                sigset_t closed;
                sigemptyset(&closed);
                sigaddset(&closed, SIGPIPE);
                pthread_sigmask(SIG_BLOCK, &closed, nullptr);
                for (std::uint64_t i = 0; i < count; ++i) write(rounds.next());
                ::close(ends_[1]);
            });
    }
    ~Feed()
    {
        ::close(ends_[0]);
        writer_.join();
    }
    Feed(const Feed&) = delete;
    Feed& operator=(const Feed&) = delete;

    std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(ends_[0]); }

private:
    void write(std::string_view bytes) const
    {
        while (!bytes.empty())
        {
            const ssize_t count = ::write(ends_[1], bytes.data(), bytes.size());
            if (count <= 0) return;
            bytes.remove_prefix(static_cast<std::size_t>(count));
        }
    }

    int ends_[2] = {-1, -1};
    std::thread writer_;
};
}  // namespace

Result run(const Plan& plan, const std::function<void(const Row&)>& onRow)
{
    Rounds rounds(plan.rawlog, plan.pause, plan.drift);
    Monitor monitor(plan, rounds, onRow);
    const auto count =
        static_cast<std::uint64_t>(std::ceil(plan.hours * 3600.0 / rounds.period())) + 1;
    const Feed feed(rounds, count);
    TrackRawlogJob job;
    job.input = feed.path();
    job.output = "/dev/null";
    job.configuration = plan.configuration;
    const std::atomic<bool> stop{false};
    trackRawlog(job, stop,
                [&](const LadarFrame&, const FrameResult& frame, double) { monitor.add(frame); });
    return monitor.result();
}

}  // namespace vdamf::endurance
