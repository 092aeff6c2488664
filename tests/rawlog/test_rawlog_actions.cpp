// SPDX-License-Identifier: BSD-3-Clause
// Actions go through the reader as they are, also those on which MRPT's parser would crash.
#include <gmock/gmock.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>

#include <random>

#include "../files/temporary_folder.h"
#include "example_objects.h"

namespace vdamf
{
namespace
{
using Kind = RawlogEntry::Kind;
using Movement = mrpt::obs::CActionRobotMovement2D;

class RawlogActions : public TemporaryFolder
{
protected:
    std::vector<RawlogEntry> read(const std::string& bytes)
    {
        RawlogReader reader(make("actions.rawlog", bytes));
        std::vector<RawlogEntry> entries = test::entriesOf(reader);
        summary_ = reader.summary();
        EXPECT_TRUE(bytes == test::concatenated(entries));
        return entries;
    }

    RawlogSummary summary_;
};

std::vector<Kind> kindsOf(const std::vector<RawlogEntry>& entries)
{
    std::vector<Kind> kinds;
    for (const RawlogEntry& entry : entries) kinds.push_back(entry.kind);
    return kinds;
}

Movement movement()
{
    Movement::TMotionModelOptions model;
    model.modelSelection = Movement::mmThrun;
    model.thrunModel.nParticlesCount = 40;
    Movement action;
    action.timestamp = mrpt::Clock::fromDouble(1.5e9);
    action.computeFromOdometry(mrpt::poses::CPose2D(0.3, 0.0, 0.02), model);
    return action;
}

std::string collection(int movements)
{
    mrpt::obs::CActionCollection actions;
    Movement action = movement();
    mrpt::obs::CActionRobotMovement3D inSpace;
    for (int i = 0; i < movements; ++i) actions.insert(action);
    if (movements > 1) actions.insert(inSpace);
    return serialized(actions);
}

// One flipped bit says that a distribution of the pose follows: MRPT's parser (2.5.8) goes on with
// the null pointer that it reads instead.
std::string deadlyCollection()
{
    static const std::string kName = "CActionRobotMovement2D";
    constexpr std::size_t kVersionBytes = 1;
    std::string bytes = collection(1);
    const std::size_t method = bytes.find(kName) + kName.size() + kVersionBytes;
    EXPECT_EQ(bytes[method], '\0');
    bytes[method] = '\1';
    return bytes;
}

TEST_F(RawlogActions, StandBetweenAllKindsOfEntries)
{
    const std::string cloud = serialized(test::pointCloud(20));
    const auto entries =
        read(serialized(movement()) + cloud + collection(0) + collection(2) + test::nullObject() +
             collection(1) + test::unknownObject("a::Class", "payload") + serialized(movement()) +
             cloud + collection(3));
    EXPECT_EQ(kindsOf(entries),
              (std::vector<Kind>{Kind::Action, Kind::Object, Kind::Action, Kind::Action, Kind::Null,
                                 Kind::Action, Kind::Unknown, Kind::Object, Kind::Action}));
    EXPECT_TRUE(entries[3].bytes == collection(2));
    EXPECT_FALSE(entries[3].object);
    EXPECT_EQ(summary_.objects, 7U);
    EXPECT_FALSE(summary_.truncated) << summary_.truncation;
}

TEST_F(RawlogActions, DoNotReachTheParser)
{
    const std::string cloud = serialized(test::pointCloud(20));
    const auto entries = read(deadlyCollection() + cloud);
    EXPECT_EQ(kindsOf(entries), (std::vector<Kind>{Kind::Action, Kind::Object}));
    EXPECT_TRUE(entries[0].bytes == deadlyCollection());
}

TEST_F(RawlogActions, CutOnesAreTold)
{
    const std::string whole = collection(2);
    for (const std::size_t kept : {whole.size() - 1, whole.size() - 2, whole.size() / 2})
    {
        const auto entries = read(collection(1) + whole.substr(0, kept));
        EXPECT_EQ(kindsOf(entries), (std::vector<Kind>{Kind::Action, Kind::Damaged})) << kept;
        EXPECT_TRUE(summary_.truncated);
        EXPECT_THAT(summary_.truncation, testing::HasSubstr("CActionCollection"));
    }
    // One with a hole before the next entry.
    const std::string cloud = serialized(test::pointCloud(20));
    const auto entries = read(whole.substr(0, whole.size() / 2) + cloud);
    EXPECT_EQ(kindsOf(entries), (std::vector<Kind>{Kind::Damaged, Kind::Object}));
    EXPECT_FALSE(summary_.truncated);
}

TEST_F(RawlogActions, CorruptOnesDoNoHarm)
{
    const std::string cloud = serialized(test::pointCloud(20));
    std::mt19937 random(20251);
    int clouds = 0;
    constexpr int kFiles = 400;
    for (int i = 0; i < kFiles; ++i)
    {
        std::string actions = collection(1);
        for (int wounds = 0; wounds < 6; ++wounds)
            actions[random() % actions.size()] = static_cast<char>(random() % 4);
        // An end that is hit may take the entry behind along; never the one after it.
        for (const RawlogEntry& entry : read(cloud + actions + cloud + cloud))
            clouds += entry.kind == Kind::Object ? 1 : 0;
    }
    EXPECT_GE(clouds, 3 * kFiles - 3);
}

}  // namespace
}  // namespace vdamf
