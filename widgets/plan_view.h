// The drawing of a plan, live: what runs now, what the senses said, how often each part started.
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

#include "core/posh/plan.h"
#include "widgets/models/plan_activity.h"
#include "widgets/models/plan_folds.h"
#include "widgets/models/plan_layout.h"
#include "widgets/models/plan_marks.h"

namespace usar::widgets {

class EmptyState;

/// Values in by setters, gestures out by signals; it knows no engine. News is taken at most every 16 ms, and none while
/// hidden. Keys when focused: arrows pan (with Shift by a page), + and - zoom, F fits, Ctrl with arrows walks to the
/// part above, below, left or right, Home and End to the first and last, N and Shift+N over what runs, Space folds,
/// Return follows a link or asks for the text, Escape selects nothing. GUI thread.
class PlanView : public QWidget {
    Q_OBJECT
public:
    explicit PlanView(QWidget* parent = nullptr);
    ~PlanView() override;

    /// Folds and selection stay with the parts of the same names; counters begin anew.
    void setPlan(const posh::Plan& plan);
    /// Another robot, or none: as new.
    void clear();
    /// The sheet that is shown while there is no plan.
    EmptyState* emptyState() const { return empty_state_; }
    void setSnapshot(PlanSnapshot snapshot);
    /// All that there are; they stay with their paths in another plan.
    void setMarks(std::vector<PlanMark> marks);
    const PlanMarks& marks() const { return marks_; }

    void setSharing(PlanSharing sharing);
    PlanSharing sharing() const { return sharing_; }
    /// Nothing: across where there is room for it, else as an outline.
    void setFlow(std::optional<PlanFlow> flow);

    /// What of them is at hand; node numbers hold until the next plan or sharing.
    const PlanTree& tree() const { return tree_; }
    const PlanStates& states() const { return states_; }
    const PlanFolds& folds() const { return folds_; }
    const PlanLayout& layout();
    int selected() const { return selected_; }
    /// Opens the way to it and brings it into view; -1 selects nothing. Tells by selectionChanged.
    void select(int node);
    bool selectPath(const std::string& path);
    void setFolded(int node, bool folded);

    /// Marks what fits and goes to the first of it after the selection. The number found; 0 also for no words.
    int find(const QString& words);
    /// To the next or previous of what was found; over the end to the beginning.
    void findNext(bool backward = false);
    const std::vector<int>& found() const { return found_; }

    double scale() const { return scale_; }
    QPointF toScreen(const QPointF& in_layout) const { return (in_layout - corner_) * scale_; }
    QPointF toLayout(const QPointF& on_screen) const { return on_screen / scale_ + corner_; }
    /// At a size that can be read, from the beginning; smaller only as far as that helps.
    void showBeginning();
    /// Scale and place stay as they are when another plan comes, until they are asked for again.
    void holdStill() { framing_ = Framing::Own; }
    /// What it would say of a node under the mouse, and to a screen reader.
    QString nodeText(int node) const;
    /// What keeps the drawing from being the whole truth; empty where nothing does.
    QString reservation() const;
    /// How often news was taken: hidden views take none.
    int newsTaken() const { return news_taken_; }

    /// The whole drawing with all that is open, in the light theme, at a scale of 1, its corner at the origin.
    QSizeF drawingSize();
    void paintDrawing(QPainter& painter);

    QSize sizeHint() const override { return {900, 420}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

public slots:
    void fit();
    void zoomIn();
    void zoomOut();
    void foldAll();
    void unfoldAll();
    /// Opens what runs and folds the rest.
    void showRunning();

signals:
    /// -1: nothing is.
    void selectionChanged(int node);
    /// Double-click or Return on a part that is no link.
    void activated(int node);
    /// The person asks what can be done with a part (it is selected by then), or with none (-1).
    void menuRequested(int node, const QPoint& at_global);
    /// News was taken: states() are others.
    void refreshed();
    /// Another plan or another sharing: node numbers are others.
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
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    void rebuild();
    void takeNews();
    void relayout();
    PlanFlow wantedFlow() const;
    /// As relayout, but the node stays where it is on the screen.
    void relayoutAround(int node);
    int nodeAt(const QPointF& on_screen);
    bool onFoldMark(int node, const QPointF& on_screen);
    void bringIntoView(int node);
    void keepInReach();
    void zoomAt(const QPointF& on_screen, double factor);
    void panBy(const QPointF& by_px);
    bool panByKey(const QKeyEvent& event);
    bool walkByKey(const QKeyEvent& event);
    bool actByKey(const QKeyEvent& event);
    int neighbor(int key) const;
    int sibling(int node, int by) const;
    void walkRunning(int by);
    void open(int node);
    void describe();

    posh::Plan plan_;
    PlanSharing sharing_ = PlanSharing::Once;
    std::optional<PlanFlow> flow_;
    PlanTree tree_;
    PlanFolds folds_;
    PlanStates states_;
    PlanSnapshot snapshot_;
    std::vector<PlanMark> marks_by_path_;
    PlanMarks marks_;
    bool news_ = false; ///< the snapshot was not taken yet
    int news_taken_ = 0;
    QTimer tick_;
    std::vector<QSizeF> sizes_;
    double row_px_ = 20.0;
    PlanLayout layout_;
    bool layout_valid_ = false;
    double scale_ = 1.0;
    QPointF corner_;                                                            ///< of the layout at the view's corner
    enum class Framing { Beginning, Whole, Own } framing_ = Framing::Beginning; ///< what resizing keeps
    std::vector<int> found_;
    std::vector<bool> found_marks_;
    int selected_ = -1;
    int hot_ = -1;
    bool panning_ = false;
    bool pressed_ = false;
    QPointF pressed_at_;
    QPointF last_at_;
    EmptyState* empty_state_;
};

} // namespace usar::widgets
