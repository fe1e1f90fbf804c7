// What panels, bars and cards are made with: rows and columns, names for screen readers, roles, and themes.
#pragma once

#include <functional>
#include <initializer_list>

#include <QAbstractItemView>
#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QListView>
#include <QToolButton>

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

/// Gives a widget its name for screen readers and its tooltip; returns the widget.
template <class Widget>
Widget* named(Widget* widget, const QString& name, const QString& help) {
    widget->setAccessibleName(name);
    widget->setToolTip(help);
    return widget;
}

/// Makes a label in the color for units, captions and hints.
QLabel* mutedLabel(const QString& text = {}, QWidget* parent = nullptr);
/// Gives a widget a role of the style sheet ("muted", "primary") and shows it at once, also after the first painting.
void setRole(QWidget* widget, const char* role);

/// Makes a button flat and large enough to click, without changing its focus policy.
void makeFlat(QToolButton* button);
/// Lets a button show and trigger `action`, and read out the action's text.
void showAction(QToolButton* button, QAction* action);

/// Makes an action for the context menu of a list. Its shortcut works only while the list has the focus.
QAction* addRowAction(QAbstractItemView* view, const QString& text, const QKeySequence& keys);
/// Shows the actions of a list as a menu if there is an item at `at`, a place in the viewport.
void popUpRowMenu(QAbstractItemView* view, const QPoint& at);
/// Prepares a list whose rows `delegate` paints over their whole width: no frame, no editing, no sideways scrolling.
void setUpPaintedRows(QListView* view, QAbstractItemModel* model, QAbstractItemDelegate* delegate, const QString& name);

/// Calls `repaint` whenever the theme has changed, before the widget itself handles the event. `when` is StyleChange
/// for palettes of labels, because the style sheet resets them after the PaletteChange.
void onThemeChange(QWidget* widget, std::function<void()> repaint, QEvent::Type when = QEvent::PaletteChange);

} // namespace usar::widgets
