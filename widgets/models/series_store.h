// Watched fields as time series in bounded memory: what plots draw and export, no painting.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/fields.h"
#include "core/protocol/info_message.h"

namespace usar::widgets {

struct Sample {
    double time_s = 0.0; ///< protocol clock
    double value = 0.0;  ///< SI; NaN where the server said something that is no number: a gap in the line
    bool operator==(const Sample&) const = default;
};

/// One watched field. Samples are in order of time; `dropped` counts those that fell off the front, so
/// dropped + samples.size() grows and tells a view what is new. `history` changes when all samples were thrown away.
struct Series {
    std::uint64_t history = 0;
    std::string path; ///< protocol::Field::path(), "SEN Sonar/F1/range"
    std::string unit; ///< of the samples; learned from the first one if not given
    std::deque<Sample> samples;
    std::uint64_t dropped = 0;
};

/// Values in protocol time. A value that is older than its predecessor is left out; a clock that jumps back by more
/// than a second belongs to another run (a reconnect), so every series starts again. Owned by one view.
class SeriesStore {
public:
    static constexpr std::size_t default_capacity = 200'000; ///< a series: eleven hours at 5 Hz
    explicit SeriesStore(std::size_t capacity = default_capacity) : capacity_(capacity) {}

    /// False where the path is empty or watched already.
    bool add(const std::string& path, const std::string& unit = {});
    /// False where it was not watched.
    bool remove(const std::string& path);
    /// Watches nothing any more.
    void clear();
    /// Every series starts again, empty.
    void startAgain();
    /// `now` stands in where the message has no time of its own. True if a watched field was in it.
    bool take(const protocol::InfoLine& line, Seconds now);

    /// In the order in which they were added.
    const std::vector<Series>& series() const { return series_; }
    /// Over all series, protocol clock; nothing before the first sample.
    std::optional<double> newestTime_s() const { return newest_s_; }
    std::optional<double> oldestTime_s() const;

private:
    void append(Series& series, const protocol::Field& field, double time_s);

    std::size_t capacity_;
    std::vector<Series> series_;
    std::optional<double> newest_s_;
    std::uint64_t last_history_ = 0;
};

/// "time_s,SEN Sonar/F1/range [m],…": one row for every time at which any series has a sample, empty where it has
/// none; SI values that read back to the same double.
std::string csvOf(const std::vector<Series>& series);

} // namespace usar::widgets
