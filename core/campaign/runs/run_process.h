// One run of a campaign in a process of its own, so that a crash, or too little memory, ends nothing else.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QTimer>

#include "core/base/clock.h"
#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

/// How a process ended, as far as its system tells.
struct ProcessEnd {
    bool by_signal = false;
    int code = 0; ///< the exit code, or the number of the signal
    bool timed_out = false;
    bool stopped = false; ///< by `stop`: there is no result
    QByteArray output;
    QByteArray complaints;
};

/// Judges a run by its process: fills outcome, reason and summary of `result`.
void judge(RunResult& result, const ProcessEnd& end);

/// Starts `usar-mission` and emits `ended` once. Lives in its owner's thread, which needs an event loop. Its process
/// ends with this object, and also if this program is killed.
class RunProcess : public QObject {
    Q_OBJECT
public:
    explicit RunProcess(QObject* parent = nullptr);
    ~RunProcess() override;

    void start(const QString& program, const QStringList& arguments, Seconds wall_limit);
    /// Ends the process; `ended` follows.
    void stop();
    Seconds wall() const { return wall_; } ///< of the process; valid after `ended`

signals:
    void ended(const usar::campaign::ProcessEnd& end);

private:
    void finish(bool started);

    QProcess process_;
    QTimer limit_;
    QElapsedTimer since_start_;
    Seconds wall_{0.0};
    ProcessEnd end_;
};

} // namespace usar::campaign
