// Live drawing of a plan: what is running, the answers of senses, and how often each part started.
#pragma once

#include <QTimer>
#include <QWidget>

#include "core/posh/model/plan.h"
#include "widgets/models/pan_zoom.h"
#include "widgets/models/plan/plan_selection.h"
#include "widgets/plan/plan_drawing.h"

namespace usar::widgets {

class EmptyState;

/// State comes in by setters, gestures go out by signals; it knows no engine. Snapshots are taken at most every 16 ms,
/// and not while hidden. Keys when focused: arrows pan (with Shift by a page), + and - zoom, F fits, Ctrl with arrows
/// moves to the part above, below, left or right, Home and End to the first and last, N and Shift+N step through what
/// is running, Space folds, Return follows a link or emits activated, Escape clears the selection. GUI thread.
class PlanView : public QWidget {
    Q_OBJECT
public:
    explicit PlanView(QWidget* parent = nullptr);

    /// Shows a plan; parts with the same names stay folded and selected, counters start again.
    void setPlan(const posh::Plan& plan);
    /// Removes the plan and all folds, for another robot or none.
    void clear();
    /// The sheet that is shown while there is no plan.
    EmptyState* emptyState() const { return empty_state_; }
    /// Shows this state of the run, from the next frame on.
    void setSnapshot(PlanSnapshot snapshot);
    /// Replaces all marks; they are kept by path when the plan changes.
    void setMarks(std::vector<PlanMark> marks);
    const PlanMarks& marks() const { return marks_; }

    void setSharing(PlanSharing sharing);
    /// Direction of growth; nullopt: across if the view is wide enough, else as an outline.
    void setFlow(std::optional<PlanFlow> flow);

    /// Node ids are valid until the next plan or sharing.
    const PlanTree& tree() const { return drawing_.tree(); }
    const PlanStates& states() const { return states_; }
    const PlanFolds& folds() const { return drawing_.folds(); }
    const PlanLayout& layout() { return drawing_.layout(); }
    PlanNodeId selected() const { return selection_.node(); }
    /// Selects a node or none, unfolds the way to it and scrolls there; emits selectionChanged if it is another one.
    void select(PlanNodeId node);
    /// Selects the node of an engine's path; returns false if there is none.
    bool selectPath(const std::string& path);
    void setFolded(PlanNodeId node, bool folded);

    /// Marks what matches and selects the next match, unless one is selected. Returns how many match; 0 without words.
    int find(const QString& words);
    /// Selects the next or previous match; wraps around.
    void findNext(bool backward = false);
    const std::vector<PlanNodeId>& found() const { return selection_.found(); }

    /// Screen pixels per layout pixel.
    double scale() const { return zoom_.scale; }
    QPointF toScreen(const QPointF& in_layout) const { return zoom_.toScreen(in_layout); }
    QPointF toLayout(const QPointF& on_screen) const { return zoom_.toDrawing(on_screen); }
    /// Shows the beginning of the drawing at a readable size; the whole drawing if it is readable then.
    void showBeginning();
    /// Keeps scale and position when the plan changes, until fit() or showBeginning() is called.
    void holdStill() { framing_ = Framing::Own; }
    /// Description of a node, as in its tooltip and for screen readers.
    QString nodeText(PlanNodeId node) const;

    /// Size at a scale of 1. paintDrawing() draws all that is not folded in the light theme, its corner at the origin.
    QSizeF drawingSize() { return layout().bounds().size() + 2.0 * QSizeF(PanZoom::margin_px, PanZoom::margin_px); }
    void paintDrawing(QPainter& painter);

    QSize sizeHint() const override { return {900, 420}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

public slots:
    void fit();
    void zoomIn() { zoomAt(QRectF(rect()).center(), zoom_step::closer); }
    void zoomOut() { zoomAt(QRectF(rect()).center(), zoom_step::farther); }
    void foldAll();
    void unfoldAll();
    /// Unfolds what is running and folds the rest.
    void showRunning();

signals:
    /// None: nothing is selected.
    void selectionChanged(usar::widgets::PlanNodeId node);
    /// Double-click or Return on a part that is not a link.
    void activated(usar::widgets::PlanNodeId node);
    /// The user wants the context menu of a part, which is selected already, or of the background (none).
    void menuRequested(usar::widgets::PlanNodeId node, const QPoint& at_global);
    /// A snapshot was taken: states() changed. Not emitted while the view is hidden.
    void refreshed();
    /// The plan or the sharing changed: node ids changed.
    void treeChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

    /// The node at that place, or its card if the scale is too small for sense rows.
    PlanNodeId nodeAt(const QPointF& on_screen) { return drawing_.nodeAt(toLayout(on_screen), planDetailAt(scale())); }
    /// True if that place is on the node's fold mark or link arrow.
    bool onFoldMark(PlanNodeId node, const QPointF& on_screen) {
        return drawing_.onFoldMark(node, toLayout(on_screen), planDetailAt(scale()));
    }

private:
    void takeTree(const PlanTree& before);
    void takeNews();
    /// Lays out again if `change` returns true, and keeps the node in its place on the screen.
    void refold(PlanNodeId held, const std::function<bool(PlanFolds&)>& change);
    bool selectionIsHidden() { return selected().valid() && drawing_.hides(selected()); }
    void bringIntoView(PlanNodeId node);
    void zoomAt(const QPointF& on_screen, double factor);
    void panBy(const QPointF& by_px);
    bool actByKey(const QKeyEvent& event);
    void open(PlanNodeId node); ///< follows a link, else folds or unfolds
    void describe();            ///< for screen readers: the selected part, or the keys if there is none

    PlanDrawing drawing_;
    PlanSelection selection_;
    PlanStates states_;
    PlanSnapshot snapshot_;
    std::vector<PlanMark> marks_by_path_;
    PlanMarks marks_;
    bool news_ = false; ///< the snapshot has not been taken yet
    QTimer tick_;
    PanZoom zoom_;
    enum class Framing { Beginning, Whole, Own } framing_ = Framing::Beginning; ///< kept when the view is resized
    PlanNodeId hot_;
    enum class Gesture { None, Pressed, Panning } gesture_ = Gesture::None;
    QPointF pressed_at_;
    QPointF last_at_;
    EmptyState* empty_state_;
};

} // namespace usar::widgets
