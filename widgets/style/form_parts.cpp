#include "widgets/style/form_parts.h"

#include <utility>

#include <QMenu>
#include <QStyle>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

class ThemeWatch : public QObject {
public:
    ThemeWatch(QWidget* widget, std::function<void()> repaint, QEvent::Type when)
        : QObject(widget)
        , repaint_(std::move(repaint))
        , when_(when) {
        widget->installEventFilter(this);
    }

    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == when_)
            repaint_();
        return false;
    }

private:
    std::function<void()> repaint_;
    QEvent::Type when_;
};

} // namespace

QLabel* mutedLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", "muted");
    return label;
}

void setRole(QWidget* widget, const char* role) {
    if (widget->property("role").toByteArray() == role)
        return;
    widget->setProperty("role", role);
    widget->style()->unpolish(widget); // Otherwise the color of the previous role would stay.
    widget->style()->polish(widget);
}

void makeFlat(QToolButton* button) {
    button->setAutoRaise(true);
    button->setMinimumSize(minimum_target, minimum_target);
}

void showAction(QToolButton* button, QAction* action) {
    button->setDefaultAction(action);
    button->setAccessibleName(action->text());
}

QAction* addRowAction(QAbstractItemView* view, const QString& text, const QKeySequence& keys) {
    auto* action = new QAction(text, view);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    view->addAction(action);
    return action;
}

void popUpRowMenu(QAbstractItemView* view, const QPoint& at) {
    if (!view->indexAt(at).isValid())
        return;
    auto* menu = new QMenu(view);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions(view->actions());
    menu->popup(view->viewport()->mapToGlobal(at));
}

void setUpPaintedRows(QListView* view, QAbstractItemModel* model, QAbstractItemDelegate* delegate,
                      const QString& name) {
    view->setModel(model);
    view->setItemDelegate(delegate);
    view->setFrameShape(QFrame::NoFrame);
    view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view->setAccessibleName(name);
    view->parentWidget()->setFocusProxy(view);
}

void onThemeChange(QWidget* widget, std::function<void()> repaint, QEvent::Type when) {
    new ThemeWatch(widget, std::move(repaint), when);
}

} // namespace usar::widgets
