// SPDX-License-Identifier: BSD-3-Clause
// What is said of recorded traffic that does not come into the scene as it was labelled.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "files/temporary_folder.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/files/ini.h"
#include "vdamf/simulation/scenario.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct LabelledCar
{
    std::string id;
    int labels = 6;
    double length = 4.5;  ///< m
};

class TrafficTables : public TemporaryFolder
{
protected:
    Scenario read(const std::string& text) const
    {
        return readScenario(IniDocument::parse(text, at("scenario.ini").string()));
    }

    /// A table with as many rows of each object as it has labels.
    Scenario readTable(const std::vector<LabelledCar>& cars) const
    {
        std::string table = truthHeader();
        for (int i = 0; i < 6; ++i)
            for (const LabelledCar& car : cars)
            {
                const OrientedBox box{10.0, 0.0, 0.0, car.length, 1.8};
                const double time = 100.0 + 0.1 * i;
                if (i < car.labels)
                    table += toCsv({time, car.id, "Car", box, 0.0, 1.5, 0.0, -1, std::nullopt});
            }
        make("truth.csv", table);
        return read("[traffic]\ntable = truth.csv\n");
    }

    std::string tablePath() const { return at("truth.csv").string(); }
};

TEST_F(TrafficTables, ASectionThatNamesNoneIsAnError)
{
    for (const std::string text : {"[traffic]\nsmoothing_s = 1\n", "[traffic]\ntable =\n"})
        EXPECT_THAT(errorOf([&] { read(text); }),
                    HasSubstr("traffic.table: is missing: [traffic] needs it, or argoverse_log"))
            << text;
}

TEST_F(TrafficTables, WhatIsAsItIsLabelledIsNoWarning)
{
    const Scenario scenario = readTable({{"a"}, {"b", 5}, {"c", 6, 2.0}});
    EXPECT_EQ(scenario.scene.objects.size(), 3U);
    EXPECT_THAT(scenario.warnings, IsEmpty());
}

TEST_F(TrafficTables, WhatIsLeftOutOrABoxIsCountedAndNamed)
{
    const Scenario scenario =
        readTable({{"a"}, {"rare", 4}, {"small", 6, 1.9}, {"seldom", 1, 1.9}});
    EXPECT_EQ(scenario.scene.objects.size(), 2U);
    EXPECT_EQ(scenario.scene.objects.at(1).objectClass, ObjectClass::Box);
    EXPECT_THAT(
        scenario.warnings,
        ElementsAre(tablePath() + ": 2 of its 4 objects have fewer than 5 labels and are left out: "
                                  "'rare', 'seldom'",
                    tablePath() + ": 1 of its 4 objects are smaller than their class can be: boxes "
                                  "in the scene, not in the truth: 'small'"));
}

TEST_F(TrafficTables, OfManyTheFirstAreNamed)
{
    const Scenario scenario =
        readTable({{"1", 1}, {"2", 1}, {"3", 1}, {"4", 1}, {"5", 1}, {"6", 1}, {"7", 1}});
    ASSERT_EQ(scenario.warnings.size(), 1U);
    EXPECT_THAT(scenario.warnings.front(),
                AllOf(HasSubstr(": 7 of its 7 objects"),
                      testing::EndsWith("'1', '2', '3', '4', '5', ...")));
}

TEST_F(TrafficTables, WithoutObjectsIsAnError)
{
    EXPECT_THAT(errorOf([&] { readTable({}); }), HasSubstr("truth.csv: holds no object"));
}
}  // namespace
}  // namespace vdamf
