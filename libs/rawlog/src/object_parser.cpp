// SPDX-License-Identifier: BSD-3-Clause
#include "object_parser.h"

#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

#include "object_header.h"
#include "string_archive.h"
#include "vdamf/rawlog/allocation_limit.h"

namespace vdamf
{
namespace
{
// One allocation of an object; a scan of an HDL-64E needs half a megabyte for each of its vectors.
constexpr std::size_t kLargestAllocation = std::size_t{256} << 20;
// All allocations of an object, those of its parts that are given back at once included.
constexpr std::size_t kLargestSum = std::size_t{384} << 20;
constexpr std::size_t kLargestObject = std::size_t{256} << 20;

class WindowArchive : public mrpt::serialization::CArchive
{
public:
    explicit WindowArchive(EntryWindow& window) : window_(window) {}

    std::size_t bytesRead() const { return cursor_; }
    bool reachedEnd() const { return reachedEnd_; }
    std::string getArchiveDescription() const override { return "rawlog"; }

protected:
    // Reads all or throws: most callers inside MRPT take fewer bytes for success.
    std::size_t read(void* to, std::size_t size) override
    {
        if (size > kLargestObject - cursor_) throw std::runtime_error("larger than 256 MB");
        // The limit is for what MRPT allocates, not for the window.
        const AllocationLimit none(AllocationLimit::kNone);
        if (!window_.require(cursor_ + size))
        {
            reachedEnd_ = true;
            throw std::runtime_error("the file ends inside this object");
        }
        std::memcpy(to, window_.loaded().data() + cursor_, size);
        cursor_ += size;
        return size;
    }
    std::size_t write(const void*, std::size_t) override
    {
        throw std::logic_error("WindowArchive only reads");
    }

private:
    EntryWindow& window_;
    std::size_t cursor_ = 0;
    bool reachedEnd_ = false;
};

// Objects in memory are a few times larger than in a file. So what a small file claims to hold
// costs no time either: MRPT fills its containers with zeros before it reads.
AllocationLimit limitFor(const GzInput& input)
{
    constexpr std::uint64_t kInMemory = 64;
    constexpr std::uint64_t kAlways = 1 << 20;
    const std::uint64_t most = std::min<std::uint64_t>(input.largestContent(), kLargestSum);
    const auto plausible = static_cast<std::size_t>(kAlways + kInMemory * most);
    return AllocationLimit(std::min(kLargestAllocation, plausible),
                           std::min(kLargestSum, plausible));
}

std::string reasonOf(const std::exception& error, const WindowArchive& archive,
                     const GzInput& input)
{
    if (archive.reachedEnd() && !input.readError().empty()) return "it could not be read on";
    if (archive.reachedEnd()) return "the file ends inside this object";
    return shortMessage(error.what());
}
}  // namespace

ParsedObject parseObject(EntryWindow& window)
{
    WindowArchive archive(window);
    ParsedObject result;
    try
    {
        const AllocationLimit limit = limitFor(window.input());
        result.object = archive.ReadObject();
        if (!result.object) result.problem = "the object is none that can be stored";
    }
    catch (const std::bad_alloc&)
    {
        result.problem = "it claims a size beyond all reason";
    }
    catch (const std::length_error&)
    {
        result.problem = "it claims a size beyond all reason";
    }
    catch (const std::exception& error)
    {
        result.problem = reasonOf(error, archive, window.input());
    }
    result.bytes = archive.bytesRead();
    result.reachedEnd = archive.reachedEnd();
    return result;
}

std::string shortMessage(const std::string& what)
{
    static const std::string kInner = "Original exception:\n";
    static const std::string kMessage = "Message:";
    std::size_t from = what.rfind(kInner);
    from = from == std::string::npos ? 0 : from + kInner.size();
    const std::size_t message = what.find(kMessage, from);
    if (message != std::string::npos) from = message + kMessage.size();
    from = std::min(what.find_first_not_of(" \n", from), what.size());
    return what.substr(from, what.find('\n', from) - from);
}

int newestVersion(const std::string& className)
{
    try
    {
        const auto* id = mrpt::rtti::findRegisteredClass(className);
        if (id == nullptr || !id->ptrCreateObject) return -1;
        const auto object =
            std::dynamic_pointer_cast<mrpt::serialization::CSerializable>(id->createObject());
        if (!object) return -1;
        StringArchive archive;
        archive.WriteObject(*object);
        const auto header = parseObjectHeader(archive.bytes);
        return header ? header->version : -1;
    }
    catch (const std::exception&)
    {
        return -1;
    }
}

}  // namespace vdamf
