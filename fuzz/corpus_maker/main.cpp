// SPDX-License-Identifier: BSD-3-Clause
// Writes the inputs that fuzzing starts from: vdamf_fuzz_corpus FOLDER
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "corpus.h"

namespace
{
void write(const std::filesystem::path& path, const std::string& bytes)
{
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path.string());
    std::printf("%8zu  %s\n", bytes.size(), path.c_str());
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::fprintf(stderr, "usage: vdamf_fuzz_corpus FOLDER, for example fuzz/corpus\n");
        return 2;
    }
    try
    {
        const std::filesystem::path folder(argv[1]);
        for (const auto& corpus :
             {vdamf::fuzz::rawlogCorpus(), vdamf::fuzz::textCorpus(), vdamf::fuzz::importCorpus()})
            for (const auto& [name, bytes] : corpus) write(folder / name, bytes);
        return 0;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "vdamf_fuzz_corpus: %s\n", error.what());
        return 1;
    }
}
