// SPDX-License-Identifier: BSD-3-Clause
// A recording of a GPS receiver, damaged in several ways and read by MRPT's reader and by ours: the
// table of docs/inputs.md, which this test prints.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "../files/temporary_folder.h"
#include "example_objects.h"
#include "sample_rawlogs.h"
#include "two_readers.h"
#include "vdamf/rawlog/rawlog_reader.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kWhole = 692;  // observations

class DamagedSample : public TemporaryFolder
{
protected:
    void SetUp() override
    {
        sample_ = test::sampleRawlog("test_rtk_path.rawlog");
        if (sample_.empty()) GTEST_SKIP() << test::whereSamplesAre();
        RawlogReader reader(sample_);
        while (const auto entry = reader.next()) plain_.push_back(entry->bytes);
        ASSERT_EQ(plain_.size(), kWhole);
    }

    std::string plain() const
    {
        std::string bytes;
        for (const std::string& entry : plain_) bytes += entry;
        return bytes;
    }

    /// With `more` before the observation of that number.
    std::string with(std::size_t number, const std::string& more) const
    {
        std::string bytes;
        for (std::size_t i = 0; i < plain_.size(); ++i)
            bytes += (i == number ? more : std::string()) + plain_[i];
        return bytes;
    }

    static std::string overwritten(std::string bytes, int places)
    {
        std::mt19937 random(7);
        for (int i = 0; i < places; ++i)
        {
            const std::size_t at = random() % (bytes.size() - 40);
            for (std::size_t k = 0; k < 40; ++k) bytes[at + k] = static_cast<char>(random());
        }
        return bytes;
    }

    void compare(const char* damage, const std::string& bytes, std::size_t atLeast)
    {
        const auto file = make("damaged.rawlog", bytes);
        const std::size_t byMrpt = test::countByMrpt(file);
        const std::size_t byUs = test::countByUs(file);
        std::printf("| %s | %zu | %zu |\n", damage, byMrpt, byUs);
        EXPECT_GE(byUs, byMrpt) << damage;
        EXPECT_GE(byUs, atLeast) << damage;
        EXPECT_LE(byUs, kWhole) << damage;
    }

    std::filesystem::path sample_;
    std::vector<std::string> plain_;  ///< entry by entry
};

TEST_F(DamagedSample, IsReadAsFarAsItIsThere)
{
    const std::string whole = plain();
    std::string compressed = test::bytesOf(sample_);
    compare("none", whole, kWhole);
    compare("an object of an unknown class before the 100th",
            with(100, test::unknownObject("mrpt::obs::CNew", "payload")), kWhole);
    compare("40 bytes of another file before the 100th", with(100, std::string(40, '\x7f')),
            kWhole);
    compare("7 places of 40 bytes overwritten", overwritten(whole, 7), kWhole - 14);
    compare("100 places of 40 bytes overwritten", overwritten(whole, 100), kWhole - 200);
    compare("1000 bytes missing in the middle",
            whole.substr(0, whole.size() / 2) + whole.substr(whole.size() / 2 + 1000), kWhole - 10);
    compare("cut in the middle", whole.substr(0, whole.size() / 2), kWhole / 3);
    compressed[compressed.size() / 2] ^= 0x10;
    compare("gz (one member), a bit turned in its middle", compressed, 0);
}

}  // namespace
}  // namespace vdamf
