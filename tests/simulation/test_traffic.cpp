// SPDX-License-Identifier: BSD-3-Clause
// What is said of recorded traffic that does not come into the scene as it was labelled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "files/temporary_folder.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

class TrafficTables : public TemporaryFolder
{
protected:
    Scenario read(const std::string& text) const
    {
        return readScenario(IniDocument::parse(text, at("scenario.ini").string()));
    }
};

TEST_F(TrafficTables, ASectionThatNamesNoneIsAnError)
{
    for (const std::string text : {"[traffic]\nsmoothing_s = 1\n", "[traffic]\ntable =\n"})
        EXPECT_THAT(errorOf([&] { read(text); }),
                    HasSubstr("traffic.table: is missing: [traffic] needs it, or argoverse_log"))
            << text;
}
}  // namespace
}  // namespace vdamf
