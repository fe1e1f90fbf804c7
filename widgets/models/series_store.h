// Watched fields of robots as time series in bounded memory; used by plots for drawing and export.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/fields.h"
#include "core/protocol/info_message.h"
#include "widgets/models/plot/sample_history.h"

namespace usar::widgets {

/// Drag format between the sensor panel and the plots: UTF-8 paths of fields as protocol::Field::path() returns them,
/// one per line.
inline constexpr const char* field_mime_type = "application/x-usar-field";

/// Names a watched field: whose it is, and which one.
struct SeriesKey {
    std::string robot; ///< the robot's name; empty: a field that nobody owns, as before the first robot
    std::string path;  ///< as protocol::Field::path() returns it, "SEN Sonar/F1/range"
    auto operator<=>(const SeriesKey&) const = default;
};

/// The samples of one watched field, in order of time.
struct Series {
    SeriesKey key;
    std::string unit; ///< SI unit of the samples; taken from the first one if not given
    SampleHistory samples{};
};

/// Stores values by protocol time, for any number of robots. A value that is older than its predecessor is ignored; a
/// robot's clock that jumps back by more than a second belongs to another run (a reconnect), so its series restart.
/// Memory: at most that of a SampleHistory for each watched field. Owned by one model.
class SeriesStore {
public:
    /// `exact` and `digests`: limits of each SampleHistory.
    explicit SeriesStore(std::size_t exact = SampleHistory::default_exact,
                         std::size_t digests = SampleHistory::default_digests)
        : empty_(exact, digests) {}

    /// Starts to watch a field; returns false if the path is empty or the field already watched.
    bool add(const SeriesKey& key, const std::string& unit = {});
    /// Stops watching and discards the samples of all fields that are not in `keys`.
    void keepOnly(const std::vector<SeriesKey>& keys);
    /// Discards the samples of every series of this robot.
    void startAgain(const std::string& robot);
    /// Stores the watched values of a line of this robot. `now` is used for messages without a time of their own.
    /// Returns true if the message contained a watched field.
    bool take(const std::string& robot, const protocol::InfoLine& line, Seconds now);

    /// In the order in which they were added.
    const std::vector<Series>& series() const { return series_; }
    /// Returns nullptr if this field is not watched. Valid until the next `add` or `keepOnly`.
    const Series* find(const SeriesKey& key) const;
    /// Newest time of this robot on the protocol clock; nullopt before the first line with watched fields.
    std::optional<double> newestTime_s(const std::string& robot) const;

private:
    void append(Series& series, const protocol::Field& field, double time_s);

    SampleHistory empty_; ///< what each series begins with
    std::vector<Series> series_;
    std::map<std::string, double> newest_s_; ///< by robot
};

} // namespace usar::widgets
