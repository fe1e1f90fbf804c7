// The drawing of a plan for writing: pieces are dropped on it, parts dragged within it, words changed where they stand.
#pragma once

#include <optional>
#include <vector>

#include <QLineEdit>

#include "widgets/models/plan_gestures.h"
#include "widgets/plan_view.h"

class QMimeData;

namespace usar::widgets {

/// Gestures in, deeds out; it changes nothing itself. A card is taken with the left button and dropped on the upper
/// part of another one (before it), its lower part (behind it) or its middle (swap, put into); the words for what would
/// happen stand beside the mouse. The background still pans. An outline where it is not very broad. GUI thread.
class PlanCanvas : public PlanView {
    Q_OBJECT
public:
    explicit PlanCanvas(QWidget* parent = nullptr);

    /// What can be done with the plan that is drawn; asked at each gesture, nullptr while nothing can be.
    using Gestures = std::function<const PlanGestures*()>;
    void setGestures(Gestures gestures) { gestures_ = std::move(gestures); }

    /// Shift with a click, Up or Down takes neighbors of one list along: all from the selected one to this; -1: it is
    /// alone. Whatever selects another part ends it.
    int rangeEnd() const { return range_end_; }
    /// Those between, in the order of the drawing; the selected one where it is alone.
    std::vector<int> range() const;

    /// A line over the node with these words in it; `what` comes back with them.
    void editInPlace(int node, const QString& words, int what);
    /// The open line; nullptr for none.
    QLineEdit* openLine() const { return line_->isVisible() ? line_ : nullptr; }

signals:
    void deedRequested(const usar::widgets::PlanDeed& deed);
    /// Something was dropped where it means nothing.
    void dropRefused();
    void wordsEntered(int node, const QString& words, int what);
    void rangeChanged();
    /// -1: beside all nodes.
    void menuRequested(int node, const QPoint& global);

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
    struct Hover {
        int node = -1;
        DropZone zone = DropZone::Onto;
        QPointF at;
        std::optional<PlanDeed> deed;
    };
    int nodeUnder(const QPointF& on_screen);
    bool canBeTaken(int node, const QPointF& on_screen);
    void startDrag(int node);
    std::optional<std::variant<PlanPiece, int>> sourceOf(const QMimeData& mime) const;
    Hover hoverAt(const std::variant<PlanPiece, int>& source, const QPointF& on_screen);
    void closeLine(bool keep);
    void extendTo(int node);
    int cardOf(int node) const;

    Gestures gestures_;
    QLineEdit* line_;
    int line_node_ = -1;
    int line_what_ = 0;
    int range_end_ = -1;
    int taken_ = -1; ///< pressed, and not yet dragged
    int dragged_ = -1;
    QPointF taken_at_;
    std::optional<Hover> hover_;
};

} // namespace usar::widgets
