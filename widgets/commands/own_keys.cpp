#include "widgets/commands/own_keys.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace usar::widgets {

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
