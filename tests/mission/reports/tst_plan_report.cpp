#include <QBuffer>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "core/mission/reports/plan_report.h"
#include "tests/suite/suite.h"

namespace tst_plan_report {

using namespace usar;
using namespace usar::mission;

namespace {

struct Report {
    bool sound = false;
    QList<QJsonObject> findings;
};

Report reportOn(QByteArray plan) {
    QBuffer input(&plan);
    QByteArray printed;
    QBuffer output(&printed);
    if (!input.open(QIODevice::ReadOnly) || !output.open(QIODevice::WriteOnly))
        return {};
    Report report{reportPlan(input, "a.lap", output).value(), {}};
    for (const QByteArray& line : printed.split('\n'))
        if (!line.isEmpty())
            report.findings << QJsonDocument::fromJson(line).object();
    return report;
}

} // namespace

class tst_PlanReport : public QObject {
    Q_OBJECT
private slots:
    void aSoundPlanHasNothingToSay() {
        const Report report = reportOn("((DC d (drives ((a act)))))");
        QVERIFY(report.sound);
        QVERIFY(report.findings.isEmpty());
    }

    void aFindingHasItsCodePlaceAndFile() {
        const Report report =
            reportOn("(\n  (documentation \"\xC3\xA4\" \"b\")\n  (DC d (drives ((a act (days 2))))))");
        QVERIFY(!report.sound);
        QCOMPARE(report.findings.size(), 2);
        QCOMPARE(report.findings[0]["code"].toString(), QString("E207"));
        QCOMPARE(report.findings[0]["severity"].toString(), QString("error"));
        QCOMPARE(report.findings[0]["line"].toInt(), 2);
        QCOMPARE(report.findings[0]["column"].toInt(), 25);
        QCOMPARE(report.findings[0]["file"].toString(), QString("a.lap"));
        QVERIFY(!report.findings[0].contains("opener"));
        QCOMPARE(report.findings[1]["code"].toString(), QString("E209"));
        QVERIFY(report.findings[1]["message"].toString().contains("; write "));
    }

    void aWarningLeavesThePlanSound() {
        const Report report = reportOn("((AP p (act)))");
        QVERIFY(report.sound);
        QCOMPARE(report.findings.size(), 1);
        QCOMPARE(report.findings[0]["code"].toString(), QString("W401"));
        QCOMPARE(report.findings[0]["severity"].toString(), QString("warning"));
    }

    void realTimeThatIsNotKeptIsANote() {
        const Report report = reportOn("(\n ( srdc d (drives ((a act)))))");
        QVERIFY(report.sound);
        QCOMPARE(report.findings.size(), 1);
        const QJsonObject note = report.findings[0];
        QCOMPARE(note["code"].toString(), QString("N501"));
        QCOMPARE(note["severity"].toString(), QString("note"));
        QCOMPARE(note["line"].toInt(), 2);
        QCOMPARE(note["column"].toInt(), 2); // of the form
        QVERIFY(note["message"].toString().contains("robot's clock"));
    }

    void anOpenParenthesisIsNamed() {
        const Report report = reportOn("(\n (DC d (drives ((a act)))\n");
        QCOMPARE(report.findings.size(), 1);
        QCOMPARE(report.findings[0]["code"].toString(), QString("E203"));
        QCOMPARE(report.findings[0]["line"].toInt(), 3);
        QCOMPARE(report.findings[0]["opener"].toObject(), (QJsonObject{{"line", 2}, {"column", 2}}));
    }

    void aFileWithoutEndIsNoPlan() {
        QFile endless("/dev/zero");
        QVERIFY(endless.open(QIODevice::ReadOnly));
        QByteArray printed;
        QBuffer output(&printed);
        QVERIFY(output.open(QIODevice::WriteOnly));
        QCOMPARE(reportPlan(endless, "zero", output), Result<bool>(false));
        QVERIFY2(printed.contains("longer than 64 MiB"), printed);
    }

    void aFullDiskIsAnError() {
        QFile full("/dev/full");
        QVERIFY(full.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
        QByteArray plan = "(";
        QBuffer input(&plan);
        QVERIFY(input.open(QIODevice::ReadOnly));
        const auto reported = reportPlan(input, "a.lap", full);
        QVERIFY(!reported);
        QVERIFY(QString::fromStdString(reported.error().text()).contains("cannot be written"));
    }
};

USAR_TEST(tst_PlanReport)

} // namespace tst_plan_report

#include "tst_plan_report.moc"
