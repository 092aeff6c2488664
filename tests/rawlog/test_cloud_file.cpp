// SPDX-License-Identifier: BSD-3-Clause
// PCD and PLY: every form of the same cloud gives the same hits; what is damaged is told.
#include "vdamf/rawlog/cloud_file.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>

#include "../files/temporary_folder.h"
#include "replaced_text.h"

namespace vdamf
{
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <class T>
std::string bytesOf(T value, bool bigEndian = false)
{
    std::string bytes(sizeof(value), '\0');
    std::memcpy(bytes.data(), &value, sizeof(value));
    if (bigEndian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

constexpr int kPoints = 50;
float x(int i)
{
    return 0.5F * static_cast<float>(i) + 1.0F;
}
float z(int i)
{
    return i == 7 ? std::numeric_limits<float>::quiet_NaN() : 0.25F;
}

std::string pcdHeader(const std::string& data)
{
    return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y normal z intensity t\nSIZE 4 8 4 4 1 4\n"
           "TYPE F F F F U U\nCOUNT 1 1 3 1 1 1\nWIDTH 50\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
           "POINTS 50\nDATA " +
           data + "\n";
}

std::string asciiPcd()
{
    std::string text = pcdHeader("ascii");
    for (int i = 0; i < kPoints; ++i)
        text += std::to_string(x(i)) + " -2.5 0 0 1 " + (i == 7 ? "nan" : "0.25") + " 51 " +
                std::to_string(1000000 * i) + "\n";
    return text;
}

std::string binaryPcd()
{
    std::string text = pcdHeader("binary");
    for (int i = 0; i < kPoints; ++i)
        text += bytesOf(x(i)) + bytesOf(-2.5) + bytesOf(0.0F) + bytesOf(0.0F) + bytesOf(1.0F) +
                bytesOf(z(i)) + bytesOf(std::uint8_t{51}) +
                bytesOf(static_cast<std::uint32_t>(1000000 * i));
    return text;
}

/// A stream of LZF that holds the bytes as they are, 32 at a time.
std::string literalLzf(const std::string& data)
{
    std::string stream;
    for (std::size_t at = 0; at < data.size(); at += 32)
    {
        const std::string part = data.substr(at, 32);
        stream += static_cast<char>(part.size() - 1) + part;
    }
    return stream;
}

std::string compressedPcd()
{
    std::string data;
    for (int i = 0; i < kPoints; ++i) data += bytesOf(x(i));
    for (int i = 0; i < kPoints; ++i) data += bytesOf(-2.5);
    for (int i = 0; i < kPoints; ++i) data += bytesOf(0.0F) + bytesOf(0.0F) + bytesOf(1.0F);
    for (int i = 0; i < kPoints; ++i) data += bytesOf(z(i));
    for (int i = 0; i < kPoints; ++i) data += bytesOf(std::uint8_t{51});
    for (int i = 0; i < kPoints; ++i) data += bytesOf(static_cast<std::uint32_t>(1000000 * i));
    const std::string stream = literalLzf(data);
    return pcdHeader("binary_compressed") + bytesOf(static_cast<std::uint32_t>(stream.size())) +
           bytesOf(static_cast<std::uint32_t>(data.size())) + stream;
}

std::string plyHeader(const std::string& format)
{
    return "ply\nformat " + format +
           " 1.0\ncomment made by hand\nelement camera 1\nproperty float f\nelement vertex 50\n"
           "property float x\nproperty double y\nproperty float32 z\nproperty uchar intensity\n"
           "property uint32 t\nelement face 0\nproperty list uchar int vertex_indices\n"
           "end_header\n";
}

std::string binaryPly(bool bigEndian)
{
    std::string text = plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian");
    text += bytesOf(1.0F, bigEndian);
    for (int i = 0; i < kPoints; ++i)
        text += bytesOf(x(i), bigEndian) + bytesOf(-2.5, bigEndian) + bytesOf(z(i), bigEndian) +
                bytesOf(std::uint8_t{51}) +
                bytesOf(static_cast<std::uint32_t>(1000000 * i), bigEndian);
    return text;
}

std::string asciiPly()
{
    std::string text = plyHeader("ascii") + "1.0\n";
    for (int i = 0; i < kPoints; ++i)
        text += std::to_string(x(i)) + " -2.5 " + (i == 7 ? "nan" : "0.25") + " 51 " +
                std::to_string(1000000 * i) + "\n";
    return text;
}

void expectTheCloud(const FileCloud& cloud)
{
    ASSERT_EQ(cloud.points.size(), 49U);
    EXPECT_EQ(cloud.leftOut, 1U) << "not finite";
    for (std::size_t i = 0; i < 49; ++i)
    {
        const int k = static_cast<int>(i) + (i >= 7 ? 1 : 0);
        EXPECT_FLOAT_EQ(cloud.points.x[i], x(k));
        EXPECT_FLOAT_EQ(cloud.points.y[i], -2.5F);
        EXPECT_FLOAT_EQ(cloud.points.z[i], 0.25F);
        EXPECT_FLOAT_EQ(cloud.points.intensity[i], 0.2F);
        EXPECT_NEAR(cloud.times[i], 1e-3 * k, 1e-12);
    }
}

/// A header that claims another count.
std::string ofPoints(const std::string& pcd, const std::string& count)
{
    return replaced(replaced(pcd, "WIDTH 50", "WIDTH " + count), "POINTS 50", "POINTS " + count);
}

FileCloud parse(const std::string& bytes)
{
    return bytes.substr(0, 3) == "ply" ? parsePly(bytes, "c.ply") : parsePcd(bytes, "c.pcd");
}

std::vector<std::string> allForms()
{
    return {asciiPcd(), binaryPcd(),      compressedPcd(),
            asciiPly(), binaryPly(false), binaryPly(true)};
}

std::string cloudError(const std::string& bytes)
{
    try
    {
        parse(bytes);
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "none";
}

TEST(CloudFile, AllFormsGiveTheSameHits)
{
    for (const std::string& form : allForms())
    {
        SCOPED_TRACE(form.substr(0, form.find("1.0\n") + 4));
        expectTheCloud(parse(form));
    }
}

TEST(CloudFile, TimesAreTakenInTheUnitAskedFor)
{
    EXPECT_TRUE(parsePcd(asciiPcd(), "c", PointTime::None).times.empty());
    EXPECT_NEAR(parsePcd(asciiPcd(), "c", PointTime::Microseconds).times[2], 2.0, 1e-12);
    const std::string floating = replaced(asciiPcd(), "TYPE F F F F U U", "TYPE F F F F U F");
    EXPECT_NEAR(parsePcd(floating, "c").times[2], 2e6, 1e-6);
}

TEST(CloudFile, HitsWithoutATimeAreLeftOut)
{
    const std::string floating = replaced(asciiPcd(), "TYPE F F F F U U", "TYPE F F F F U F");
    const std::string damaged = replaced(floating, " 2000000\n", " nan\n");
    const FileCloud cloud = parsePcd(damaged, "c");
    ASSERT_EQ(cloud.points.size(), 48U);
    ASSERT_EQ(cloud.times.size(), 48U);
    EXPECT_FLOAT_EQ(cloud.points.x[2], x(3));
    EXPECT_EQ(cloud.times[2], 3e6);
    EXPECT_EQ(parsePcd(damaged, "c", PointTime::None).points.size(), 49U);
}

TEST(CloudFile, HitsOfABinThatCannotBeAreLeftOut)
{
    std::string bin;
    for (const float ahead : {1.0F, std::numeric_limits<float>::quiet_NaN(), 1e30F, 4.0F})
        bin += bytesOf(ahead) + bytesOf(2.0F) + bytesOf(3.0F) + bytesOf(0.5F);
    const FileCloud cloud = parseBin(bin, "c.bin");
    EXPECT_EQ(cloud.leftOut, 2U);
    EXPECT_THAT(cloud.points.x, ElementsAre(1.0F, 4.0F));
    EXPECT_THAT(cloud.points.z, ElementsAre(3.0F, 3.0F));
    EXPECT_THAT(cloud.points.intensity, ElementsAre(0.5F, 0.5F));
    EXPECT_THAT(errorOf([&] { parseBin(bin.substr(1), "c.bin"); }),
                HasSubstr("c.bin: has 63 bytes; expected 16 a point: the file is cut short"));
}

TEST(CloudFile, SaysWhatIsWrong)
{
    EXPECT_THAT(cloudError("nothing"), HasSubstr("c.pcd:1: no PCD header"));
    EXPECT_THAT(cloudError(""), HasSubstr("line DATA is missing"));
    EXPECT_THAT(cloudError(replaced(asciiPcd(), "FIELDS x", "FIELDS u")),
                HasSubstr("no field 'x'"));
    EXPECT_THAT(cloudError(replaced(asciiPcd(), "SIZE 4 8", "SIZE 4")), HasSubstr("c.pcd:4: SIZE"));
    EXPECT_THAT(cloudError(ofPoints(asciiPcd(), "51")), HasSubstr("ends after 50 of 51 points"));
    EXPECT_THAT(cloudError(replaced(asciiPcd(), "-2.5", "abc")),
                HasSubstr("c.pcd:12: expected a num"));
    EXPECT_THAT(cloudError(replaced(asciiPcd(), "-2.5 ", "")),
                HasSubstr("c.pcd:12: expected 8 numb"));
    EXPECT_THAT(cloudError(ofPoints(binaryPcd(), "49999999")), HasSubstr("claims more than 1 GB"));
    EXPECT_THAT(cloudError(ofPoints(binaryPcd(), "5000")), HasSubstr("cut short"));
    EXPECT_THAT(cloudError(binaryPcd().substr(0, 900)), HasSubstr("cut short"));
    EXPECT_THAT(cloudError(compressedPcd().substr(0, 900)), HasSubstr("bytes of compressed data"));
    EXPECT_THAT(cloudError(replaced(asciiPly(), "property float x", "property list uchar int x")),
                HasSubstr("has a list"));
    EXPECT_THAT(cloudError(replaced(asciiPly(), "element vertex 50", "element vertex -1")),
                HasSubstr("c.ply:6: expected 'element"));
    EXPECT_THAT(cloudError(replaced(binaryPly(true), "vertex 50", "vertex 5000")),
                HasSubstr("cut short"));
    EXPECT_THAT(cloudError(replaced(asciiPly(), "element vertex", "element wertex")),
                HasSubstr("no element 'vertex'"));
}

TEST(CloudFile, CountsOfAPcdThatDoNotAgreeAreRefused)
{
    for (const std::string& pcd : {asciiPcd(), binaryPcd(), compressedPcd()})
    {
        EXPECT_THAT(cloudError(replaced(pcd, "WIDTH 50", "WIDTH -1")),
                    HasSubstr("c.pcd:7: expected a whole number from 0 to 50000000, found '-1'"));
        EXPECT_THAT(cloudError(replaced(pcd, "HEIGHT 1", "HEIGHT 2.5")),
                    HasSubstr("c.pcd:8: expected a whole number from 0 to 50000000, found '2.5'"));
        EXPECT_THAT(cloudError(replaced(pcd, "HEIGHT 1", "HEIGHT 2")),
                    HasSubstr("c.pcd:11: WIDTH 50 x HEIGHT 2 are not the 50 of POINTS"));
        EXPECT_EQ(cloudError(replaced(pcd, "WIDTH 50\nHEIGHT 1", "WIDTH 10\nHEIGHT 5")), "none");
        EXPECT_EQ(cloudError(replaced(pcd, "HEIGHT 1\n", "")), "none") << "nothing to compare";
    }
    EXPECT_THAT(cloudError(ofPoints(asciiPcd(), "49")),
                HasSubstr("c.pcd:61: expected the end behind 49 points, found '25.5"));
    EXPECT_EQ(cloudError(asciiPcd() + "\n \r\n"), "none");
}

TEST(CloudFile, DamageDoesNoHarm)
{
    std::mt19937 random(5);
    int read = 0;
    for (const std::string& form : allForms())
        for (int i = 0; i < 300; ++i)
        {
            std::string bytes = form;
            for (int k = 0; k < 3; ++k)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            if (i % 5 == 0) bytes.resize(random() % bytes.size());
            read += cloudError(bytes) == "none" ? 1 : 0;
        }
    EXPECT_GT(read, 100);
    EXPECT_LT(read, 1700);
}

class CloudFiles : public TemporaryFolder
{
};

TEST_F(CloudFiles, AreKnownByTheirEnding)
{
    expectTheCloud(readCloudFile(make("a.PCD", binaryPcd())));
    expectTheCloud(readCloudFile(make("a.ply", asciiPly())));
    expectTheCloud(readCloudFile(make("marked.pcd", "\xEF\xBB\xBF" + binaryPcd())));
    expectTheCloud(readCloudFile(make("marked.ply", "\xEF\xBB\xBF" + asciiPly())));
    std::string bin;
    for (const float value : {1.0F, 2.0F, 3.0F, 0.5F}) bin += bytesOf(value);
    EXPECT_EQ(readCloudFile(make("a.bin", bin)).points.size(), 1U);
    EXPECT_THROW(readCloudFile(make("a.xyz", bin)), std::runtime_error);
}

}  // namespace
}  // namespace vdamf
