#include "widgets/drive/drive_keys.h"

#include <algorithm>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace usar::widgets {

namespace {

constexpr double slow_share = 0.3;

/// A key, the axis that the robot needs for it, and where it moves the stick.
struct DriveKey {
    int key;
    bool StickAxes::*axis;
    double Stick::*part;
    double way;
};

constexpr DriveKey drive_keys[] = {
    {Qt::Key_W, &StickAxes::forward, &Stick::forward, 1.0}, {Qt::Key_S, &StickAxes::forward, &Stick::forward, -1.0},
    {Qt::Key_Q, &StickAxes::left, &Stick::left, 1.0},       {Qt::Key_E, &StickAxes::left, &Stick::left, -1.0},
    {Qt::Key_R, &StickAxes::up, &Stick::up, 1.0},           {Qt::Key_F, &StickAxes::up, &Stick::up, -1.0},
    {Qt::Key_A, &StickAxes::turn, &Stick::turn, 1.0},       {Qt::Key_D, &StickAxes::turn, &Stick::turn, -1.0}};

bool takesText(const QWidget* widget) {
    if (const auto* const line = qobject_cast<const QLineEdit*>(widget))
        return !line->isReadOnly();
    const auto* const choice = qobject_cast<const QComboBox*>(widget);
    return qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) || (choice && choice->isEditable());
}

} // namespace

DriveKeys::DriveKeys(QWidget* window) : QObject(window), window_(window) {
    qApp->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, const QWidget* now) {
        if (active_ && takesText(now)) {
            emit focusLost();
            release();
        }
    });
}

void DriveKeys::setActive(bool active) {
    if (active_ == active)
        return;
    active_ = active;
    release();
    if (QWidget* const typed_in = QApplication::focusWidget(); active && takesText(typed_in))
        typed_in->clearFocus(); // The user wants to drive, not to type.
}

Stick DriveKeys::stick() const {
    Stick stick;
    for (const DriveKey& drive : drive_keys)
        if (down_.contains(drive.key))
            stick.*drive.part += drive.way * (slow_ ? slow_share : 1.0);
    return masked(stick, axes_);
}

QStringList DriveKeys::turnKeys(const StickAxes& axes) {
    const auto named = [](bool has, const char* key) { return has ? QString::fromLatin1(key) : QString(); };
    return {named(axes.forward, "W"), named(axes.forward, "S"), named(axes.turn, "A"), named(axes.turn, "D")};
}

bool DriveKeys::isOurs(const QKeyEvent& event) const {
    return event.key() == Qt::Key_Space || std::ranges::any_of(drive_keys, [&](const DriveKey& drive) {
               return drive.key == event.key() && axes_.*drive.axis;
           });
}

bool DriveKeys::takes(const QKeyEvent& event) const {
    const auto modifiers = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    return active_ && isOurs(event) && modifiers == Qt::NoModifier && QApplication::activeWindow() == window_ &&
           !QApplication::activePopupWidget() && !takesText(QApplication::focusWidget());
}

/// Filters events of the whole application. A window receives each key once, before its widgets do; before that, the
/// focused widget is asked by a ShortcutOverride whether it wants the key more than a shortcut does.
bool DriveKeys::eventFilter(QObject* watched, QEvent* event) {
    if (!active_)
        return false;
    const QEvent::Type type = event->type();
    if (type == QEvent::ShortcutOverride && takes(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    if ((type == QEvent::KeyPress || type == QEvent::KeyRelease) && watched->isWindowType())
        return takeKey(*static_cast<QKeyEvent*>(event), type == QEvent::KeyPress);
    if (type == QEvent::WindowDeactivate && watched == window_) {
        emit focusLost();
        release();
    }
    return false;
}

bool DriveKeys::takeKey(const QKeyEvent& event, bool down) {
    if (event.key() == Qt::Key_Shift && slow_ != down) {
        slow_ = down;
        if (!down_.empty())
            emit changed(stick());
        return false;
    }
    if (!down && down_.contains(event.key()) && !event.isAutoRepeat()) {
        down_.erase(event.key()); // Independent of the focus.
        emit changed(stick());
        return true;
    }
    if (!takes(event))
        return false;
    if (event.isAutoRepeat() || !down)
        return true;
    if (event.key() == Qt::Key_Space) {
        release();
        emit stopPressed();
        return true;
    }
    down_.insert(event.key());
    emit changed(stick());
    return true;
}

void DriveKeys::release() {
    const bool held = !down_.empty();
    down_.clear();
    slow_ = false;
    if (held)
        emit changed({});
}

} // namespace usar::widgets
