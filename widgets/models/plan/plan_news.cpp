#include "widgets/models/plan/plan_news.h"

#include <QObject>

#include "widgets/models/figures.h"

namespace usar::widgets {

using agent::PlanFate;

QString haltText(const QString& robot, const agent::PlanHalted& halted, bool lockstep) {
    const QString text = QObject::tr("%1 stands still: %2 · cycle %3, %4 s")
                             .arg(robot, QString::fromStdString(halted.reason))
                             .arg(halted.cycle)
                             .arg(figure(halted.time.count(), 1));
    return lockstep ? text : text + QObject::tr(". The robot has its safe command; the server's time goes on.");
}

PlanNewsText replacedText(const QString& robot, const agent::PlanReplaced& replaced) {
    const QString plan = QString::fromStdString(replaced.plan_name);
    if (replaced.fate == PlanFate::Kept)
        return {Severity::Note, QObject::tr("%1 goes on where it was, by %2.").arg(robot, plan)};
    if (replaced.fate == PlanFate::Restarted)
        return {Severity::Note, QObject::tr("%1 begins %2 at its root.").arg(robot, plan)};
    QString why = QString::fromStdString(replaced.reason);
    for (const posh::Finding& finding : replaced.findings)
        if (why.isEmpty() && posh::severityOf(finding.code) == Severity::Error)
            why = QString::fromStdString(posh::toText(finding));
    return {Severity::Error, QObject::tr("%1 does not take %2 and goes on as it did. %3").arg(robot, plan, why)};
}

} // namespace usar::widgets
