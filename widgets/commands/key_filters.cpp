#include "widgets/commands/key_filters.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>

namespace usar::widgets {

KeyTwice::KeyTwice(const QKeySequence& key, QObject* parent) : QObject(parent), key_(key[0]) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool KeyTwice::eventFilter(QObject* watched, QEvent* event) {
    // A window receives each key once, before it is passed on to widgets and their parents.
    if (event->type() == QEvent::KeyPress && watched->isWindowType())
        take(*static_cast<QKeyEvent*>(event));
    return QObject::eventFilter(watched, event);
}

void KeyTwice::take(const QKeyEvent& event) {
    if (event.isAutoRepeat())
        return;
    if (event.keyCombination() != key_) {
        armed_ = false;
        return;
    }
    const bool twice = armed_ && event.timestamp() - last_press_ms_ <= interval_ms;
    armed_ = !twice;
    last_press_ms_ = event.timestamp();
    if (twice)
        emit pressedTwice();
}

namespace {

/// A list that drops down finds its entries by what is typed.
bool isTyped(const QKeyEvent& key) {
    const bool with_command = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    return !with_command && !key.text().isEmpty() && key.text().front().isPrint();
}

bool isToAnEnd(const QKeyEvent& key) {
    const bool is_end = key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
    return is_end && (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

} // namespace

OwnKeys::OwnKeys(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool OwnKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool is_choice = qobject_cast<QComboBox*>(watched);
    const bool has_ends =
        is_choice || qobject_cast<QAbstractSlider*>(watched) || qobject_cast<QAbstractItemView*>(watched);
    if (!(has_ends && isToAnEnd(key)) && !(is_choice && isTyped(key)))
        return false;
    event->accept(); // It is not a shortcut then.
    return true;
}

} // namespace usar::widgets
