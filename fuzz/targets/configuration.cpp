// SPDX-License-Identifier: BSD-3-Clause
// config.ini: what is accepted is written back and read again unchanged.
#include "vdamf/rawlog/configuration.h"
#include "memory_file.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    fuzz::mayRefuse(
        [&]
        {
            const Configuration read =
                readConfiguration(IniDocument::parse(fuzz::textOf(data, size), "config.ini"));
            const std::string text = toIni(read);
            const Configuration again = readConfiguration(IniDocument::parse(text, "written.ini"));
            fuzz::require(toIni(again) == text, "a configuration is written as it was read");
        });
    return 0;
}
