#include "widgets/commands/escape_twice.h"

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

} // namespace usar::widgets
