// SPDX-License-Identifier: BSD-3-Clause
// A point cloud in a PLY file.
#include "clouds.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    fuzz::mayRefuse([&] { fuzz::check(parsePly(fuzz::textOf(data, size), "fuzz.ply")); });
    return 0;
}
