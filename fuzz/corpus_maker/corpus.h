// SPDX-License-Identifier: BSD-3-Clause
// The inputs that fuzzing starts from, by target and name.
#pragma once

#include <map>
#include <string>

namespace vdamf::fuzz
{
/// Bytes by the path below fuzz/corpus, like "rawlog/gps".
using Corpus = std::map<std::string, std::string>;

/// rawlog, track and velodyne.
Corpus rawlogCorpus();
/// truth, tracks, evaluate, clusters, configuration, assignment and the files of KITTI.
Corpus textCorpus();
/// capture, pcd, ply, poses and annotations.
Corpus importCorpus();

}  // namespace vdamf::fuzz
