#include "core/campaign/runs/invariants.h"

#include <algorithm>

#include <QJsonArray>
#include <QRegularExpression>

namespace usar::campaign {

namespace {

/// The campaign ends a mission at its limit, which the tick under way may pass.
constexpr double limit_slack_s = 1.0;

void checkWords(const RunResult& result, QStringList& broken) {
    static const QRegularExpression sentence("\\w+ .*[.!?]$");
    if (!sentence.match(QString::fromStdString(result.reason)).hasMatch())
        broken << QString("The reason is no sentence: \"%1\".").arg(QString::fromStdString(result.reason));
}

/// Whether the robot met wind, against which nothing holds its place once nobody steers.
bool windBlew(const QJsonObject& summary) {
    const QJsonArray faults = summary["faults"].toArray();
    return std::any_of(faults.begin(), faults.end(),
                       [](const QJsonValue& fault) { return fault.toString().contains("fault begins: wind"); });
}

void checkFigures(const RunResult& result, QStringList& broken) {
    const QJsonObject& summary = result.summary;
    for (const char* share : {"coverage_pct", "reachable_coverage_pct"})
        if (const double pct = summary[share].toDouble(); pct < 0.0 || pct > 100.0)
            broken << QString("%1 is %2, which is no percentage.").arg(share).arg(pct);
    for (const char* amount : {"duration_s", "distance_m", "true_distance_m", "charges", "collisions", "cells"})
        if (const double value = summary[amount].toDouble(); value < 0.0)
            broken << QString("%1 is %2, though it cannot be negative.").arg(amount).arg(value);
    const double duration_s = summary["duration_s"].toDouble();
    if (result.limit_s && duration_s > *result.limit_s + limit_slack_s)
        broken << QString("It flew for %1 s, though its limit is %2 s.").arg(duration_s).arg(*result.limit_s);
    if (const int contacts = summary["contacts_after_stop"].toInt(); contacts != 0 && !windBlew(summary))
        broken << QString("It collided %1 times after it was stopped.").arg(contacts);
    if (summary["success"].toBool() != (result.outcome == Outcome::Done))
        broken << QString("Its summary and its exit code disagree on the success.");
    if (summary["success"].toBool() && !(duration_s > 0.0))
        broken << QString("It says that a mission of no duration succeeded.");
}

} // namespace

QStringList brokenInvariants(const RunResult& result) {
    QStringList broken;
    if (result.differences && !result.differences->isEmpty())
        broken << QString("It came out differently when it was flown again (%1).").arg(result.differences->join(", "));
    if (result.outcome == Outcome::Killed || result.outcome == Outcome::Refused)
        return broken;
    if (result.outcome == Outcome::Done || result.outcome == Outcome::Failed) {
        checkWords(result, broken);
        checkFigures(result, broken);
    } else {
        broken << QString("It ended as %1: %2").arg(wordOf(result.outcome), QString::fromStdString(result.reason));
    }
    return broken;
}

} // namespace usar::campaign
