// The drawing of a plan for editing: pieces are dropped on it, parts are dragged within it, and text is edited in
// place.
#pragma once

#include <optional>
#include <vector>

#include <QLineEdit>

#include "widgets/models/plan/plan_gestures.h"
#include "widgets/plan/plan_view.h"

class QMimeData;

namespace usar::widgets {

/// Turns gestures into edits and reports them by signals; changes nothing itself. A card is dragged with the left
/// button and dropped on the upper part of another card (before it), its lower part (after it) or its middle (swap, or
/// put into); a note beside the mouse says what would happen. Dragging the background pans. Shows an outline unless it
/// is very wide. GUI thread.
class PlanCanvas : public PlanView {
    Q_OBJECT
public:
    explicit PlanCanvas(QWidget* parent = nullptr);

    /// Returns the possible edits of the drawn plan; called at each gesture. Returns nullptr while nothing can be
    /// edited.
    using Gestures = std::function<const PlanGestures*()>;
    void setGestures(Gestures gestures) { gestures_ = std::move(gestures); }

    /// End of a range of siblings that starts at the selection, set with Shift and a click, Up or Down; none: only the
    /// selected node. Any other change of the selection resets it.
    PlanNodeId rangeEnd() const { return range_end_; }
    /// The nodes of the range in the order of the drawing, or the selected node alone; empty without a selection.
    std::vector<PlanNodeId> range() const;

    /// Opens a line editor with these words over the node; `what` is passed through to wordsEntered.
    void editInPlace(PlanNodeId node, const QString& words, int what);
    /// The open line editor; nullptr if there is none.
    QLineEdit* openLine() const { return line_->isVisible() ? line_ : nullptr; }

signals:
    /// The user dropped something; the owner should perform this edit.
    void deedRequested(const usar::widgets::PlanDeed& deed);
    /// Something was dropped where it has no meaning.
    void dropRefused();
    /// The user changed the words of the line editor and closed it with Return, or by leaving it.
    void wordsEntered(usar::widgets::PlanNodeId node, const QString& words, int what);
    /// The end of the range changed.
    void rangeChanged();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// A drag over the canvas and the edit that a drop would make.
    struct Hover {
        PlanNodeId node;
        DropZone zone = DropZone::Onto;
        QPointF at;
        std::optional<PlanDeed> deed{};
    };
    /// True if the node can be dragged from that place.
    bool canBeTaken(PlanNodeId node, const QPointF& on_screen);
    void startDrag(PlanNodeId node);
    /// The dragged piece or node; nullopt if the data is neither.
    std::optional<std::variant<PlanPiece, PlanNodeId>> sourceOf(const QMimeData& mime) const;
    Hover hoverAt(const std::variant<PlanPiece, PlanNodeId>& source, const QPointF& on_screen);
    /// Closes the line editor; reports changed words if `keep`.
    void closeLine(bool keep);
    /// Sets the end of the range if the node is a sibling of the selection; there must be one.
    void extendTo(PlanNodeId node);
    /// The frame of a node on the screen, with some distance from it.
    QRectF frameOf(PlanNodeId node);

    Gestures gestures_;
    QLineEdit* line_;
    PlanNodeId line_node_;
    int line_what_ = 0;
    PlanNodeId range_end_;
    PlanNodeId taken_; ///< pressed, but not dragged yet
    QPointF taken_at_;
    std::optional<Hover> hover_;
};

} // namespace usar::widgets
