// The result of one run of a campaign, and its line in a shard file.
#pragma once

#include <optional>
#include <string>

#include <QByteArray>
#include <QJsonObject>
#include <QString>

#include "core/base/result.h"
#include "core/campaign/plan/planned_run.h"

namespace usar::campaign {

/// How a run ended. Only `Failed` says something of the robot: the process ended as it should, and the mission did not
/// succeed. The words in the file are those of `wordOf`.
enum class Outcome {
    Done,
    Failed,
    Refused,     ///< bad input: nothing was flown
    Crashed,     ///< the program ended by a signal of its own, or without a summary
    Killed,      ///< something else ended the program
    TimedOut,    ///< the campaign ended it at its limit of wall time
    OutOfMemory, ///< the program could get no more memory
};

QString wordOf(Outcome outcome);
std::optional<Outcome> outcomeFrom(const QString& word);

/// One line of a shard file. The summary is that of `usar-mission run`; empty if there is none.
struct RunResult {
    int number = 0;
    int pair = 0;
    std::string mission;
    std::string variant;
    std::uint64_t seed = 1;
    Outcome outcome = Outcome::Done;
    std::string reason; ///< in words
    double wall_s = 0.0;
    std::string version;             ///< of the program
    QString command;                 ///< flies the run again
    std::optional<double> limit_s{}; ///< of simulated time, if the campaign sets one
    QJsonObject summary;
    /// Set if the run was flown twice: names of the figures that differed, which is nothing if all is well.
    std::optional<QStringList> differences{};
    QStringList broken{}; ///< a sentence for each invariant that it breaks; empty if it is sound
};

/// How much of a line is read. The summary, which is nearly all of it, comes last.
enum class ResultPart { Head, Whole };

QByteArray toLine(const RunResult& result);
/// Reads a line, with or without its line end; without the summary if only the head is wanted. The error says what is
/// wrong with it, without a place.
Result<RunResult> readResultLine(const QByteArray& line, ResultPart part = ResultPart::Whole);

/// Names of the figures in which the summaries of two equal runs differ, apart from wall time and names of files.
QStringList differencesOf(const QJsonObject& summary, const QJsonObject& again);

} // namespace usar::campaign
