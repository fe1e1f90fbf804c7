// Ctrl+C and a polite kill, as a Qt signal.
#pragma once

#include <QObject>

namespace usar::app {

/// Turns SIGINT and SIGTERM into `quit`, through a pipe: a signal handler may do nothing else. One per program, in the
/// main thread. A second signal ends the program at once.
class QuitSignals : public QObject {
    Q_OBJECT
public:
    explicit QuitSignals(QObject* parent = nullptr);
    ~QuitSignals() override;

signals:
    void quit();
};

} // namespace usar::app
