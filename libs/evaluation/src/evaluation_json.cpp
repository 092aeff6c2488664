// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/evaluation_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace vdamf
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double kDegrees = 180.0 / kPi;

/// Null for what is not finite: JSON has no word for it.
Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json number(const std::optional<double>& value)
{
    return value ? number(*value) : Json(nullptr);
}

Json statisticsJson(const ErrorStatistics& s, double unit = 1.0)
{
    if (s.count == 0)
    {
        return {{"count", 0},     {"median", nullptr}, {"p90", nullptr}, {"p95", nullptr},
                {"max", nullptr}, {"rms", nullptr},    {"bias", nullptr}};
    }
    return {{"count", s.count},
            {"median", number(unit * s.median)},
            {"p90", number(unit * s.p90)},
            {"p95", number(unit * s.p95)},
            {"max", number(unit * s.max)},
            {"rms", number(unit * s.rms)},
            {"bias", number(unit * s.bias)}};
}

Json errorsJson(const ErrorSummary& e)
{
    return {{"pairs", e.pairs},
            {"flips", e.flips},
            {"front_share", e.frontShare() ? number(*e.frontShare()) : Json(nullptr)},
            {"exchanged", e.exchanged},
            {"exchanged_though_sure", e.exchangedThoughSure},
            {"position_m", statisticsJson(e.position)},
            {"longitudinal_m", statisticsJson(e.longitudinal)},
            {"lateral_m", statisticsJson(e.lateral)},
            {"corner_m", statisticsJson(e.corner)},
            {"heading_deg", statisticsJson(e.heading, kDegrees)},
            {"heading_mod_180_deg", statisticsJson(e.headingAxis, kDegrees)},
            {"speed_mps", statisticsJson(e.speed)},
            {"yaw_rate_degps", statisticsJson(e.yawRate, kDegrees)},
            {"length_m", statisticsJson(e.length)},
            {"width_m", statisticsJson(e.width)},
            {"overlap", statisticsJson(e.overlap)}};
}

Json groupsJson(const std::vector<ErrorGroup>& groups)
{
    Json json = Json::object();
    for (const ErrorGroup& group : groups) json[group.name] = errorsJson(group.errors);
    return json;
}

Json consistencyJson(const Consistency& c)
{
    const bool any = c.count > 0;
    const auto value = [&](double v) { return any ? number(v) : Json(nullptr); };
    return {{"count", c.count},
            {"dimension", c.dimension},
            {"mean", value(c.mean)},
            {"mean_band_low", value(c.lowerBound)},
            {"mean_band_high", value(c.upperBound)},
            {"median", value(c.median)},
            {"within_68", value(c.within68)},
            {"within_95", value(c.within95)},
            {"within_99", value(c.within99)},
            {"covariance_scale", value(c.covarianceScale)},
            {"verdict", inWords(c)}};
}

Json optionsJson(const EvaluationOptions& options)
{
    const ScoringOptions& s = options.scoring;
    return {{"classes", s.classes},
            {"overlap", s.overlap},
            {"pair_overlap", options.pairOverlap},
            {"min_points", s.minPoints},
            {"max_range_m", s.maxRange > 0.0 ? Json(s.maxRange) : Json(nullptr)},
            {"region_fov_deg", s.regionFov > 0.0 ? Json(s.regionFov * kDegrees) : Json(nullptr)},
            {"tracked_span", options.trackedSpan},
            {"vehicles_only", s.onlyVehicles},
            {"with_tentative", s.withTentative},
            {"still_speed_mps", options.stillSpeed}};
}

Json countsJson(const EvaluatedCounts& c)
{
    return {{"frames", c.frames},
            {"duration_s", c.seconds},
            {"objects", c.objects},
            {"object_rows", c.objectRows},
            {"dont_care_rows", c.dontCareRows},
            {"track_rows", c.trackRows},
            {"has_vehicle_probability", c.hasProbability}};
}

Json clearMotJson(const Evaluation& e)
{
    const ClearMot& c = e.clearMot;
    return {{"mota", number(c.mota)},
            {"motp", number(c.motp)},
            {"motp_distance_m", number(c.motpDistance)},
            {"recall", number(c.recall)},
            {"precision", number(c.precision)},
            {"true_positives", c.truePositives},
            {"false_positives", c.falsePositives},
            {"false_negatives", c.falseNegatives},
            {"false_alarms_per_frame", number(e.counts.falseAlarmsPerFrame)},
            {"identity_switches", c.identitySwitches},
            {"fragmentations", c.fragmentations},
            {"mostly_tracked", c.mostlyTracked},
            {"partly_tracked", c.partlyTracked},
            {"mostly_lost", c.mostlyLost}};
}

Json hotaJson(const HotaScores& h)
{
    return {{"hota", number(h.hota)},    {"det_a", number(h.detA)},   {"ass_a", number(h.assA)},
            {"loc_a", number(h.locA)},   {"det_re", number(h.detRe)}, {"det_pr", number(h.detPr)},
            {"ass_re", number(h.assRe)}, {"ass_pr", number(h.assPr)}};
}

Json identityJson(const IdentityScore& i)
{
    return {{"idf1", number(i.idf1)},          {"id_precision", number(i.idPrecision)},
            {"id_recall", number(i.idRecall)}, {"id_true_positives", i.idtp},
            {"id_false_positives", i.idfp},    {"id_false_negatives", i.idfn}};
}

Json coverageJson(const Evaluation& e)
{
    const bool any = !e.objects.empty();
    return {{"ever_tracked", any ? number(e.coverage.everTracked) : Json(nullptr)},
            {"time_to_first_s", statisticsJson(e.coverage.timeToFirst)},
            {"longest_gap_s", statisticsJson(e.coverage.longestGap)}};
}

Json objectsJson(const std::vector<ObjectScore>& objects)
{
    Json json = Json::array();
    for (const ObjectScore& o : objects)
    {
        json.push_back({{"id", o.id},
                        {"class", o.objectClass},
                        {"frames", o.frames},
                        {"found", o.found},
                        {"tracks", o.tracks},
                        {"mean_overlap", o.found > 0 ? number(o.meanOverlap) : Json(nullptr)},
                        {"time_to_first_s", number(o.timeToFirst)},
                        {"longest_gap_s", number(o.longestGap)}});
    }
    return json;
}

Json rocJson(const std::optional<Roc>& roc)
{
    if (!roc) return nullptr;
    const auto withInterval = [&](auto member)
    {
        return Json{{"value", number(roc->scores.*member)},
                    {"low", number(roc->low.*member)},
                    {"high", number(roc->high.*member)}};
    };
    return {{"vehicle_samples", roc->vehicleSamples},
            {"clutter_samples", roc->clutterSamples},
            {"tracks", roc->tracks},
            {"area_under_curve", withInterval(&RocScores::areaUnderCurve)},
            {"equal_error_rate", withInterval(&RocScores::equalErrorRate)},
            {"miss_rate_at_fpr_1e-3", withInterval(&RocScores::missRateAtOnePerMille)},
            {"miss_rate_at_fpr_1e-2", withInterval(&RocScores::missRateAtOnePercent)}};
}
}  // namespace

std::string toJson(const Evaluation& e)
{
    const ConsistencyReport& c = e.consistency;
    const Json json = {{"options", optionsJson(e.options)},
                       {"scored", countsJson(e.counts)},
                       {"hota", hotaJson(e.hota)},
                       {"clear_mot", clearMotJson(e)},
                       {"identity", identityJson(e.identity)},
                       {"coverage", coverageJson(e)},
                       {"errors", errorsJson(e.errors)},
                       {"errors_by_range_m", groupsJson(e.errorsByRange)},
                       {"errors_by_points", groupsJson(e.errorsByPoints)},
                       {"errors_by_faces_seen", groupsJson(e.errorsByFaces)},
                       {"errors_by_length_sigma_cm", groupsJson(e.errorsByLengthSigma)},
                       {"flips_of_moving_objects", e.flipsOfMoving},
                       {"phantom_speed_mps", statisticsJson(e.phantomSpeed)},
                       {"standing_scatter_m", statisticsJson(e.standingScatter)},
                       {"consistency",
                        {{"nees_pose", consistencyJson(c.neesPose)},
                         {"nees_speed", consistencyJson(c.neesSpeed)},
                         {"nees_size", consistencyJson(c.neesSize)},
                         {"nis_of_tracks_on_objects", consistencyJson(c.nisMatched)},
                         {"nis_of_all_tracks", consistencyJson(c.nisAll)}}},
                       {"discriminator", rocJson(e.roc)},
                       {"objects", objectsJson(e.objects)}};
    // An id may hold any bytes; what is no UTF-8 must not end the job.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace vdamf
