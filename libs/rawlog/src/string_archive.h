// SPDX-License-Identifier: BSD-3-Clause
// An archive of MRPT that writes into a string.
#pragma once

#include <mrpt/serialization/CArchive.h>

#include <stdexcept>
#include <string>

namespace vdamf
{
class StringArchive : public mrpt::serialization::CArchive
{
public:
    std::string bytes;

    std::string getArchiveDescription() const override { return "bytes in memory"; }

protected:
    std::size_t write(const void* data, std::size_t size) override
    {
        bytes.append(static_cast<const char*>(data), size);
        return size;
    }
    std::size_t read(void*, std::size_t) override
    {
        throw std::logic_error("StringArchive only writes");
    }
};

}  // namespace vdamf
