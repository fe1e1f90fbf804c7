// What panels, bars and cards are made with: rows and columns, names for screen readers, roles, labels that shrink,
// state symbols, and themes.
#pragma once

#include <functional>
#include <initializer_list>

#include <QAbstractItemView>
#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QListView>
#include <QPointF>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

namespace usar::widgets {

/// Adds `widgets` to a row or column in this order, `spacing` pixels apart; returns the layout.
template <class Box>
Box* laidOut(Box* box, int spacing, std::initializer_list<QWidget*> widgets = {}) {
    box->setSpacing(spacing);
    for (QWidget* widget : widgets)
        box->addWidget(widget);
    return box;
}

/// The same with margins around the whole, in pixels: left, top, right, bottom.
template <class Box>
Box* laidOut(Box* box, const QMargins& margins, int spacing, std::initializer_list<QWidget*> widgets = {}) {
    box->setContentsMargins(margins);
    return laidOut(box, spacing, widgets);
}

/// Makes a grid with these margins around it (left, top, right, bottom) and these gaps between its columns and rows,
/// all in pixels.
QGridLayout* gridOf(QWidget* parent, const QMargins& margins, int column_gap, int row_gap);

/// Gives a widget its name for screen readers and its tooltip; returns the widget.
template <class Widget>
Widget* named(Widget* widget, const QString& name, const QString& help) {
    widget->setAccessibleName(name);
    widget->setToolTip(help);
    return widget;
}

/// Makes the red button that stops robots at once. It must never ask for confirmation.
QPushButton* makeStopButton(const QString& text, const QString& help, QWidget* parent = nullptr);

/// Makes a label in the color for units, captions and hints.
QLabel* mutedLabel(const QString& text = {}, QWidget* parent = nullptr);
/// Gives a widget a role of the style sheet ("muted", "primary") and shows it at once, also after the first painting.
void setRole(QWidget* widget, const char* role);

/// Makes a button flat and large enough to click, without changing its focus policy.
void makeFlat(QToolButton* button);
/// Lets a button show and trigger `action`, and read out the action's text.
void showAction(QToolButton* button, QAction* action);

/// Lets a button trigger `action` and follow its enabled state and tooltip; the button keeps its own text. The action
/// must outlive the button.
void followAction(QPushButton* button, QAction* action);

/// Direction of an arrow key (Qt::Key): 1 to the right or up, -1 to the left or down; zero for all other keys.
QPointF arrowDirection(int key);

/// Makes an action for the context menu of a list. Its shortcut works only while the list has the focus.
QAction* addRowAction(QAbstractItemView* view, const QString& text, const QKeySequence& keys);
/// Shows the actions of a list as a menu if there is an item at `at`, a place in the viewport.
void popUpRowMenu(QAbstractItemView* view, const QPoint& at);
/// Prepares a list whose rows `delegate` paints over their whole width: no frame, no editing, no sideways scrolling.
void setUpPaintedRows(QListView* view, QAbstractItemModel* model, QAbstractItemDelegate* delegate, const QString& name);

/// Calls `repaint` whenever the theme has changed, before the widget itself handles the event. `when` is StyleChange
/// for palettes of labels, because the style sheet resets them after the PaletteChange.
void onThemeChange(QWidget* widget, std::function<void()> repaint, QEvent::Type when = QEvent::PaletteChange);

/// Shortens `text` to `width_px`: drops trailing parts (separated by " · ") first, then elides the rest.
QString fittedText(const QString& text, const QFontMetrics& metrics, int width_px);

/// The property `text` remains complete for assistive tools; give the label a tooltip with the complete text.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;
    QSize minimumSizeHint() const override { return {24, QLabel::minimumSizeHint().height()}; }
    QSize sizeHint() const override;
    /// Makes the label ask for the width of `text` whatever it shows, so that its neighbors do not move.
    void setRoomFor(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString room_for_;
};

/// Each state has a shape of its own, so that color is never the only distinction.
enum class StateShape {
    Off,     ///< hollow circle, muted
    Busy,    ///< half circle, accent
    Good,    ///< full circle, ok
    Waiting, ///< hollow triangle, caution
    Bad      ///< cross in a circle, danger
};

/// 16 x 16 pixels; takes no focus, because assistive tools read the word beside it.
class StateDot : public QWidget {
    Q_OBJECT
public:
    explicit StateDot(QWidget* parent = nullptr);
    /// The caller must change the word beside it as well.
    void setState(StateShape state);
    StateShape state() const { return state_; }
    QSize sizeHint() const override { return {16, 16}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StateShape state_ = StateShape::Off;
};

/// Text color for the word of that state.
QColor stateColor(StateShape state);
/// The role that gives a label this color.
const char* stateRole(StateShape state);

} // namespace usar::widgets
