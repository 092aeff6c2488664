// SPDX-License-Identifier: BSD-3-Clause
// A folder of its own for each test, removed at the end, and what tests ask of files.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>

namespace vdamf
{
class TemporaryFolder : public ::testing::Test
{
protected:
    TemporaryFolder()
    {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  ("vdamf_" + std::string(test->test_suite_name()) + "_" + test->name() + "_" +
                   std::to_string(::getpid()));
        std::filesystem::create_directories(folder_);
    }
    ~TemporaryFolder() override
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    std::filesystem::path at(const std::string& name) const { return folder_ / name; }

    std::filesystem::path make(const std::string& name, const std::string& bytes) const
    {
        std::filesystem::create_directories(at(name).parent_path());
        std::ofstream(at(name), std::ios::binary) << bytes;
        return at(name);
    }

    std::string contentOf(const std::string& name) const
    {
        std::ifstream file(at(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    std::size_t filesInFolder() const
    {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

private:
    std::filesystem::path folder_;
};

/// The message of the std::runtime_error that the call throws; "(nothing thrown)" if none.
inline std::string errorOf(const std::function<void()>& call)
{
    try
    {
        call();
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "(nothing thrown)";
}

}  // namespace vdamf
