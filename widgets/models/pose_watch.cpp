#include "widgets/models/pose_watch.h"

#include "core/base/alternatives.h"
#include "core/protocol/wire_frame.h"

namespace usar::widgets {

namespace {

constexpr Seconds longest_span{1.2};
constexpr Seconds shortest_span{0.15};

} // namespace

void PoseWatch::take(const protocol::InfoMessage& message, Seconds at) {
    using protocol::anglesOf;
    std::visit(
        Overloaded{[&](const protocol::InsReading& ins) {
                       take(0, "INS", anglesOf(ins.base_in_map), ins.base_in_map.position_m, at);
                   },
                   [&](const protocol::GroundTruthReading& truth) {
                       take(1, "GroundTruth", anglesOf(truth.base_in_map), truth.base_in_map.position_m, at);
                   },
                   [&](const protocol::ImuReading& imu) {
                       if (imu.roll_pitch_yaw_rad)
                           take(2, "IMU", *imu.roll_pitch_yaw_rad, std::nullopt, at);
                   },
                   [&](const protocol::InuReading& inu) { take(3, "INU", inu.roll_pitch_yaw_rad, std::nullopt, at); },
                   [](const auto&) {}},
        message);
}

void PoseWatch::take(std::size_t rank, const char* type, const Vec3& roll_pitch_yaw_rad,
                     const std::optional<Vec3>& place_m, Seconds at) {
    Track& track = tracks_[rank];
    if (!track.source)
        track.source = PoseSource{.type = type};
    track.source->roll_pitch_yaw_rad = roll_pitch_yaw_rad;
    track.source->base_in_map_m = place_m;
    track.source->heard.arrived(at);
    if (!place_m)
        return;
    if (!track.first_z_m)
        track.first_z_m = place_m->z();
    if (!track.samples.empty() && !(at > track.samples.back().at)) // The clock went back, or stands still.
        track.samples.clear();
    track.samples.push_back({at, *place_m});
    while (track.samples.size() > 2 && at - track.samples.front().at > longest_span)
        track.samples.pop_front();
}

const PoseWatch::Track* PoseWatch::best(Seconds now, bool placed) const {
    const Track* latest = nullptr;
    for (const Track& track : tracks_) {
        if (!track.source || (placed && !track.source->base_in_map_m))
            continue;
        if (!track.source->heard.stale(now))
            return &track;
        if (!latest || track.source->heard.last > latest->source->heard.last)
            latest = &track;
    }
    return latest;
}

const PoseSource* PoseWatch::attitude(Seconds now) const {
    const Track* const track = best(now, false);
    return track ? &*track->source : nullptr;
}

const PoseSource* PoseWatch::place(Seconds now) const {
    const Track* const track = best(now, true);
    return track ? &*track->source : nullptr;
}

std::optional<Motion> PoseWatch::motion(Seconds now) const {
    const Track* const track = best(now, true);
    if (!track || track->samples.empty())
        return std::nullopt;
    const Sample& first = track->samples.front();
    const Sample& last = track->samples.back();
    const double span_s = (last.at - first.at).count();
    if (span_s < shortest_span.count())
        return std::nullopt;
    const Vec3 way_m = last.base_in_map_m - first.base_in_map_m;
    return Motion{way_m.head<2>().norm() / span_s, way_m.z() / span_s};
}

std::optional<double> PoseWatch::aboveStart_m(Seconds now) const {
    const Track* const track = best(now, true);
    if (!track)
        return std::nullopt;
    return track->source->base_in_map_m->z() - track->first_z_m.value_or(0.0);
}

} // namespace usar::widgets
