// Runs of a campaign, each in a process of its own, so that a crash, or too little memory, ends nothing else.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QTimer>

#include "core/base/clock.h"
#include "core/campaign/runs/run_request.h"
#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

/// How a run ended, with all that it wrote.
struct ProcessEnd : RunEnd {
    bool timed_out = false;
    bool stopped = false; ///< by `stop`: there is no result
    QByteArray output;
    QByteArray complaints;
};

/// Judges a run by its process: fills outcome, reason and summary of `result`.
void judge(RunResult& result, const ProcessEnd& end);

/// Has `usar-mission worker` fly runs, one at a time, and emits `ended` once for each. A worker loads what runs need
/// once, and makes a copy of its process for each run. It is started when it is needed and ends with this object, also
/// if this program is killed. Lives in its owner's thread, which needs an event loop.
class RunProcess : public QObject {
    Q_OBJECT
public:
    /// FliesOnce: a new worker for each run, which has ended when `ended` is emitted. FliesMore: one worker for all;
    /// the destructor waits for its end.
    enum class Worker { FliesOnce, FliesMore };

    explicit RunProcess(Worker worker = Worker::FliesOnce);
    ~RunProcess() override;

    /// `program`: path of usar-mission, the same one each time; `arguments`: those of the run. Another run must not be
    /// under way.
    void start(const QString& program, const QStringList& arguments, Seconds wall_limit);
    /// Ends the run; `ended` follows when its process is gone.
    void stop();
    Seconds wall() const { return wall_; } ///< wall time that the last run took; valid after `ended`

signals:
    void ended(const usar::campaign::ProcessEnd& end);

private:
    void read();
    /// Asks the worker to end with what it flies, and insists after a while.
    void endWorker();
    /// The worker itself has ended, or could not be started.
    void workerEnded(bool started);
    void finish(const RunEnd& how);

    Worker worker_;
    QProcess process_;
    QTimer limit_;
    QTimer patience_; ///< with a worker that is to end
    QElapsedTimer since_start_;
    Seconds wall_{0.0};
    int number_ = 0; ///< the last request's number
    bool flying_ = false;
    ProcessEnd end_; ///< filled while the run is under way
};

} // namespace usar::campaign
