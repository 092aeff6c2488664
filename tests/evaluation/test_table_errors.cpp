// SPDX-License-Identifier: BSD-3-Clause
// truth.csv and tracks.csv: errors name file, line and column.
#include <gmock/gmock.h>

#include "table_texts.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using TableErrors = TablesTest;

TEST_F(TableErrors, TruthErrorsNameTheCell)
{
    const std::string header = kHeaderWithoutSensor;
    EXPECT_THAT(truthError(""), HasSubstr("truth.csv:1: the file is empty"));
    EXPECT_THAT(truthError("time_s,object_id\n"), HasSubstr("truth.csv:1: the column 'class'"));
    EXPECT_THAT(truthError(header + "1,1,Car,x,0,0,0,4,2,1,0,-1\n"),
                HasSubstr("truth.csv:2: column 'x_m': expected a finite number, found 'x'"));
    EXPECT_THAT(
        truthError(header + "1,1,Boat,0,0,0,0,4,2,1,0,-1\n"),
        HasSubstr("truth.csv:2: column 'class': unknown class 'Boat'; expected one of Car,"));
    EXPECT_THAT(truthError(header + "1,,Car,0,0,0,0,4,2,1,0,-1\n"), HasSubstr("'object_id'"));
    EXPECT_THAT(truthError(header + "1,1,Car,0,0,0,0,0,2,1,0,-1\n"),
                HasSubstr("column 'length_m': expected a number above 0"));
    EXPECT_THAT(truthError(header + "1,1,Car,0,0,0,0,4,2,1,0,-2\n"), HasSubstr("'points'"));
    EXPECT_THAT(truthError(header + "1,1,Car,0,0,0,0,4,2,1,0\n"),
                HasSubstr("truth.csv:2: expected 12 cells"));
}

TEST_F(TableErrors, TracksErrorsNameTheCell)
{
    const std::string header = kTracksHeader;
    const auto with = [&](const std::string& from, const std::string& to)
    {
        std::string line = kTrackLine;
        return tracksError(header + kTrackLine + line.replace(line.find(from), from.size(), to));
    };
    EXPECT_THAT(with("confirmed", "sure"),
                HasSubstr("tracks.csv:3: column 'status': unknown status 'sure'; expected tent"));
    EXPECT_THAT(with("FL", "FX"), HasSubstr("tracks.csv:3: column 'faces_seen'"));
    EXPECT_THAT(with("FL", "FF"), HasSubstr("tracks.csv:3: column 'faces_seen'"));
    EXPECT_THAT(with(",7,", ",-7,"), HasSubstr("tracks.csv:3: column 'track_id'"));
    EXPECT_THAT(with(",120,", ",99999999999,"), HasSubstr("tracks.csv:3: column 'points'"));
    EXPECT_THAT(with("0.900000", "1.1"), HasSubstr("column 'vehicle_probability'"));
    EXPECT_THAT(with(",2.0000,", ",,"), HasSubstr("column 'y_m': expected a finite number"));
    EXPECT_THAT(with(",4.5000,", ",0,"), HasSubstr("column 'length_m': expected a number above 0"));
    EXPECT_THAT(with(",1.8000,", ",1800,"), HasSubstr("column 'width_m': expected a number above"));
    EXPECT_THAT(with(",0.0003,", ",-0.0003,"),
                HasSubstr("column 'var_heading_rad2': a variance is not below 0, found '-0.0003'"));
    EXPECT_THAT(with(",2.5,FL", ",-1,FL"),
                HasSubstr("column 'nis': a square is not below 0, found '-1'"));
    EXPECT_THAT(with("truck", "lorry"), HasSubstr("column 'vehicle_type': unknown type"));
    EXPECT_THAT(with("0.750000", "1.5"), HasSubstr("column 'type_probability'"));
    EXPECT_THAT(tracksError("time_s\n1\n"), HasSubstr("the column 'track_id' is missing"));
}

TEST_F(TableErrors, ASensorsPoseIsWholeOrAbsent)
{
    EXPECT_THAT(truthError(std::string(kTruthHeader) + "1,1,Car,0,0,0,0,4,2,1,0,-1,5,,0.1\n"),
                HasSubstr("truth.csv:2: column 'sensor_x_m': expected all of"));
}

TEST_F(TableErrors, TruthStandsByTimeAndOnceAFrame)
{
    const std::string header = kHeaderWithoutSensor;
    const std::string rest = ",Car,0,0,0,0,4,2,1,0,-1\n";
    EXPECT_EQ(truthError(header + "1,a" + rest + "1,b" + rest + "2,a" + rest), "(nothing thrown)");
    EXPECT_THAT(truthError(header + "2,a" + rest + "1.5,a" + rest),
                HasSubstr("truth.csv:3: column 'time_s': the time goes back from 2.000000"));
    EXPECT_THAT(truthError(header + "1,a" + rest + "1,b" + rest + "1.0,a" + rest),
                HasSubstr("truth.csv:4: column 'object_id': 'a' stands a second time at 1.0 s"));
}

TEST_F(TableErrors, TracksStandByTimeAndOnceAFrame)
{
    const auto at = [](const std::string& time, const std::string& id)
    {
        std::string line = kTrackLine;
        line.replace(line.find(",7,"), 3, ',' + id + ',');
        return line.replace(0, line.find(','), time);
    };
    const std::string header = kTracksHeader;
    EXPECT_EQ(tracksError(header + at("1", "7") + at("1", "8") + at("2", "7")), "(nothing thrown)");
    EXPECT_THAT(tracksError(header + at("1", "7") + at("0.9", "7")),
                HasSubstr("tracks.csv:3: column 'time_s': the time goes back"));
    EXPECT_THAT(tracksError(header + at("1", "7") + at("1", "07")),
                HasSubstr("tracks.csv:3: column 'track_id': '07' stands a second time at 1 s"));
    EXPECT_THAT(tracksError(""), HasSubstr("tracks.csv:1: the file is empty"));
    EXPECT_THAT(tracksError(header + at("1", "seven")),
                HasSubstr("tracks.csv:2: column 'track_id'"));
    EXPECT_THAT(tracksError(header + at("noon", "7")), HasSubstr("tracks.csv:2: column 'time_s'"));
}

TEST_F(TableErrors, AnIdThatWouldBreakTheTableIsRefused)
{
    TruthRow row;
    row.objectClass = "Car";
    for (const char* id : {"", "a,b", "a\nb", " a", "\"ab", "a\rb"})
    {
        row.objectId = id;
        EXPECT_THAT(errorOf([&] { toCsv(row); }),
                    HasSubstr("without comma, quotation mark, line break, or blank"))
            << id;
    }
}

}  // namespace
}  // namespace vdamf
