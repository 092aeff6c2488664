// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/tracker/tracker.h"

#include <algorithm>
#include <utility>

#include "association/loose_hits.h"
#include "tracker/alignment.h"
#include "tracker/attention.h"
#include "tracker/bad_input.h"
#include "tracker/discriminate.h"
#include "tracker/duplicates.h"
#include "tracker/existence.h"
#include "tracker/expected_sighting.h"
#include "tracker/glance.h"
#include "tracker/loose_clusters.h"
#include "tracker/neighbourhood.h"
#include "tracker/new_sightings.h"
#include "tracker/out_of_sight.h"
#include "tracker/predicted_targets.h"
#include "tracker/segmentation.h"
#include "tracker/shared_cut.h"
#include "tracker/track.h"
#include "tracker/type_filters.h"
#include "tracker/vehicle_cut.h"
#include "tracker/worker_pool.h"

namespace vdamf
{
// By track: its clusters, and what they show of it.
using Assignment = std::vector<std::vector<std::size_t>>;
using Sightings = std::vector<std::optional<Sighting>>;

class Tracker::Impl
{
public:
    explicit Impl(const TrackerOptions& options)
        : options_(checked(options)),
          workers_(options.execution.threads),
          discriminator_(options.discriminator),
          typeFilters_(options.measurement),
          alignment_(options.alignment),
          outOfSight_(options.lifecycle.maxCoast)
    {
        for (std::size_t k = 0; k < workers_.size(); ++k) filters_.emplace_back(options.motion);
    }

    FrameResult process(const LadarFrame& frame)
    {
        refuseBad(frame, time_);
        try
        {
            return tracked(frame);
        }
        catch (...)
        {
            tracks_.clear();  // any of them may be half of what it was
            outOfSight_ = OutOfSight(options_.lifecycle.maxCoast);
            throw;
        }
    }

    std::function<void(const Stage*)> observer_;

private:
    FrameResult tracked(const LadarFrame& frame)
    {
        const FieldOfView view(frame);
        enter(Stage::Ground);
        const AboveGround above = removeGround(frame, options_.ground);
        enter(Stage::Clustering);
        SegmentedFrame segmented = segmentedFrame(frame, above, view, options_.clustering);
        enter(Stage::Prediction);
        std::vector<TrackReport> lost = lostOverGap(frame.time);
        predictTracks(frame);
        enter(Stage::Association);
        const auto targets = [this]
        { return predictedTargets(tracks_, discriminator_, interval_, options_.lifecycle); };
        std::vector<PredictedTarget> predicted = targets();
        Neighbourhood around(tracks_, discriminator_);
        segmented = withVehiclesCutOut(std::move(segmented), predicted, tracks_, around,
                                       discriminator_, options_);
        segmented = withHits(std::move(segmented), options_.measurement, workers_);
        segmented = withSharedClustersCut(std::move(segmented), predicted, options_);
        auto assignment =
            assignClusters(predicted, segmented.hits, options_.association, segmented.isVehicle);
        assignment = withLooseHits(std::move(assignment), segmented, predicted, options_);
        enter(Stage::Measurement);
        auto sightings = measureTracks(segmented, assignment);
        enter(Stage::Update);
        if (followPlatform(sightings))
        {
            predicted = targets();
            around = Neighbourhood(tracks_, discriminator_);
        }
        updateTracks(segmented, view, assignment, std::move(sightings), predicted, around);
        enter(Stage::NewTracks);
        assignment = startTracks(segmented, std::move(assignment));
        enter(Stage::Discrimination);
        judgeTracks(segmented, assignment);
        const std::vector<OrientedBox> extents = discriminator_.extentsOf(tracks_);
        tracks_ = withDuplicatesEnded(std::move(tracks_), extents);
        tracks_ = outOfSight_.withReturns(std::move(tracks_), frame.time);
        FrameResult result = reportFrame(frame, segmented, std::move(lost));
        tracks_ = withoutEnded(std::move(tracks_));
        if (observer_) observer_(nullptr);
        return result;
    }

    void enter(Stage stage) const
    {
        if (observer_) observer_(&stage);
    }

    // Nothing is known again after longer than any vehicle is waited for: all end as they were.
    std::vector<TrackReport> lostOverGap(double time)
    {
        constexpr double kSlowest = 2.0;  // s between the frames of slow sensors
        std::vector<TrackReport> lost;
        if (!time_ || time - *time_ <= std::max(kSlowest, options_.lifecycle.maxCoast)) return lost;
        for (Track& before : std::exchange(tracks_, {}))
        {
            Track track = withoutSighting(std::move(before));
            track.status = TrackStatus::Ended;
            lost.push_back(reportAt(origin_, track));
        }
        return lost;
    }

    // Also to where the frame's numbers begin, at the vehicle: so all that is kept has small
    // numbers, which are the same however far from the world's origin it drives.
    void predictTracks(const LadarFrame& frame)
    {
        const double dt = time_ ? frame.time - *time_ : 0.0;
        interval_ = dt;
        const Eigen::Vector3d moved = origin_ - frame.origin;
        alignment_.goOn(-moved.head<2>(), frame.time);
        outOfSight_.moveBy(moved);
        time_ = frame.time;
        origin_ = frame.origin;
        const Eigen::Vector2d sensor = (frame.sensor - frame.origin).head<2>();
        workers_.forEach(tracks_.size(),
                         [&](std::size_t j, std::size_t worker)
                         {
                             tracks_[j] = predictedTrack(movedBy(std::move(tracks_[j]), moved), dt,
                                                         sensor, filters_[worker], options_.motion);
                         });
    }

    Sightings measureTracks(const SegmentedFrame& frame, const Assignment& assignment)
    {
        Sightings sightings(tracks_.size());
        workers_.forEach(
            tracks_.size(),
            [&](std::size_t j, std::size_t)
            {
                const std::vector<std::size_t>& clusters = assignment[j];
                if (!clusters.empty() && !isGlanceEnough(tracks_[j], frame, clusters,
                                                         discriminator_, options_.discriminator))
                    sightings[j] = expectedSighting(
                        tracks_[j], frame, clusters, typeFilters_.optionsFor(tracks_[j]),
                        attentionFor(tracks_[j], discriminator_), options_.motion);
            });
        return sightings;
    }

    // Where the platform's pose errs, tracks go with it, and are told where they were; what is not
    // known of its error is in all that is measured. Whether it errs.
    bool followPlatform(Sightings& sightings)
    {
        const auto platform = alignment_.motionOf(tracks_, sightings, options_.visibility);
        if (!platform) return false;
        for (Track& track : tracks_) track = movedBy(std::move(track), platform->motion);
        outOfSight_.moveBy(platform->motion);
        for (std::optional<Sighting>& sighting : sightings)
        {
            if (!sighting) continue;
            Measurement& m = sighting->measurement;
            const Eigen::Matrix3d j = byMotion(m.box.centre());
            m.covariance.topLeftCorner<3, 3>() += j * platform->covariance * j.transpose();
        }
        return true;
    }

    void updateTracks(const SegmentedFrame& frame, const FieldOfView& field,
                      const Assignment& assignment, Sightings sightings,
                      const std::vector<PredictedTarget>& predicted, const Neighbourhood& around)
    {
        const OpenView view{frame.time, frame.sensor, frame.profile, field};
        workers_.forEach(
            tracks_.size(),
            [&](std::size_t j, std::size_t worker)
            {
                Track& track = tracks_[j];
                if (sightings[j])
                {
                    const Sighting seen =
                        track.stood() ? withHeadingOfNeighbours(std::move(*sightings[j]), around,
                                                                track.id, &track.state)
                                      : std::move(*sightings[j]);
                    track = typeFilters_.judged(
                        sightedTrack(std::move(track), seen, around, filters_[worker], options_),
                        seen);
                }
                else if (!assignment[j].empty())
                    track =
                        glancedTrack(std::move(track), frame, assignment[j], options_.lifecycle);
                else
                {
                    const Unseen known = unseen(track, predicted[j], frame);
                    track = withMiss(std::move(track), view, known, options_.lifecycle);
                }
            });
    }

    Unseen unseen(const Track& track, const PredictedTarget& at, const SegmentedFrame& frame) const
    {
        return {!discriminator_.rulesOut(track),
                track.stood() && anyLiesOn(at, frame.loose, frame.sensor, options_.association)};
    }

    Assignment startTracks(const SegmentedFrame& frame, Assignment assignment)
    {
        std::vector<bool> claimed(frame.clusters.size(), false);
        for (const auto& taken : assignment)
            for (const std::size_t i : taken) claimed[i] = true;
        const StartSpeed speed{0.0, options_.lifecycle.startSpeedSigma};
        const Neighbourhood around(tracks_, discriminator_);
        for (const Sighting& s : newSightings(frame, claimed, around, options_, workers_))
        {
            tracks_.push_back(typeFilters_.judged(startedTrack(nextId_++, s, speed, options_), s));
            assignment.push_back(s.clusters);
        }
        return assignment;
    }

    void judgeTracks(const SegmentedFrame& frame, const Assignment& assignment)
    {
        workers_.forEach(tracks_.size(),
                         [&](std::size_t j, std::size_t)
                         {
                             Track& track = tracks_[j];
                             track.judgement = discriminator_.judged(track, frame, assignment[j]);
                             if (track.misses == 0)
                                 track = withConfirmation(std::move(track), options_.lifecycle);
                         });
    }

    TrackReport reportAt(const Eigen::Vector3d& origin, const Track& track) const
    {
        const OrientedBox extent = discriminator_.extentOf(track);
        const TrackReport report = reportOf(track, extent, options_.visibility, origin);
        return alignment_.aligned(discriminator_.withProbability(report, track), origin.head<2>());
    }

    // `tracks`: reports that come first, of tracks that are no more.
    FrameResult reportFrame(const LadarFrame& frame, const SegmentedFrame& segmented,
                            std::vector<TrackReport> tracks) const
    {
        FrameResult result;
        result.time = frame.time;
        result.points = frame.points.size();
        result.pointsAboveGround = segmented.pointsAboveGround;
        result.clusters = segmented.clusters.size();
        result.alignment = alignment_.inWorld(frame.origin.head<2>());
        result.tracks = std::move(tracks);
        for (const Track& track : tracks_) result.tracks.push_back(reportAt(frame.origin, track));
        return result;
    }

    TrackerOptions options_;
    WorkerPool workers_;
    std::vector<VehicleKalmanFilter> filters_;  // of each worker
    Discriminator discriminator_;
    TypeFilters typeFilters_;
    Alignment alignment_;
    OutOfSight outOfSight_;
    std::vector<Track> tracks_;  // by rising id
    std::uint64_t nextId_ = 1;
    std::optional<double> time_;
    double interval_ = 0.0;                             // between the last two frames, s
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  // of the last frame
};

Tracker::Tracker(const TrackerOptions& options) : impl_(std::make_unique<Impl>(options)) {}
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
