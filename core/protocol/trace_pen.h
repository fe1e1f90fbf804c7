// Decides when a robot under TRACE leaves its next mark (protocol.md 5.6).
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/protocol/commands/trace.h"

namespace usar::protocol {

/// The trace state of one robot. The simulated server that keeps the marks and the client that draws them share it.
class TracePen {
public:
    static constexpr double least_way_m = 0.028;  ///< 7 Unreal units
    static constexpr Seconds usual_interval{0.5}; ///< our choice; no source gives the game's

    /// Executes a TRACE command. Interval and color keep their values if the command leaves them out.
    void obey(const Trace& wanted) {
        on_ = wanted.on;
        interval_ = wanted.interval.value_or(interval_);
        color_ = wanted.color.value_or(color_);
        last_.reset();
    }
    bool on() const { return on_; }
    TraceColor color() const { return color_; }
    /// The color of the mark to leave at this position in the map frame; nullopt while tracing is off, or too soon
    /// after or too near to the previous mark. `now` is on the server's clock; if it has gone back, a mark is due.
    std::optional<TraceColor> markAt(Seconds now, const Vec3& position_m) {
        if (!on_ || !position_m.allFinite())
            return std::nullopt;
        constexpr Seconds rounding{1e-6};
        const bool clock_restarted = last_ && now < last_->time;
        if (last_ && !clock_restarted &&
            (now - last_->time < interval_ - rounding || (position_m - last_->position_m).norm() <= least_way_m))
            return std::nullopt;
        last_ = {now, position_m};
        return color_;
    }

private:
    /// The mark that was left last.
    struct Mark {
        Seconds time{0.0};
        Vec3 position_m = Vec3::Zero();
    };
    bool on_ = false;
    Seconds interval_ = usual_interval;
    TraceColor color_ = TraceColor::Red;
    std::optional<Mark> last_;
};

} // namespace usar::protocol
