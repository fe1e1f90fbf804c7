// Measures how long the GUI thread is blocked by a single event.
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QString>

/// An application that times the delivery of every event, nested ones as part of the outer. Event loops that run inside
/// an event (a dialog) are not a block and are not counted. GUI thread.
class GuiWatchdog : public QApplication {
public:
    GuiWatchdog(int& argc, char** argv) : QApplication(argc, argv) {}

    bool notify(QObject* receiver, QEvent* event) override;

    qint64 longestBlock_ms() const { return longest_ms_; }
    /// Receiver and event of the longest block, for the failure's message.
    const QString& longestWhere() const { return where_; }
    void reset();

private:
    qint64 longest_ms_ = 0;
    QString where_;
    int depth_ = 0;
};
