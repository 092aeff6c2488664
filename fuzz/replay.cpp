// SPDX-License-Identifier: BSD-3-Clause
// Runs a target on files, without libFuzzer and with any compiler: replay FILE-OR-FOLDER...
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{
namespace fs = std::filesystem;

std::vector<fs::path> filesOf(const fs::path& path)
{
    if (!fs::is_directory(path)) return {path};
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(path))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void replay(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    // Of this size exactly, so that AddressSanitizer sees a step beyond the end.
    const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
    std::printf("%s (%zu bytes)\n", path.c_str(), input.size());
    std::fflush(stdout);  // the name of the one that crashes
    LLVMFuzzerTestOneInput(input.data(), input.size());
}
}  // namespace

int main(int argc, char** argv)
{
    try
    {
        std::size_t count = 0;
        for (int i = 1; i < argc; ++i)
            for (const fs::path& path : filesOf(argv[i]))
            {
                replay(path);
                ++count;
            }
        std::printf("%zu inputs\n", count);
        return count > 0 ? 0 : 1;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "replay: %s\n", error.what());
        return 1;
    }
}
