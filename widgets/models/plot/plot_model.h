// What the plots show: their layout, the samples of its series, the selected robot, and the cursors.
#pragma once

#include <limits>
#include <set>

#include "widgets/models/plot/plot_cursors.h"
#include "widgets/models/plot/plot_layout.h"
#include "widgets/models/series_store.h"

namespace usar::widgets {

/// A series that is drawn.
struct ShownSeries {
    SeriesKey key;                  ///< after remapping: the robot whose values are drawn
    const Series* series = nullptr; ///< never null; valid until the model changes
    std::size_t canvas = 0;         ///< from the top
    int color = 0;                  ///< counts through all canvases
};

/// Decides which samples are recorded and which are shown. A series of the layout belongs to the robot that it was
/// taken from; while the layout follows the selected robot, the same field of that robot is shown in its place. Then
/// the field is recorded for every robot that speaks, so that another selection has its past at once; so memory is
/// bounded by that of one SampleHistory for each robot and field. Owned by the view, GUI thread.
class PlotModel {
public:
    explicit PlotModel(SeriesStore store = SeriesStore()) : store_(std::move(store)) {}

    const PlotLayout& layout() const { return layout_; }
    void setLayout(PlotLayout layout);
    /// Plots a field of the selected robot; returns false if the path is empty or already shown on this canvas.
    bool add(std::size_t canvas, const std::string& path, const std::string& unit = {});
    /// Removes what is shown as `key` on this canvas; returns false if nothing is.
    bool remove(std::size_t canvas, const SeriesKey& key);
    /// Removes all series; the canvases remain.
    void clear();
    /// Adds a canvas below all others; returns false if there are as many as possible.
    bool addCanvas();
    /// Removes a canvas and its series; returns false for the only one.
    bool removeCanvas(std::size_t canvas);
    void setFollowRobot(bool follow);
    void setStatistics(bool on) { layout_.statistics = on; }
    void setWindow(double seconds) { layout_.window_s = seconds; }

    /// The robot that is selected now; empty: none.
    void setRobot(const std::string& robot);
    const std::string& robot() const { return robot_; }
    /// Discards the samples of this robot.
    void restart(const std::string& robot) { store_.startAgain(robot); }
    /// The robot is gone: what was recorded only for the case that it gets selected is discarded.
    void forget(const std::string& robot);
    /// Records a line; returns true if something that is shown has changed.
    bool take(const std::string& robot, const protocol::InfoLine& line, Seconds now);
    const SeriesStore& store() const { return store_; }

    /// The series of all canvases in the order of the layout, on each canvas each once.
    std::vector<ShownSeries> shown() const;
    bool empty() const;
    /// Newest and oldest time of what is shown, on the protocol clock; nullopt before the first sample.
    std::optional<double> newest_s() const;
    std::optional<double> oldest_s() const;
    /// Freezes what is shown at the newest time, while recording continues; or shows the present again.
    void setFrozen(bool frozen);
    /// Nothing after this time is shown; infinity unless frozen.
    double shownUntil_s() const { return until_s_; }

    PlotCursors& cursors() { return cursors_; }
    const PlotCursors& cursors() const { return cursors_; }
    /// Figures of a series between the cursors if both are set, otherwise between these times.
    Statistics statistics(const Series& series, double from_s, double to_s) const;

private:
    /// The field that is shown for this entry of the layout.
    SeriesKey keyOf(const PlotSeries& entry) const;
    /// Watches what the layout needs, and nothing else.
    void watch();

    PlotLayout layout_;
    SeriesStore store_;
    std::set<std::string> robots_; ///< all that have spoken
    std::string robot_;
    PlotCursors cursors_;
    double until_s_ = std::numeric_limits<double>::infinity();
};

} // namespace usar::widgets
