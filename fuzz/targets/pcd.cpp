// SPDX-License-Identifier: BSD-3-Clause
// A point cloud in a PCD file.
#include "clouds.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    fuzz::mayRefuse([&] { fuzz::check(parsePcd(fuzz::textOf(data, size), "fuzz.pcd")); });
    return 0;
}
