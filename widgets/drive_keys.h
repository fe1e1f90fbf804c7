// Keys that drive while they are held down.
#pragma once

#include <set>

#include <QObject>
#include <QStringList>
#include <QWidget>

#include "core/base/stick.h"

class QKeyEvent;

namespace usar::widgets {

/// W S forward and back, A D round, Q E sideways, R F up and down, Shift slower, Space stops. Only while it is active
/// and its window is the active one, and never where text is typed; then these keys are taken from the shortcuts that
/// have them. Only those of the robot's axes are taken. GUI thread; lives as long as its window.
class DriveKeys : public QObject {
    Q_OBJECT
public:
    explicit DriveKeys(QWidget* window);

    void setActive(bool active);
    bool active() const { return active_; }
    void setAxes(const StickAxes& axes);
    /// By the keys that are down.
    Stick stick() const;
    /// Forward, back, left, right …: what is written on them, for a pad that does the same; empty where there is no
    /// such axis.
    static QStringList turnKeys(const StickAxes& axes);
    static QStringList sideKeys() { return {{}, {}, QStringLiteral("Q"), QStringLiteral("E")}; }
    static QStringList liftKeys() { return {QStringLiteral("R"), QStringLiteral("F"), {}, {}}; }

signals:
    void changed(const usar::Stick& stick);
    void stopPressed();
    /// The window is no longer the active one, or text is typed: whatever is held has to be let go.
    void focusLost();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isOurs(const QKeyEvent& event) const;
    bool takes(const QKeyEvent& event) const;
    bool takeKey(const QKeyEvent& event, bool down);
    void release();

    QWidget* window_;
    StickAxes axes_;
    std::set<int> down_;
    bool slow_ = false;
    bool active_ = false;
};

} // namespace usar::widgets
