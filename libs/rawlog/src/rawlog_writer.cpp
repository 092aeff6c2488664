// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/rawlog_writer.h"

#include <chrono>
#include <deque>
#include <exception>
#include <future>
#include <stdexcept>
#include <utility>

#include "string_archive.h"
#include "vdamf/files/gz_member.h"

namespace vdamf
{
namespace
{
RawlogWriter::Options checked(const RawlogWriter::Options& options)
{
    if (options.gzLevel < 0 || options.gzLevel > 9)
    {
        throw std::runtime_error("gz level " + std::to_string(options.gzLevel) +
                                 " is out of range: expected 0 (plain) to 9");
    }
    if (options.threads < 0 || options.threads > 256)
    {
        throw std::runtime_error(std::to_string(options.threads) +
                                 " compressing threads are out of range: expected 0 to 256");
    }
    return options;
}
}  // namespace

std::string serialized(const mrpt::serialization::CSerializable& object)
{
    StringArchive archive;
    archive.WriteObject(object);
    return std::move(archive.bytes);
}

struct RawlogWriter::Impl
{
    Impl(const std::filesystem::path& path, const Options& o)
        : options(checked(o)), file(path, o.existing, o.unfinished)
    {
    }

    Options options;
    OutputFile file;
    std::string pending;                           // uncompressed, of the member to come
    std::deque<std::future<std::string>> members;  // being compressed, in the file's order
    bool empty = true;
    bool committed = false;
    std::exception_ptr failure;  // the file has a gap from here on: nothing more may follow

    /// Runs a step that writes; after a failed one every further one fails the same way.
    template <class Step>
    void guarded(Step&& step)
    {
        if (failure) std::rethrow_exception(failure);
        if (committed) throw std::logic_error("RawlogWriter: write after commit");
        try
        {
            step();
        }
        catch (...)
        {
            failure = std::current_exception();
            throw;
        }
    }

    void append(std::string_view bytes)
    {
        pending.append(bytes);
        empty = empty && bytes.empty();
        if (pending.size() >= options.memberBytes) endMember();
    }

    void endMember()
    {
        if (pending.empty()) return;
        if (options.gzLevel == 0)
        {
            file.write(pending);
            pending.clear();
            return;
        }
        const auto policy = options.threads > 0 ? std::launch::async : std::launch::deferred;
        members.push_back(std::async(policy,
                                     [bytes = std::exchange(pending, {}), level = options.gzLevel]
                                     { return gzMember(bytes, level); }));
        const auto inFlight = static_cast<std::size_t>(options.threads);
        while (members.size() > inFlight || isOldestDone()) writeOldestMember();
    }

    // What is compressed is written at once: a process that is killed loses the rest.
    bool isOldestDone() const
    {
        return !members.empty() &&
               members.front().wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }

    void writeOldestMember()
    {
        const std::string member = members.front().get();
        members.pop_front();
        file.write(member);
    }

    void flush()
    {
        endMember();
        while (!members.empty()) writeOldestMember();
    }

    void commit()
    {
        flush();
        // A gz file of no bytes at all is not a gz file.
        if (empty && options.gzLevel > 0) file.write(gzMember({}, options.gzLevel));
        file.commit();
        committed = true;
    }
};

RawlogWriter::RawlogWriter(const std::filesystem::path& path, const Options& options)
    : impl_(std::make_unique<Impl>(path, options))
{
}

RawlogWriter::~RawlogWriter()
{
    if (impl_->committed || impl_->options.unfinished != OutputFile::Unfinished::Keep) return;
    try
    {
        flush();
    }
    catch (const std::exception&)
    {
        // What reached the disk before still reads to its end; a destructor can say no more.
    }
}

void RawlogWriter::write(const mrpt::serialization::CSerializable& object)
{
    writeBytes(serialized(object));
}

void RawlogWriter::writeBytes(std::string_view serializedObjects)
{
    impl_->guarded([&] { impl_->append(serializedObjects); });
}

void RawlogWriter::endMember()
{
    impl_->guarded([&] { impl_->endMember(); });
}

void RawlogWriter::flush()
{
    impl_->guarded([&] { impl_->flush(); });
}

void RawlogWriter::commit()
{
    impl_->guarded([&] { impl_->commit(); });
}

void RawlogWriter::discard()
{
    impl_->options.unfinished = OutputFile::Unfinished::Discard;
    impl_->file.discard();
}

const std::filesystem::path& RawlogWriter::partialPath() const
{
    return impl_->file.partialPath();
}

}  // namespace vdamf
