// Escape twice stops everything: watches the keyboard of the whole application.
#pragma once

#include <QObject>

class QKeyEvent;

namespace usar::widgets {

/// Installed on the application. Counts presses of Escape without modifiers and without auto-repeat by the events' own
/// time stamps; both still reach the widget that has the focus, so that closing a popup keeps working. GUI thread.
class EscapeTwice : public QObject {
    Q_OBJECT
public:
    /// Longest time between the two presses; long enough for a hand in gloves.
    static constexpr quint64 interval_ms = 800;

    /// Needs the application object; the filter ends with this object.
    explicit EscapeTwice(QObject* parent = nullptr);

signals:
    /// Once for every pair: four presses are two orders.
    void pressedTwice();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take(const QKeyEvent& event);

    quint64 last_press_ms_ = 0;
    bool armed_ = false;
};

} // namespace usar::widgets
