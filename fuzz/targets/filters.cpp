// SPDX-License-Identifier: BSD-3-Clause
// Learned filters: what is accepted is written back and read again unchanged.
#include "memory_file.h"
#include "require.h"
#include "vdamf/rawlog/filter_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    fuzz::mayRefuse(
        [&]
        {
            const FilterBank read = parseFilterBank(fuzz::textOf(data, size), "filters.txt");
            const std::string text = toText(read);
            fuzz::require(toText(parseFilterBank(text, "written.txt")) == text,
                          "filters are written as they were read");
        });
    return 0;
}
