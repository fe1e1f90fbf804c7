// Watched fields as time series in bounded memory; used by plots for drawing and export.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/fields.h"
#include "core/protocol/info_message.h"

namespace usar::widgets {

/// Drag format between the sensor panel and the plots: UTF-8 paths of fields as protocol::Field::path() returns them,
/// one per line.
inline constexpr const char* field_mime_type = "application/x-usar-field";

/// One value of a field.
struct Sample {
    double time_s = 0.0; ///< protocol clock
    double value = 0.0;  ///< SI units; NaN for a value that is not a number, which leaves a gap in the line
    bool operator==(const Sample&) const = default;
};

/// The samples of one watched field, in order of time. `dropped` counts samples removed from the front, so dropped +
/// samples.size() only grows and tells a view which samples are new. `history` changes when all samples were discarded.
struct Series {
    std::uint64_t history = 0;
    std::string path; ///< as protocol::Field::path() returns it, "SEN Sonar/F1/range"
    std::string unit; ///< unit of the samples; taken from the first one if not given
    std::deque<Sample> samples;
    std::uint64_t dropped = 0;
};

/// Stores values by protocol time. A value that is older than its predecessor is ignored; a clock that jumps back by
/// more than a second belongs to another run (a reconnect), so every series restarts. Owned by one view.
class SeriesStore {
public:
    static constexpr std::size_t default_capacity = 200'000; ///< samples per series: eleven hours at 5 Hz
    explicit SeriesStore(std::size_t capacity = default_capacity) : capacity_(capacity) {}

    /// Starts to watch a field; returns false if the path is empty or already watched.
    bool add(const std::string& path, const std::string& unit = {});
    /// Stops watching and discards the samples; returns false if the path was not watched.
    bool remove(const std::string& path);
    /// Stops watching all fields.
    void clear();
    /// Discards the samples of every series.
    void startAgain();
    /// `now` is used for messages without a time of their own. Returns true if the message contained a watched field.
    bool take(const protocol::InfoLine& line, Seconds now);

    /// In the order in which they were added.
    const std::vector<Series>& series() const { return series_; }
    /// Newest time of all series on the protocol clock; nullopt before the first sample.
    std::optional<double> newestTime_s() const { return newest_s_; }
    /// Oldest time of the stored samples of all series; nullopt if there are none.
    std::optional<double> oldestTime_s() const;

private:
    void append(Series& series, const protocol::Field& field, double time_s);

    std::size_t capacity_;
    std::vector<Series> series_;
    std::optional<double> newest_s_;
    std::uint64_t last_history_ = 0;
};

/// The newest value at this time on the protocol clock; nullopt before the first sample, and in a gap.
std::optional<double> valueAt(const Series& series, double time_s);

/// CSV with the head "time_s,SEN Sonar/F1/range [m],…" and one row for every time at which any series has a sample;
/// cells without a sample or with NaN are empty. Values are in SI units and read back to the same double.
std::string csvOf(const std::vector<Series>& series);

} // namespace usar::widgets
