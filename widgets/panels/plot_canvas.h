// Drawing surface of the plots: canvases below one another over one axis of protocol time, with two cursors.
#pragma once

#include <memory>
#include <set>
#include <vector>

#include <QPixmap>
#include <QWidget>

#include "widgets/models/plot/plot_model.h"
#include "widgets/panels/plot_pane.h"
#include "widgets/style/theme.h"

class QCPItemStraightLine;
class QCPItemText;
class QCPMarginGroup;
class QCPRange;
class QMouseEvent;

namespace usar::widgets {

/// Draws on request (`draw`), and by itself after a gesture: the wheel zooms time (over a value axis: that axis), drag
/// pans, a click places cursor A and Shift+click cursor B, drag on a cursor moves it, double-click resumes following.
/// All canvases show the same time. A vertical line follows the mouse. Colors follow the theme. GUI thread.
class PlotCanvas : public QWidget {
    Q_OBJECT
public:
    /// The model must outlive the canvas.
    explicit PlotCanvas(PlotModel& model, QWidget* parent = nullptr);
    ~PlotCanvas() override;

    /// Shows what the model holds now.
    void draw();
    /// While following, the newest sample is at the right edge. Emits nothing.
    void setFollowing(bool following);
    bool following() const { return following_; }
    /// Draws the lines of these series thicker.
    void emphasize(const std::set<SeriesKey>& keys);
    /// Zooms around the middle of the visible span; a factor above 1 shows less time in more detail. Ends following.
    void zoomTime(double factor);
    /// Moves by a fraction of the visible span; positive is later. Ends following.
    void panTime(double fraction);
    /// Places a cursor at the mouse, or in the middle of the visible span.
    void placeCursor(CursorName name);
    /// Moves the active cursor by so many pixels; returns false if none is active.
    bool moveCursor(double by_px);
    /// Removes the active cursor; returns false if none is active.
    bool removeCursor();
    /// The time at which a replay is; nullopt: no replay is shown. A click below the canvases or with Ctrl goes there.
    void setMoment(std::optional<double> time_s);
    std::optional<double> moment_s() const { return moment_s_; }

    /// Index of the canvas that takes what is plotted next.
    std::size_t chosen() const { return chosen_; }
    void choose(std::size_t canvas);
    /// Index of the canvas at this place.
    std::size_t canvasAt(const QPoint& at) const;

    /// Edges of the visible span on the protocol clock; samples need not reach that far.
    Seconds visibleFrom() const;
    Seconds visibleTo() const;
    /// Time under the mouse on the protocol clock; nullopt while the mouse is elsewhere.
    std::optional<Seconds> mouseTime() const;
    /// Where a time is, in pixels from the left of the surface.
    double pixelOf(double time_s) const;
    /// Number of points in the line as drawn; 0 for a series that is not shown.
    int pointCount(const SeriesKey& key) const;
    /// The plots with a legend at twice the resolution, for files.
    QPixmap picture(const QString& title);
    /// The same as a page of PDF, A4 in landscape, with black on white.
    QByteArray pdf(const QString& title);

signals:
    /// By a gesture or by zoomTime() and panTime().
    void followingChanged(bool following);
    /// The mouse moved over the plot, or left it; or the visible span changed.
    void readoutChanged();
    /// A cursor was placed, moved or removed.
    void cursorsChanged();
    /// The user wants the replay to go to this time.
    void momentRequested(usar::Seconds time);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// A vertical line through all canvases, at a time.
    struct Mark {
        std::vector<QCPItemStraightLine*> lines; ///< the plot owns them
        QCPItemText* label = nullptr;            ///< above the first canvas; the plot owns it
        void show(std::optional<double> time_s, const QCPRange& visible) const;
    };
    enum MarkName { Mouse, A, B, Moment, mark_count };

    void setUpPlot();
    void connectGestures();
    /// Makes as many panes as the layout has canvases.
    void matchPanes();
    Mark makeMark(const QString& name);
    void showMarks();
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void followAgain();
    void leaveFollowing();
    /// True while `at_px` is over the time axis below the lowest canvas.
    bool onTimeAxis(const QPointF& at_px) const;
    double timeAt(double x_px) const;
    /// Lets a drag pan, or not.
    void setPanning(bool on);
    void cursorsMoved();
    /// Shows this span in all panes.
    void showTime(const QCPRange& range);
    /// Shows the window that ends at the newest sample; returns false before the first one.
    bool fitTime();
    /// Draws the lines of the visible time anew, from the samples as they are now.
    void fill();
    void style(Theme theme);
    /// Calls `render` while title, legends and the colors of `theme` are shown.
    void compose(const QString& title, Theme theme, const std::function<void()>& render);

    PlotModel& model_;
    QCustomPlot* plot_;
    QCPMarginGroup* sides_ = nullptr; ///< the plot owns it
    std::vector<std::unique_ptr<PlotPane>> panes_;
    Mark marks_[mark_count];
    std::set<SeriesKey> emphasized_;
    std::optional<double> mouse_px_; ///< stays under the mouse while the picture moves
    std::optional<double> moment_s_;
    std::optional<QPointF> pressed_px_; ///< a click may become of this
    std::optional<CursorName> dragged_; ///< the cursor under the pressed button
    PlotCursors before_click_;          ///< a double-click places no cursor
    std::size_t chosen_ = 0;
    bool following_ = true;
    bool taking_time_ = false; ///< the panes' axes are being set
};

} // namespace usar::widgets
