// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/run_scene.h"

#include <gtest/gtest.h>
#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CText.h>

#include <fstream>

#include "files/temporary_folder.h"

namespace vdamf
{
namespace
{
class Scene : public TemporaryFolder
{
protected:
    static FrameResult resultAt(double time, const std::vector<std::uint64_t>& ids)
    {
        FrameResult result;
        result.time = time;
        for (const std::uint64_t id : ids)
        {
            TrackReport track;
            track.id = id;
            track.status = TrackStatus::Confirmed;
            track.box = {10.0 + time, static_cast<double>(id), 0.5, 4.0, 2.0};
            track.height = 1.5;
            result.tracks.push_back(track);
        }
        return result;
    }
    static LadarFrame frameAt(double time)
    {
        LadarFrame frame;
        frame.time = time;
        frame.origin = {100.0, 0.0, 0.0};
        frame.sensor = {100.0, time, 1.8};
        frame.points.x = {1.0F, 2.0F, std::nanf("")};
        frame.points.y = {0.0F, 0.0F, 0.0F};
        frame.points.z = {0.0F, 1.0F, 0.0F};
        return frame;
    }
};

TEST_F(Scene, IsReadByMrpt)
{
    RunScene run;
    run.add(frameAt(0.0), resultAt(0.0, {1, 2}));
    run.add(frameAt(1.0), resultAt(1.0, {1, 2, 3}));
    run.add(frameAt(2.0), resultAt(2.0, {1}));
    std::ofstream(at("run.3Dscene"), std::ios::binary) << run.bytes();
    mrpt::opengl::COpenGLScene scene;
    ASSERT_TRUE(scene.loadFromFile(at("run.3Dscene").string()));
    const auto hits = scene.getByClass<mrpt::opengl::CPointCloudColoured>();
    ASSERT_TRUE(hits);
    EXPECT_EQ(hits->size(), 2U) << "what is no number is left out";
    EXPECT_FLOAT_EQ(hits->getPoint3Df(1).x, 102.0F);
    const auto box = scene.getByClass<mrpt::opengl::CBox>();
    ASSERT_TRUE(box);
    EXPECT_NEAR(box->getPoseX(), 12.0, 1e-6) << "where the track was last";
    EXPECT_FALSE(scene.getByClass<mrpt::opengl::CBox>(1)) << "one track in the last frame";
    EXPECT_EQ(scene.getByClass<mrpt::opengl::CText>()->getString(), "1");
    // The sensor's way first, then those of the three tracks.
    EXPECT_EQ(scene.getByClass<mrpt::opengl::CSetOfLines>(0)->getLineCount(), 2U);
    EXPECT_EQ(scene.getByClass<mrpt::opengl::CSetOfLines>(1)->getLineCount(), 2U);
}

}  // namespace
}  // namespace vdamf
