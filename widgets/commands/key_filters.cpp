#include "widgets/commands/key_filters.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>

namespace usar::widgets {

EscapeTwice::EscapeTwice(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool EscapeTwice::eventFilter(QObject* watched, QEvent* event) {
    // A window receives each key once, before it is passed on to widgets and their parents.
    if (event->type() == QEvent::KeyPress && watched->isWindowType())
        take(*static_cast<QKeyEvent*>(event));
    return QObject::eventFilter(watched, event);
}

void EscapeTwice::take(const QKeyEvent& event) {
    if (event.isAutoRepeat())
        return;
    if (event.key() != Qt::Key_Escape || event.modifiers() != Qt::NoModifier) {
        armed_ = false;
        return;
    }
    const bool twice = armed_ && event.timestamp() - last_press_ms_ <= interval_ms;
    armed_ = !twice;
    last_press_ms_ = event.timestamp();
    if (twice)
        emit pressedTwice();
}

OwnKeys::OwnKeys(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool OwnKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool to_an_end = key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
    const bool has_ends = qobject_cast<QAbstractSlider*>(watched) || qobject_cast<QAbstractItemView*>(watched) ||
                          qobject_cast<QComboBox*>(watched);
    if (!to_an_end || !has_ends || (key.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier)
        return false;
    event->accept(); // It is not a shortcut then.
    return true;
}

} // namespace usar::widgets
