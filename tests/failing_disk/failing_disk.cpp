// SPDX-License-Identifier: BSD-3-Clause
// A disk that fails: loaded before a program (LD_PRELOAD), it makes one of its calls on one file
// return EIO. VDAMF_FAILING = "CALL:BYTES:END", where CALL is read, write, fsync or close, END the
// end of the file's name, and BYTES how many a read or a write may move before.
#include <dlfcn.h>
#include <limits.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <string>

namespace
{
struct Plan
{
    std::string call;
    std::size_t bytes = 0;
    std::string end;
};

Plan planOf(const char* text)
{
    if (text == nullptr) return {};
    const std::string all = text;
    const std::size_t first = all.find(':');
    const std::size_t second = all.find(':', first + 1);
    return {all.substr(0, first), std::stoul(all.substr(first + 1)), all.substr(second + 1)};
}

bool concerns(const char* call, int descriptor)
{
    static const Plan plan = planOf(std::getenv("VDAMF_FAILING"));
    if (plan.call != call) return false;
    char name[PATH_MAX];
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const ssize_t length = ::readlink(link.c_str(), name, sizeof name);
    const std::string file(name, length > 0 ? static_cast<std::size_t>(length) : 0);
    return file.size() >= plan.end.size() &&
           file.compare(file.size() - plan.end.size(), plan.end.size(), plan.end) == 0;
}

/// How many of the bytes may still be moved.
std::size_t allowed(std::size_t bytes)
{
    static std::atomic<std::size_t> left{planOf(std::getenv("VDAMF_FAILING")).bytes};
    const std::size_t taken = std::min(bytes, left.load());
    left -= taken;
    return taken;
}

template <class Function>
Function* next(const char* name)
{
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

int failed()
{
    errno = EIO;
    return -1;
}
}  // namespace

extern "C" ssize_t read(int descriptor, void* to, size_t size)
{
    static auto* const real = next<ssize_t(int, void*, size_t)>("read");
    if (!concerns("read", descriptor)) return real(descriptor, to, size);
    const std::size_t some = allowed(size);
    return some == 0 && size > 0 ? failed() : real(descriptor, to, some);
}

extern "C" ssize_t write(int descriptor, const void* from, size_t size)
{
    static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
    if (!concerns("write", descriptor)) return real(descriptor, from, size);
    const std::size_t some = allowed(size);
    return some == 0 && size > 0 ? failed() : real(descriptor, from, some);
}

extern "C" int fsync(int descriptor)
{
    static auto* const real = next<int(int)>("fsync");
    return concerns("fsync", descriptor) ? failed() : real(descriptor);
}

extern "C" int close(int descriptor)
{
    static auto* const real = next<int(int)>("close");
    const bool fails = concerns("close", descriptor);
    const int result = real(descriptor);
    return fails ? failed() : result;
}
