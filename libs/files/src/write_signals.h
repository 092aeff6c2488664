// SPDX-License-Identifier: BSD-3-Clause
// Writing without being killed by it.
#pragma once

#include <pthread.h>
#include <signal.h>

#include <ctime>

namespace vdamf
{
/// While it lives, a write to a pipe that nobody reads (SIGPIPE) or beyond the allowed size of a
/// file (SIGXFSZ) fails with an error and does not end the program, which then could save nothing.
class WriteSignalsHeld
{
public:
    WriteSignalsHeld()
    {
        sigemptyset(&held_);
        sigaddset(&held_, SIGPIPE);
        sigaddset(&held_, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &held_, &before_);
    }
    ~WriteSignalsHeld()
    {
        // What came meanwhile would be delivered as soon as it is no longer held.
        const timespec now = {};
        while (sigtimedwait(&held_, nullptr, &now) > 0)
        {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    WriteSignalsHeld(const WriteSignalsHeld&) = delete;
    WriteSignalsHeld& operator=(const WriteSignalsHeld&) = delete;

private:
    sigset_t held_ = {};
    sigset_t before_ = {};
};

}  // namespace vdamf
