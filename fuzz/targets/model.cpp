// SPDX-License-Identifier: BSD-3-Clause
// Models of the discriminator: what is accepted is written back and read again unchanged.
#include "vdamf/tracking/discrimination/model.h"
#include "memory_file.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    fuzz::mayRefuse(
        [&]
        {
            const DiscriminatorModel read =
                parseDiscriminatorModel(std::string(fuzz::textOf(data, size)), "model.txt");
            const std::string text = toText(read);
            fuzz::require(toText(parseDiscriminatorModel(text, "written.txt")) == text,
                          "a model is written as it was read");
        });
    return 0;
}
