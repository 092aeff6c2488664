// SPDX-License-Identifier: BSD-3-Clause
// `--set section.key=value`, line by line, over an ini text: both parts of the input are free.
#include "memory_file.h"
#include "require.h"
#include "vdamf/rawlog/configuration.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    std::string_view lines = fuzz::textOf(data, size);
    fuzz::mayRefuse(
        [&]
        {
            IniDocument document = IniDocument::parse("[clustering]\ngap_m = 0.4\n", "config.ini");
            while (!lines.empty())
            {
                const std::size_t end = std::min(lines.find('\n'), lines.size());
                document.set(lines.substr(0, end));
                lines.remove_prefix(std::min(end + 1, lines.size()));
            }
            readConfiguration(document);
        });
    return 0;
}
