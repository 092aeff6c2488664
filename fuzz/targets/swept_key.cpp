// SPDX-License-Identifier: BSD-3-Clause
// What stands behind a swept key of a sweep's file.
#include "vdamf/experiments/swept_key.h"
#include "memory_file.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    fuzz::mayRefuse(
        [&]
        {
            const SweptKey key = parseSweptKey("section.key", fuzz::textOf(data, size), 1);
            fuzz::require(key.values.empty() == key.interval.has_value(),
                          "a key has values or an interval");
            if (key.interval)
                fuzz::require(key.interval->min < key.interval->max, "an interval is not empty");
        });
    return 0;
}
