// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/tracker/tracker.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tracker/track.h"
#include "vdamf/tracking/estimation/occlusion.h"
#include "vdamf/tracking/preprocessing/range_profile.h"

namespace vdamf
{
namespace
{
// Height of the highest hit above the local ground, m.
double heightOf(const Cluster& cluster)
{
    if (cluster.height.empty()) return 0.0;
    return *std::max_element(cluster.height.begin(), cluster.height.end());
}

// Local ground below clusters and the height of their highest hit above it.
void addHeights(Sighting& sighting, const std::vector<const Cluster*>& clusters, double originZ)
{
    double ground = 0.0;
    double count = 0.0;
    for (const Cluster* cluster : clusters)
    {
        for (std::size_t i = 0; i < cluster->size(); ++i)
            ground += cluster->z[i] - cluster->height[i];
        sighting.height = std::max(sighting.height, heightOf(*cluster));
        count += static_cast<double>(cluster->size());
    }
    sighting.groundZ = originZ + (count > 0.0 ? ground / count : 0.0);
}

Measurement inWorld(Measurement m, const Eigen::Vector3d& origin)
{
    m.box.x += origin.x();
    m.box.y += origin.y();
    return m;
}

OrientedBox relativeTo(OrientedBox box, const Eigen::Vector3d& origin)
{
    box.x -= origin.x();
    box.y -= origin.y();
    return box;
}
}  // namespace

class Tracker::Impl
{
public:
    explicit Impl(const TrackerOptions& options) : options_(options), filter_(options.motion) {}

    FrameResult process(const LadarFrame& frame)
    {
        if (time_ && frame.time <= *time_)
            throw std::invalid_argument("frames must come in order of time");
        enter(Stage::Ground);
        const AboveGround above = removeGround(frame, options_.ground);
        profile_ = rangeProfile(frame, above);
        enter(Stage::Clustering);
        const std::vector<Cluster> clusters = clusterPoints(frame, above, options_.clustering);
        std::vector<Hits> hits;
        hits.reserve(clusters.size());
        for (const Cluster& c : clusters)
            hits.push_back(projectHits(c, options_.measurement.mergeCell));
        enter(Stage::Prediction);
        predictTracks(frame.time);
        enter(Stage::Association);
        const auto assignment = assignClusters(targets(frame.origin), hits, options_.association);
        enter(Stage::Measurement);
        const auto sightings = measureTracks(frame, clusters, hits, assignment);
        enter(Stage::Update);
        updateTracks(frame.time, sightings);
        enter(Stage::NewTracks);
        startTracks(frame, clusters, hits, assignment);
        removeDuplicates();
        FrameResult result = reportFrame(frame, above, clusters);
        removeEnded();
        if (observer_) observer_(nullptr);
        return result;
    }

    std::function<void(const Stage*)> observer_;

private:
    void enter(Stage stage) const
    {
        if (observer_) observer_(&stage);
    }

    void predictTracks(double time)
    {
        const double dt = time_ ? time - *time_ : 0.0;
        time_ = time;
        for (Track& track : tracks_)
        {
            track.state = filter_.predict(track.state, dt, track.size.length.mean);
            track.measurement.reset();
            track.nis.reset();
        }
    }

    std::vector<PredictedTarget> targets(const Eigen::Vector3d& origin) const
    {
        std::vector<PredictedTarget> all;
        all.reserve(tracks_.size());
        for (const Track& track : tracks_)
        {
            all.push_back({relativeTo(track.box(), origin), positionSigma(track),
                           std::sqrt(track.size.length.variance),
                           std::sqrt(track.size.width.variance)});
        }
        return all;
    }

    std::vector<std::optional<Sighting>> measureTracks(
        const LadarFrame& frame, const std::vector<Cluster>& clusters,
        const std::vector<Hits>& hits,
        const std::vector<std::vector<std::size_t>>& assignment) const
    {
        std::vector<std::optional<Sighting>> sightings(tracks_.size());
        for (std::size_t j = 0; j < tracks_.size(); ++j)
        {
            if (assignment[j].empty()) continue;
            Hits all = hits[assignment[j].front()];
            std::vector<const Cluster*> parts{&clusters[assignment[j].front()]};
            for (std::size_t k = 1; k < assignment[j].size(); ++k)
            {
                all = joined(all, hits[assignment[j][k]]);
                parts.push_back(&clusters[assignment[j][k]]);
            }
            sightings[j] = sightingOf(tracks_[j], frame, all, parts);
        }
        return sightings;
    }

    // From the predicted pose; where that is vague, or explains the hits much worse than before,
    // also from where the hits are. The better response wins.
    Sighting sightingOf(const Track& track, const LadarFrame& frame, const Hits& hits,
                        const std::vector<const Cluster*>& parts) const
    {
        constexpr double kVague = 0.3;      // m
        constexpr double kPoorMatch = 0.6;  // of the last one
        const OrientedBox start = relativeTo(track.box(), frame.origin);
        const Eigen::Vector2d size(start.length, start.width);
        Sighting best = sighting(frame, hits, parts, start, size);
        if (positionSigma(track) < kVague && best.measurement.match > kPoorMatch * track.lastMatch)
            return best;
        const Eigen::Vector2d sensor = (frame.sensor - frame.origin).head<2>();
        Sighting other = sighting(frame, hits, parts, movedOntoHits(start, hits, sensor), size);
        return other.measurement.match > best.measurement.match ? other : best;
    }

    static double positionSigma(const Track& track)
    {
        return std::sqrt(0.5 * track.state.covariance.topLeftCorner<2, 2>().trace());
    }

    Sighting sighting(const LadarFrame& frame, const Hits& hits,
                      const std::vector<const Cluster*>& parts, const OrientedBox& start,
                      const std::optional<Eigen::Vector2d>& knownSize) const
    {
        const Eigen::Vector2d sensor = (frame.sensor - frame.origin).head<2>();
        Sighting s;
        s.time = frame.time;
        s.sensor = frame.sensor.head<2>();
        Measurement m = measureTarget(hits, sensor, start, options_.measurement, knownSize);
        m.hiddenEnds = hiddenEnds(m.box, m.facesSeen, sensor, profile_);
        s.measurement = inWorld(m, frame.origin);
        addHeights(s, parts, frame.origin.z());
        return s;
    }

    void updateTracks(double time, const std::vector<std::optional<Sighting>>& sightings)
    {
        for (std::size_t j = 0; j < tracks_.size(); ++j)
        {
            Track& track = tracks_[j];
            if (sightings[j])
                track = sightedTrack(track, *sightings[j], filter_, options_);
            else
                miss(track, time);
        }
    }

    void miss(Track& track, double time) const
    {
        ++track.misses;
        const LifecycleOptions& o = options_.lifecycle;
        if (track.status == TrackStatus::Confirmed) track.status = TrackStatus::Coasting;
        const bool lost = track.status == TrackStatus::Tentative
                              ? track.misses >= o.tentativeMisses
                              : time - track.lastSeen > o.maxCoast;
        if (lost) track.status = TrackStatus::Ended;
    }

    void startTracks(const LadarFrame& frame, const std::vector<Cluster>& clusters,
                     const std::vector<Hits>& hits,
                     const std::vector<std::vector<std::size_t>>& assignment)
    {
        std::vector<bool> claimed(clusters.size(), false);
        for (const auto& taken : assignment)
            for (const std::size_t i : taken) claimed[i] = true;
        const Eigen::Vector2d sensor = (frame.sensor - frame.origin).head<2>();
        for (std::size_t i = 0; i < clusters.size(); ++i)
        {
            if (claimed[i] || !mayStart(clusters[i], hits[i])) continue;
            const OrientedBox start = startBox(hits[i], sensor, widestEnd(heightOf(clusters[i])),
                                               options_.measurement.fit);
            if (std::hypot(start.length, start.width) > options_.lifecycle.maxExtent) continue;
            const Sighting s = sighting(frame, hits[i], {&clusters[i]}, start, std::nullopt);
            tracks_.push_back(startedTrack(nextId_++, s, options_));
        }
    }

    bool mayStart(const Cluster& cluster, const Hits& hits) const
    {
        const LifecycleOptions& o = options_.lifecycle;
        if (hits.totalWeight < o.minHits) return false;
        return heightOf(cluster) >= o.minHeight;
    }

    // Two tracks on one object: the older one stays.
    void removeDuplicates()
    {
        for (std::size_t j = 1; j < tracks_.size(); ++j)
        {
            for (std::size_t k = 0; k < j; ++k)
            {
                if (tracks_[k].status == TrackStatus::Ended || !sameObject(tracks_[k], tracks_[j]))
                    continue;
                const bool keepOlder = tracks_[k].misses <= tracks_[j].misses;
                (keepOlder ? tracks_[j] : tracks_[k]).status = TrackStatus::Ended;
                if (keepOlder) break;
            }
        }
    }

    static bool sameObject(const Track& a, const Track& b)
    {
        const Eigen::Vector2d inA = toBoxFrame(a.box(), b.state.mean.head<2>());
        const Eigen::Vector2d inB = toBoxFrame(b.box(), a.state.mean.head<2>());
        const auto inside = [](const Eigen::Vector2d& p, const SizeMemory& size) {
            return std::abs(p.x()) < 0.4 * size.length.mean &&
                   std::abs(p.y()) < 0.4 * size.width.mean;
        };
        return inside(inA, a.size) || inside(inB, b.size);
    }

    FrameResult reportFrame(const LadarFrame& frame, const AboveGround& above,
                            const std::vector<Cluster>& clusters) const
    {
        FrameResult result;
        result.time = frame.time;
        result.points = frame.points.size();
        result.pointsAboveGround = above.index.size();
        result.clusters = clusters.size();
        for (const Track& track : tracks_) result.tracks.push_back(reportOf(track));
        return result;
    }

    void removeEnded()
    {
        tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(),
                                     [](const Track& t) { return t.status == TrackStatus::Ended; }),
                      tracks_.end());
    }

    TrackerOptions options_;
    VehicleKalmanFilter filter_;
    std::vector<Track> tracks_;  // by rising id
    RangeProfile profile_;       // of the current frame
    std::uint64_t nextId_ = 1;
    std::optional<double> time_;
};

Tracker::Tracker(const TrackerOptions& options)
{
    const std::vector<std::string> problems = options.problems();
    if (!problems.empty())
    {
        std::string text = "bad tracker options:";
        for (const std::string& p : problems) text += "\n  " + p;
        throw std::invalid_argument(text);
    }
    impl_ = std::make_unique<Impl>(options);
}
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

FrameResult Tracker::process(const LadarFrame& frame)
{
    return impl_->process(frame);
}

void Tracker::onStage(std::function<void(const Stage*)> observer)
{
    impl_->observer_ = std::move(observer);
}

}  // namespace vdamf
