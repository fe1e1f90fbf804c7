#include <QTest>

#include "core/mission/files/report_options.h"
#include "tests/suite/suite.h"

namespace tst_report_options {

using namespace usar;
using namespace usar::mission;

class tst_ReportOptions : public QObject {
    Q_OBJECT
private slots:
    void plansAreCheckedAloneOrForARobot_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<CheckPlanOptions>("expected");
        QTest::newRow("one") << QStringList{"a.lap"} << CheckPlanOptions{{}, {"a.lap"}};
        QTest::newRow("standard input among others")
            << QStringList{"a", "-", "b"} << CheckPlanOptions{{}, {"a", "-", "b"}};
        QTest::newRow("a robot first") << QStringList{"--robot", "ERS", "a"} << CheckPlanOptions{"ERS", {"a"}};
        QTest::newRow("a robot last") << QStringList{"a", "--robot=airrobot/posh"}
                                      << CheckPlanOptions{"airrobot/posh", {"a"}};
        QTest::newRow("a file like an option") << QStringList{"--", "--robot"} << CheckPlanOptions{{}, {"--robot"}};
    }

    void plansAreCheckedAloneOrForARobot() {
        QFETCH(QStringList, arguments);
        QFETCH(CheckPlanOptions, expected);
        const auto options = readCheckPlanOptions(QStringList{"check-plan"} + arguments);
        QVERIFY2(options, options ? "" : options.error().text().c_str());
        QVERIFY(*options == expected);
    }

    void reportsAreTextOrJson_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<PlanReportOptions>("expected");
        QTest::newRow("text") << QStringList{"a", "b"} << PlanReportOptions{false, {"a", "b"}};
        QTest::newRow("JSON") << QStringList{"--json", "a"} << PlanReportOptions{true, {"a"}};
        QTest::newRow("JSON, said last") << QStringList{"a", "--json"} << PlanReportOptions{true, {"a"}};
    }

    void reportsAreTextOrJson() {
        QFETCH(QStringList, arguments);
        QFETCH(PlanReportOptions, expected);
        const auto options = readPlanReportOptions(QStringList{"plan-report"} + arguments);
        QVERIFY2(options, options ? "" : options.error().text().c_str());
        QVERIFY(*options == expected);
    }

    void linesAreOfOneFile() {
        QCOMPARE(*readLinesFile({"lines", "a.txt"}), QString("a.txt"));
        QCOMPARE(*readLinesFile({"lines", "-"}), QString("-"));
    }

    void rejectsTheRestAndSaysHow_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        const QString check = "Write usar-mission check-plan FILE";
        const QString report = "Write usar-mission plan-report";
        const QString lines = "Write usar-mission lines FILE";
        QTest::newRow("no plan") << QStringList{"check-plan"} << check;
        QTest::newRow("a robot without a name")
            << QStringList{"check-plan", "a", "--robot"} << "--robot: the value is missing. " + check;
        QTest::newRow("an unknown option")
            << QStringList{"check-plan", "--colour", "a"} << "--colour: there is no such option. " + check;
        QTest::newRow("an unknown letter") << QStringList{"check-plan", "-x", "a"} << "-x: there is no such option";
        QTest::newRow("no recording") << QStringList{"plan-report", "--json"} << report;
        QTest::newRow("a value for a flag")
            << QStringList{"plan-report", "--json=yes", "a"} << "--json: this option takes no value. " + report;
        QTest::newRow("an option with a slip") << QStringList{"plan-report", "--jsn", "a"} << "--jsn: there is no such";
        QTest::newRow("recordings from standard input") << QStringList{"plan-report", "-"} << report;
        QTest::newRow("no lines") << QStringList{"lines"} << lines;
        QTest::newRow("two files of lines") << QStringList{"lines", "a", "b"} << lines;
        QTest::newRow("lines with an option") << QStringList{"lines", "--robot"} << lines;
    }

    void rejectsTheRestAndSaysHow() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        std::string error;
        const auto note = [&error](const auto& read) {
            if (!read)
                error = read.error().text();
        };
        if (arguments.first() == "check-plan")
            note(readCheckPlanOptions(arguments));
        else if (arguments.first() == "plan-report")
            note(readPlanReportOptions(arguments));
        else
            note(readLinesFile(arguments));
        QVERIFY2(QString::fromStdString(error).contains(words), error.c_str());
    }
};

USAR_TEST(tst_ReportOptions)

} // namespace tst_report_options

#include "tst_report_options.moc"
