#include "core/campaign/runs/run_process.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <limits>

#include <sys/prctl.h>
#include <unistd.h>

#include <QJsonDocument>

#include "core/mission/runs/mission_runner.h"

namespace usar::campaign {

namespace {

constexpr int patience_ms = 5000; ///< with a worker that is to end

/// The last line that is not empty.
QByteArray lastLine(const QByteArray& text) {
    const QByteArray trimmed = text.trimmed();
    return trimmed.mid(trimmed.lastIndexOf('\n') + 1);
}

std::string withLastWords(const std::string& what, const QByteArray& complaints) {
    const std::string words = lastLine(complaints).left(300).toStdString();
    return words.empty() ? what : what + ": " + words;
}

/// A signal that somebody else sends, such as the kernel where memory runs out.
bool comesFromOutside(int signal) {
    return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

void judgeSignal(RunResult& result, const ProcessEnd& end) {
    const std::string signal = ::strsignal(end.code);
    if (end.complaints.contains("bad_alloc")) {
        result.outcome = Outcome::OutOfMemory;
        result.reason = "The program could get no more memory.";
    } else if (comesFromOutside(end.code)) {
        result.outcome = Outcome::Killed;
        result.reason = "Something ended the program (" + signal + ").";
    } else {
        result.outcome = Outcome::Crashed;
        result.reason = withLastWords("The program crashed (" + signal + ")", end.complaints);
    }
}

} // namespace

void judge(RunResult& result, const ProcessEnd& end) {
    result.summary = QJsonDocument::fromJson(lastLine(end.output)).object();
    result.reason = result.summary.value("reason").toString().toStdString();
    if (end.timed_out) {
        result.outcome = Outcome::TimedOut;
        result.reason = "The run took longer than the campaign's limit of wall time.";
    } else if (end.by_signal) {
        judgeSignal(result, end);
    } else if (result.summary.isEmpty()) {
        result.outcome = Outcome::Crashed;
        result.reason = withLastWords("The program ended without a result", end.complaints);
    } else if (result.reason.find(mission::interrupted_reason) != std::string::npos) {
        result.outcome = Outcome::Killed; // The campaign takes no result of a run that it stops itself.
    } else if (end.code == mission::Done) {
        result.outcome = Outcome::Done;
    } else {
        result.outcome = end.code == mission::MissionFailed ? Outcome::Failed : Outcome::Refused;
    }
}

RunProcess::RunProcess(Worker worker) : worker_(worker) {
    limit_.setSingleShot(true);
    connect(&limit_, &QTimer::timeout, this, [this] {
        end_.timed_out = true;
        endWorker();
    });
    patience_.setSingleShot(true);
    patience_.setInterval(patience_ms);
    connect(&patience_, &QTimer::timeout, &process_, &QProcess::kill);
    connect(&process_, &QProcess::readyReadStandardOutput, this, &RunProcess::read);
    connect(&process_, &QProcess::readyReadStandardError, this, &RunProcess::read);
    connect(&process_, &QProcess::finished, this, [this] { workerEnded(true); });
    connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            workerEnded(false);
    });
    process_.setChildProcessModifier([] {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        ::setpgid(0, 0); // Ctrl+C is for the campaign, which does not count a run that it interrupts.
    });
}

RunProcess::~RunProcess() {
    process_.disconnect(this);
    if (process_.state() == QProcess::NotRunning)
        return;
    process_.terminate(); // It removes its copies of plugins.
    if (!process_.waitForFinished(patience_ms)) {
        process_.kill();
        process_.waitForFinished();
    }
}

void RunProcess::start(const QString& program, const QStringList& arguments, Seconds wall_limit) {
    if (process_.state() != QProcess::NotRunning)
        process_.waitForFinished(0); // It may have been killed without anybody having noticed yet.
    flying_ = true;
    end_ = {};
    since_start_.start();
    constexpr double longest_ms = std::numeric_limits<int>::max();
    limit_.start(static_cast<int>(std::min(longest_ms, wall_limit.count() * 1000.0)));
    if (process_.state() == QProcess::NotRunning)
        process_.start(program, {worker_verb});
    process_.write(write(RunRequest{++number_, arguments}));
    if (worker_ == Worker::FliesOnce)
        process_.closeWriteChannel();
}

void RunProcess::stop() {
    end_.stopped = true;
    endWorker();
}

void RunProcess::endWorker() {
    process_.terminate();
    patience_.start();
}

/// The run has ended when both streams say so. A worker that is to end with it is awaited.
void RunProcess::read() {
    end_.output += process_.readAllStandardOutput();
    end_.complaints += process_.readAllStandardError();
    QByteArray output = end_.output;
    QByteArray complaints = end_.complaints;
    if (!flying_ || worker_ == Worker::FliesOnce || end_.timed_out || end_.stopped)
        return;
    const auto how = takeRunEnd(output, number_);
    if (!how || !takeRunEnd(complaints, number_))
        return;
    end_.output = output;
    end_.complaints = complaints;
    finish(*how);
}

void RunProcess::workerEnded(bool started) {
    patience_.stop();
    if (!flying_)
        return;
    end_.output += process_.readAllStandardOutput();
    end_.complaints += started ? process_.readAllStandardError() : process_.errorString().toUtf8();
    const auto how = takeRunEnd(end_.output, number_);
    takeRunEnd(end_.complaints, number_);
    const RunEnd of_worker{started && process_.exitStatus() == QProcess::CrashExit, process_.exitCode()};
    finish(how.value_or(of_worker));
}

void RunProcess::finish(const RunEnd& how) {
    limit_.stop();
    flying_ = false;
    wall_ = Seconds{static_cast<double>(since_start_.nsecsElapsed()) * 1e-9};
    static_cast<RunEnd&>(end_) = how;
    emit ended(end_);
}

} // namespace usar::campaign
