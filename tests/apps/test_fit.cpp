// SPDX-License-Identifier: BSD-3-Clause
// vdamf-fit through its command line.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "apps/fit_fixture.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;
namespace fs = std::filesystem;

const char* const kCovariance[] = {
    "var_x_m2",         "cov_xy_m2",    "var_y_m2",          "cov_x_heading",      "cov_y_heading",
    "var_heading_rad2", "cov_x_length", "cov_y_length",      "cov_heading_length", "var_length_m2",
    "cov_x_width",      "cov_y_width",  "cov_heading_width", "cov_length_width",   "var_width_m2"};

TEST_F(FitProgram, RecoversABox)
{
    ASSERT_EQ(fit(kFitHeader + twoFaces("car", kCar, {0.0, 0.0})), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("clusters       1"));
    CsvReader rows = fits();
    ASSERT_TRUE(rows.next());
    EXPECT_EQ(rows.text("cluster"), "car");
    EXPECT_EQ(rows.integer("points"), 124);
    expectNearCar(rows, 0.1, {0.0, 0.0});
    for (const char* column : {"var_x_m2", "var_y_m2", "var_heading_rad2", "var_length_m2"})
        EXPECT_GT(rows.number(column), 0.0) << column;
    EXPECT_LT(std::sqrt(rows.number("var_heading_rad2")), 0.05);
    EXPECT_LE(std::abs(rows.number("cov_xy_m2")),
              std::sqrt(rows.number("var_x_m2") * rows.number("var_y_m2")));
    EXPECT_FALSE(rows.next());
}

TEST_F(FitProgram, MapCoordinatesLoseNothing)
{
    const Eigen::Vector2d map(1234567.0, -7654321.0);
    OrientedBox far = kCar;
    far.x += map.x();
    far.y += map.y();
    ASSERT_EQ(fit(kFitHeader + twoFaces("near", kCar, {0.0, 0.0}) + twoFaces("far", far, map)), 0);
    CsvReader rows = fits();
    ASSERT_TRUE(rows.next());
    const double x = rows.number("x_m");
    const double length = rows.number("length_m");
    ASSERT_TRUE(rows.next());
    expectNearCar(rows, 0.1, map);
    EXPECT_NEAR(rows.number("x_m") - map.x(), x, 0.001);
    EXPECT_NEAR(rows.number("length_m"), length, 0.001);
}

TEST_F(FitProgram, StartsFromTheHeadingOfTheTable)
{
    const std::string header = "cluster,sensor_x_m,sensor_y_m,x_m,y_m,heading_rad\n";
    ASSERT_EQ(fit(header + twoFaces("free", kCar, {0.0, 0.0}, ",") +
                  twoFaces("towards", kCar, {0.0, 0.0}, "," + toText(kCar.heading - 3.1))),
              0)
        << output_;
    CsvReader rows = fits();
    ASSERT_TRUE(rows.next());
    expectNearCar(rows, 0.1, {0.0, 0.0});
    ASSERT_TRUE(rows.next());
    EXPECT_NEAR(rows.number("heading_rad"), kCar.heading + kPi, 0.02);
    EXPECT_EQ(rows.text("faces_seen"), "FL");
}

TEST_F(FitProgram, DegenerateClustersGetARowWithTheReason)
{
    struct Case
    {
        const char* rows;
        const char* reason;
    };
    const Case cases[] = {
        {"a,0,0,9,1\n", "fewer than 3 hits"},
        {"a,0,0,9,1\na,0,0,9,2\n", "fewer than 3 hits"},
        {"a,0,0,9,1\na,0,0,9,1\na,0,0,9,1\n", "all hits in one place"},
        {"a,0,0,9,1\na,0,0,nan,2\na,0,0,9,3\n", "not a finite number (line 3)"},
        {"a,0,0,9,1\na,0,0,9,-INF\na,0,0,9,3\n", "not a finite number (line 3)"},
        {"a,nan,0,9,1\na,nan,0,9,2\na,nan,0,9,3\n", "not a finite number (line 2)"},
        {"a,0,0,1e300,1\na,0,0,9,-1e300\na,0,0,9,3\n", "more than 1 km"},
    };
    for (const Case& one : cases)
    {
        ASSERT_EQ(fit(kFitHeader + one.rows + twoFaces("next", kCar, {0.0, 0.0})), 0) << output_;
        CsvReader rows = fits();
        ASSERT_TRUE(rows.next());
        EXPECT_EQ(rows.integer("converged"), 0);
        EXPECT_THAT(rows.text("reason"), HasSubstr(one.reason));
        EXPECT_EQ(rows.text("x_m"), "");
        EXPECT_EQ(rows.text("var_width_m2"), "");
        ASSERT_TRUE(rows.next());
        EXPECT_EQ(rows.text("cluster"), "next");
        EXPECT_EQ(rows.integer("converged"), 1);
    }
}

TEST_F(FitProgram, OddClustersGiveFiniteNumbers)
{
    const std::string line =
        "line,0,0,1,1\nline,0,0,2,2\nline,0,0,3,3\nline,0,0,4,4\nline,0,0,5,5\n";
    const std::string corner = "corner,0,0,500,0\ncorner,0,0,0,0\ncorner,0,0,0,500\n";
    const std::string tiny = "tiny,5,5,0,0\ntiny,5,5,0,0.002\ntiny,5,5,0,0\n";
    const std::string amid = "amid,0,0,-1,0\namid,0,0,0,0\namid,0,0,1,0\namid,0,0,0,1\n";
    const std::string afar = "afar,1e12,0,0,1\nafar,1e12,0,0,2\nafar,1e12,0,0.5,3\n";
    ASSERT_EQ(fit(kFitHeader + line + corner + tiny + amid + afar), 0) << output_;
    CsvReader rows = fits();
    int count = 0;
    for (; rows.next(); ++count)
    {
        for (const char* column : {"x_m", "y_m", "heading_rad", "length_m", "width_m", "match"})
            EXPECT_TRUE(rows.optionalNumber(column)) << rows.text("cluster") << " " << column;
        for (const char* column : kCovariance)
            EXPECT_TRUE(rows.optionalNumber(column)) << rows.text("cluster") << " " << column;
    }
    EXPECT_EQ(count, 5);
}

TEST_F(FitProgram, TakesTheMeasurementOfTheConfiguration)
{
    const std::string table = kFitHeader + twoFaces("car", kCar, {0.0, 0.0});
    const auto iterationsWith = [&](const std::string& arguments)
    {
        EXPECT_EQ(fit(table, arguments), 0) << output_;
        CsvReader rows = fits();
        EXPECT_TRUE(rows.next());
        return rows.integer("iterations");
    };
    make("config.ini", "[clustering]\ngap_m = 0.3\n[measurement]\noptimizer = nlopt_bobyqa\n");
    EXPECT_EQ(fit(table, "-c '" VDAMF_SOURCE_DIR "/config.ini'"), 0) << output_;
    const std::int64_t usual = iterationsWith("");
    EXPECT_GT(iterationsWith("-c config.ini"), usual);
    EXPECT_EQ(iterationsWith("-c config.ini --set measurement.optimizer=levenberg_marquardt"),
              usual);
    ASSERT_EQ(fit(table, "--set measurement.filter=paper"), 0);
    CsvReader rows = fits();
    ASSERT_TRUE(rows.next());
    EXPECT_GT(rows.number("length_m"), kCar.length + 0.2);  // its strips lie outside of the hits
    EXPECT_EQ(fit(table, "--set measurement.max_iterations=1"), 0);
    CsvReader cutShort = fits();
    ASSERT_TRUE(cutShort.next());
    EXPECT_EQ(cutShort.integer("converged"), 0);
    EXPECT_THAT(cutShort.text("reason"), HasSubstr("no convergence"));
}

// Most memory that a program run so far has held, bytes.
double mostMemory()
{
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

TEST_F(FitProgram, ManyClustersTakeNoMoreMemoryThanOne)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "AddressSanitizer keeps what was freed";
#endif
    ASSERT_EQ(fit(kFitHeader + twoFaces("car", kCar, {0.0, 0.0})), 0);
    const double forOne = mostMemory();
    constexpr int kClusters = 3000;
    {
        std::ofstream table(at("clusters.csv"));
        table << kFitHeader;
        const std::string rows = twoFaces("", kCar, {0.0, 0.0});
        for (int i = 0; i < kClusters; ++i)
        {
            for (std::size_t begin = 0; begin < rows.size();)
            {
                const std::size_t end = rows.find('\n', begin) + 1;
                table << i << rows.substr(begin, end - begin);
                begin = end;
            }
        }
    }
    const auto tableSize = static_cast<double>(fs::file_size(at("clusters.csv")));
    ASSERT_EQ(run("-i clusters.csv -o fits.csv --overwrite"), 0) << output_;
    EXPECT_THAT(output_, HasSubstr("clusters       3000"));
    EXPECT_LT(mostMemory() - forOne, 0.25 * tableSize);
}
}  // namespace
}  // namespace vdamf
