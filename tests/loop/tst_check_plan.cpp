#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include "core/agent/posh/posh_binding.h"
#include "core/posh/language/plan_reader.h"
#include "tests/suite/suite.h"

namespace tst_check_plan {

using namespace usar;

/// The verb of the program: what it prints, and how it exits.
class tst_CheckPlan : public QObject {
    Q_OBJECT
private slots:
    void exitsByTheWorstOfItsFiles_data();
    void exitsByTheWorstOfItsFiles();
    void printsOneObjectForEachFinding();
    void saysWhatTheWindowSaysOfRealTime_data();
    void saysWhatTheWindowSaysOfRealTime();
    void readsStandardInput();
    void thePlanOfThePageFitsItsRobot();
};

namespace {

const QString program = QString(USAR_BINARY_DIR) + "/bin/usar-mission";
const QString plans = QString(USAR_SOURCE_DIR) + "/tests/data/posh/";
constexpr int patience_ms = 60000;

struct Ended {
    int exit_code = -1;
    QByteArray out;
    QByteArray err;
};

Ended run(const QStringList& arguments, const QByteArray& input = {}) {
    QProcess process;
    process.start(program, QStringList{"check-plan"} + arguments);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(patience_ms))
        return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

void tst_CheckPlan::exitsByTheWorstOfItsFiles_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exit_code");
    QTest::addColumn<QString>("complaint");
    const QString sound = plans + "valid/tour.lap";
    const QString survey = QString(USAR_SOURCE_DIR) + "/resources/plans/airrobot.lap";
    const QString broken = plans + "malformed/bare-unit.lap";
    QTest::newRow("a sound plan") << QStringList{sound} << 0 << "";
    QTest::newRow("a broken plan among sound ones") << QStringList{sound, broken, sound} << 1 << "";
    QTest::newRow("a file that is not there") << QStringList{plans + "none.lap", broken} << 2 << "none.lap";
    QTest::newRow("a folder") << QStringList{plans} << 2 << "tests/data/posh";
    QTest::newRow("no file") << QStringList{} << 2 << "usar-mission check-plan FILE";
    QTest::newRow("a plan of another robot") << QStringList{"--robot", "AirRobot", sound} << 1 << "";
    QTest::newRow("a plan of the robot") << QStringList{"--robot=airrobot/posh", survey} << 0 << "";
    QTest::newRow("an unknown robot") << QStringList{"--robot", "AirRobt", sound} << 2 << "Choose one of AirRobot";
    QTest::newRow("a robot without a name") << QStringList{sound, "--robot"} << 2 << "usar-mission check-plan FILE";
    QTest::newRow("an unknown option") << QStringList{"--colour", sound} << 2 << "usar-mission check-plan FILE";
}

void tst_CheckPlan::exitsByTheWorstOfItsFiles() {
    QFETCH(QStringList, arguments);
    QFETCH(int, exit_code);
    QFETCH(QString, complaint);
    const Ended ended = run(arguments);
    QCOMPARE(ended.exit_code, exit_code);
    QCOMPARE(ended.err.contains("usar-mission: "), !complaint.isEmpty()); // Qt may have something to say, too
    QVERIFY2(QString::fromUtf8(ended.err).contains(complaint), ended.err);
}

void tst_CheckPlan::printsOneObjectForEachFinding() {
    const QString file = plans + "malformed/bare-unit.lap";
    const Ended ended = run({file});
    QCOMPARE(ended.out.count('\n'), 1);
    const QJsonObject finding = QJsonDocument::fromJson(ended.out).object();
    QCOMPARE(finding["code"].toString(), QString("E213"));
    QCOMPARE(finding["line"].toInt(), 1);
    QCOMPARE(finding["column"].toInt(), 25);
    QCOMPARE(finding["file"].toString(), file);
}

void tst_CheckPlan::saysWhatTheWindowSaysOfRealTime_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("as a plan of any robot") << QStringList{"-"};
    QTest::newRow("as the plan of one robot") << QStringList{"--robot", "AirRobot", "-"};
}

void tst_CheckPlan::saysWhatTheWindowSaysOfRealTime() {
    QFETCH(QStringList, arguments);
    const QByteArray plan = "(\n  (RDC d (drives ((a doNothing)))))";
    const Ended ended = run(arguments, plan);
    QCOMPARE(ended.exit_code, 0);
    QCOMPARE(ended.out.count('\n'), 1);
    const QJsonObject note = QJsonDocument::fromJson(ended.out).object();
    QCOMPARE(note["code"].toString(), QString("N501"));
    QCOMPARE(note["severity"].toString(), QString("note"));
    QCOMPARE(note["line"].toInt(), 2);
    QCOMPARE(note["column"].toInt(), 3);
    const std::string of_the_window = agent::clockRemark(posh::readPlan(plan.toStdString()).plan);
    QCOMPARE(note["message"].toString(), QString::fromStdString(of_the_window));
}

void tst_CheckPlan::readsStandardInput() {
    const Ended ended = run({"-"}, "((DC d (drives ())))");
    QCOMPARE(ended.exit_code, 1);
    QVERIFY(ended.out.contains("\"file\":\"-\""));
}

void tst_CheckPlan::thePlanOfThePageFitsItsRobot() {
    QFile page(QString(USAR_SOURCE_DIR) + "/resources/docs/plans.md");
    QVERIFY(page.open(QIODevice::ReadOnly));
    const QByteArray text = page.readAll();
    const qsizetype begin = text.indexOf("```lisp\n") + 8;
    const QByteArray plan = text.mid(begin, text.indexOf("```", begin) - begin);
    QVERIFY(plan.contains("lookout"));
    const Ended ended = run({"--robot", "AirRobot", "-"}, plan);
    QVERIFY2(ended.exit_code == 0 && ended.out.isEmpty(), ended.out + ended.err);
}

USAR_TEST(tst_CheckPlan)

} // namespace tst_check_plan

#include "tst_check_plan.moc"
