// SPDX-License-Identifier: BSD-3-Clause
// A rawlog that stands in its file as one object.
#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CRawlog.h>

#include "../files/temporary_folder.h"
#include "example_objects.h"

namespace vdamf
{
namespace
{
class RawlogObject : public TemporaryFolder
{
};

TEST_F(RawlogObject, IsReadEntryByEntry)
{
    mrpt::obs::CRawlog rawlog;
    for (int i = 0; i < 5; ++i)
        rawlog.insert(mrpt::obs::CObservationOdometry::Create(test::odometry(i)));
    mrpt::obs::CActionCollection actions;
    rawlog.insert(actions);
    const std::string bytes = serialized(rawlog) + serialized(test::odometry(5));
    RawlogReader reader(make("whole.rawlog", bytes));
    const auto entries = test::entriesOf(reader);
    EXPECT_TRUE(bytes == test::concatenated(entries));
    int read = 0;
    for (const RawlogEntry& entry : entries)
        if (std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(entry.object)) ++read;
    EXPECT_EQ(read, 6);
    EXPECT_EQ(reader.summary().objects, 8U);  // with the actions and the comment
    EXPECT_EQ(reader.summary().damaged, 0U);
    EXPECT_FALSE(reader.summary().truncated);
}

}  // namespace
}  // namespace vdamf
