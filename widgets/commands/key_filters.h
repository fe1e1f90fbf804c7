// Keys that are watched in the whole application: one pressed twice, and those that some widgets need themselves.
#pragma once

#include <QKeySequence>
#include <QObject>

class QKeyEvent;

namespace usar::widgets {

/// Event filter on the application. Counts presses of one key, without auto-repeat, by the time stamps of the events;
/// both presses still reach the widget that has the focus, so that Escape keeps closing popups. GUI thread.
class KeyTwice : public QObject {
    Q_OBJECT
public:
    /// Longest time between the two presses; long enough for an operator wearing gloves.
    static constexpr quint64 interval_ms = 800;

    /// `key`: a sequence of one key. Requires that the application object exists; the filter is removed with this
    /// object.
    explicit KeyTwice(const QKeySequence& key, QObject* parent = nullptr);

    /// The last press meant something else: it does not count.
    void forget() { armed_ = false; }

signals:
    /// Emitted once for each pair: four presses emit it twice.
    void pressedTwice();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take(const QKeyEvent& event);

    QKeyCombination key_;
    /// Time stamp of the last press, on the clock of Qt's input events.
    quint64 last_press_ms_ = 0;
    /// The next press within the interval completes a pair.
    bool armed_ = false;
};

/// Sliders, lists and combo boxes go to their ends with Home and End, and combo boxes find an entry by what is typed;
/// in other widgets such a key triggers the window's command. Event filter on the application for as long as this
/// object exists. GUI thread.
class OwnKeys : public QObject {
public:
    explicit OwnKeys(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace usar::widgets
