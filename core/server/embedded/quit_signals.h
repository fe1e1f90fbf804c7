// Delivers Ctrl+C and SIGTERM as a Qt signal.
#pragma once

#include <QObject>

namespace usar::server {

/// Turns SIGINT and SIGTERM into `quit`, through a pipe, because a signal handler can do little more than write to one.
/// A second signal of the same kind ends the program at once. Create only one per program, in the main thread; the
/// destructor restores the default handling.
class QuitSignals : public QObject {
    Q_OBJECT
public:
    explicit QuitSignals(QObject* parent = nullptr);
    ~QuitSignals() override;

signals:
    /// Emitted once, from the event loop.
    void quit();
};

} // namespace usar::server
