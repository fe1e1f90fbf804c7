// Translates keys that are held down into stick positions.
#pragma once

#include <set>

#include <QObject>
#include <QStringList>
#include <QWidget>

#include "core/base/stick.h"

class QKeyEvent;

namespace usar::widgets {

/// W and S drive forward and back, A and D turn, Q and E move sideways, R and F up and down, Shift is slower, Space
/// stops. Works only while it is active and its window is the active one, and never while the focus is in a text field;
/// otherwise it takes these keys from the shortcuts that use them. Keys of axes that the robot does not have are not
/// taken. GUI thread; owned by its window.
class DriveKeys : public QObject {
    Q_OBJECT
public:
    /// Watches the events of the whole application for this window.
    explicit DriveKeys(QWidget* window);

    /// Releases all keys; activating also takes the focus out of a text field.
    void setActive(bool active);
    bool active() const { return active_; }
    /// The axes that the robot can follow; keys of others are ignored.
    void setAxes(const StickAxes& axes) { axes_ = axes; }
    /// Position that results from the keys that are down; all zero if none is.
    Stick stick() const;
    /// Key labels for a pad that does the same, in the order forward, back, left, right; empty if the robot lacks the
    /// axis.
    static QStringList turnKeys(const StickAxes& axes);
    /// Labels of the keys for sideways and vertical motion, in the order up, down, left, right of DrivePad::setKeys.
    static QStringList sideKeys() { return {{}, {}, QStringLiteral("Q"), QStringLiteral("E")}; }
    static QStringList liftKeys() { return {QStringLiteral("R"), QStringLiteral("F"), {}, {}}; }

signals:
    /// The keys that are down have changed; all zero when the last one is released.
    void changed(const usar::Stick& stick);
    /// Space was pressed; all keys count as released.
    void stopPressed();
    /// The window lost the activation or the focus went to a text field: whoever holds the robot must let it go.
    void focusLost();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// True for a key of an axis that the robot has, and for Space.
    bool isOurs(const QKeyEvent& event) const;
    /// True if a press of this key should drive now.
    bool takes(const QKeyEvent& event) const;
    /// Returns true if the key was used and goes nowhere else.
    bool takeKey(const QKeyEvent& event, bool down);
    /// Forgets all keys that are down.
    void release();

    QWidget* window_;
    StickAxes axes_;
    std::set<int> down_; ///< keys that are down (Qt::Key)
    bool slow_ = false;  ///< Shift is down
    bool active_ = false;
};

} // namespace usar::widgets
