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
    } else if (end.code == mission::Done) {
        result.outcome = Outcome::Done;
    } else {
        result.outcome = end.code == mission::MissionFailed ? Outcome::Failed : Outcome::Refused;
    }
}

RunProcess::RunProcess(QObject* parent) : QObject(parent) {
    limit_.setSingleShot(true);
    connect(&limit_, &QTimer::timeout, this, [this] {
        end_.timed_out = true;
        process_.kill();
    });
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
    process_.kill();
    process_.waitForFinished();
}

void RunProcess::start(const QString& program, const QStringList& arguments, Seconds wall_limit) {
    flying_ = true;
    end_ = {};
    since_start_.start();
    constexpr double longest_ms = std::numeric_limits<int>::max();
    limit_.start(static_cast<int>(std::min(longest_ms, wall_limit.count() * 1000.0)));
    if (process_.state() == QProcess::NotRunning)
        process_.start(program, {worker_verb});
    process_.write(writeRunRequest(arguments));
}

void RunProcess::stop() {
    end_.stopped = true;
    process_.kill();
}

/// The run has ended when both streams say so.
void RunProcess::read() {
    end_.output += process_.readAllStandardOutput();
    end_.complaints += process_.readAllStandardError();
    QByteArray output = end_.output;
    QByteArray complaints = end_.complaints;
    const auto how = takeRunEnd(output);
    if (!flying_ || !how || !takeRunEnd(complaints))
        return;
    end_.output = output;
    end_.complaints = complaints;
    finish(*how);
}

void RunProcess::workerEnded(bool started) {
    if (!flying_)
        return;
    end_.output += process_.readAllStandardOutput();
    end_.complaints += started ? process_.readAllStandardError() : process_.errorString().toUtf8();
    finish({started && process_.exitStatus() == QProcess::CrashExit, process_.exitCode()});
}

void RunProcess::finish(const RunEnd& how) {
    limit_.stop();
    flying_ = false;
    wall_ = Seconds{static_cast<double>(since_start_.nsecsElapsed()) * 1e-9};
    static_cast<RunEnd&>(end_) = how;
    emit ended(end_);
}

} // namespace usar::campaign
