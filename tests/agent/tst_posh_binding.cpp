// Plans are checked against a robot's senses and acts, all at once, and each finding says what to write.
#include <QTest>

#include "core/agent/posh/posh_binding.h"
#include "core/posh/language/plan_reader.h"
#include "tests/agent/toy_rover.h"
#include "tests/suite/suite.h"

namespace tst_posh_binding {

using namespace usar;
using namespace usar::agent;

class tst_PoshBinding : public QObject {
    Q_OBJECT
private slots:
    void findsWhatDoesNotFit_data();
    void findsWhatDoesNotFit();
    void realTimeThatIsNotKeptIsRemarked_data();
    void realTimeThatIsNotKeptIsRemarked();
    void listsAllUnknownNamesAtOnce();
    void plansThatFitGiveAProgram_data();
    void plansThatFitGiveAProgram();
    void theRegistryDescribesWithoutARobot();
};

void tst_PoshBinding::findsWhatDoesNotFit_data() {
    QTest::addColumn<QByteArray>("plan");
    QTest::addColumn<QString>("finding"); // place and code; then what the message must say
    QTest::addColumn<QString>("says");
    QTest::newRow("no drives") << QByteArray("((AP p (Halt)))") << "E303"
                               << "(DC name (drives";
    QTest::newRow("unknown act") << QByteArray("((DC d (drives ((a Hlat)))))") << "1:20: error E304"
                                 << "Halt";
    QTest::newRow("unknown act in another case") << QByteArray("((DC d (drives ((a halt)))))") << "E304"
                                                 << "Halt";
    QTest::newRow("unknown sense") << QByteArray("((DC d (drives ((a (trigger ((Arived))) Halt)))))")
                                   << "1:31: error E304"
                                   << "did you mean Arrived?";
    QTest::newRow("nothing is similar") << QByteArray("((DC d (drives ((a Xyzzy)))))") << "E304"
                                        << "write one that it has";
    QTest::newRow("form with the name of an act")
        << QByteArray("((AP Halt (Tick)) (DC d (drives ((a Halt)))))") << "1:6: error E305"
        << "another name";
    QTest::newRow("sense as act") << QByteArray("((DC d (drives ((a Arrived)))))") << "1:20: error E307"
                                  << "is a sense";
    QTest::newRow("act as sense") << QByteArray("((DC d (drives ((a (trigger ((Halt))) Tick)))))") << "1:31: error E307"
                                  << "is an act";
    QTest::newRow("form as sense") << QByteArray("((AP p (Halt)) (DC d (drives ((a (trigger ((p))) p)))))") << "E307"
                                   << "is a form";
    QTest::newRow("argument too many") << QByteArray("((DC d (drives ((a Halt(1))))))") << "E307"
                                       << "takes 0 arguments";
    QTest::newRow("argument of an unknown name") << QByteArray("((DC d (drives ((a DriveFor($tim=1))))))") << "E307"
                                                 << "$tim";
    QTest::newRow("text for a number") << QByteArray("((DC d (drives ((a DriveFor(\"long\"))))))") << "E307"
                                       << "a number from 0 to 60 s, not \"long\"";
    QTest::newRow("out of range") << QByteArray("((DC d (drives ((a DriveFor(61))))))") << "E307"
                                  << "from 0 to 60 s";
    QTest::newRow("no such choice") << QByteArray("((DC d (drives ((a Turn('up))))))") << "E307"
                                    << "one of 'left, 'right";
    QTest::newRow("wrong through a parameter")
        << QByteArray("((AP p vars($t=1) (DriveFor($t))) (DC d (drives ((a p('far))))))") << "1:20: error E307"
        << "not 'far";
}

void tst_PoshBinding::realTimeThatIsNotKeptIsRemarked_data() {
    QTest::addColumn<QByteArray>("keyword");
    QTest::addColumn<bool>("remarked");
    QTest::newRow("DC") << QByteArray("DC") << false;
    QTest::newRow("SDC") << QByteArray("SDC") << false;
    QTest::newRow("RDC") << QByteArray("RDC") << true;
    QTest::newRow("SRDC") << QByteArray("SRDC") << true;
}

void tst_PoshBinding::realTimeThatIsNotKeptIsRemarked() {
    QFETCH(QByteArray, keyword);
    QFETCH(bool, remarked);
    const std::string text = "((" + keyword.toStdString() + " d (drives ((a Halt)))))";
    const std::string remark = clockRemark(posh::readPlan(text).plan);
    QCOMPARE(remark.find("robot's clock") != std::string::npos, remarked);
    QCOMPARE(remark.empty(), !remarked);
    QVERIFY(bindPlan(text, test::toyRegistry().descriptions()).program); // it is no fault
}

void tst_PoshBinding::findsWhatDoesNotFit() {
    QFETCH(QByteArray, plan);
    QFETCH(QString, finding);
    QFETCH(QString, says);
    const PlanForRobot bound = bindPlan(plan.toStdString(), test::toyRegistry().descriptions());
    QVERIFY(!bound.program);
    QString errors;
    for (const posh::Finding& found : bound.findings)
        if (posh::severityOf(found.code) == Severity::Error)
            errors += QString::fromStdString(posh::toText(found)) + "\n";
    QVERIFY2(errors.contains(finding) && errors.contains(says), qPrintable(errors));
    QCOMPARE(errors.count('\n'), 1);
}

void tst_PoshBinding::listsAllUnknownNamesAtOnce() {
    const PlanForRobot bound = bindPlan("((DC d (drives ((a (trigger ((One) (Two))) Three)) ((b Three)))))",
                                        test::toyRegistry().descriptions());
    QCOMPARE(bound.findings.size(), std::size_t(4));
}

void tst_PoshBinding::plansThatFitGiveAProgram_data() {
    QTest::addColumn<QByteArray>("plan");
    QTest::newRow("a whole number for a real") << QByteArray("((DC d (drives ((a DriveFor(2))))))");
    QTest::newRow("by name") << QByteArray("((DC d (drives ((a DriveFor($time=2.5))))))");
    QTest::newRow("a default") << QByteArray("((DC d (drives ((a DriveFor)))))");
    QTest::newRow("an enumeration constant") << QByteArray("((DC d (drives ((a Turn('java.Side.right))))))");
    QTest::newRow("a text for a symbol") << QByteArray("((DC d (drives ((a Turn(\"right\"))))))");
    QTest::newRow("built-in senses and act")
        << QByteArray("((DC d (drives ((a (trigger ((succeed) (fail false) "
                      "(cz.cuni.amis.pogamut.sposh.executor.Succeed))) doNothing)))))");
    QTest::newRow("sense with argument") << QByteArray("((DC d (drives ((a (trigger ((Closer(2)))) Halt)))))");
}

void tst_PoshBinding::plansThatFitGiveAProgram() {
    QFETCH(QByteArray, plan);
    const PlanForRobot bound = bindPlan(plan.toStdString(), test::toyRegistry().descriptions());
    for (const posh::Finding& found : bound.findings)
        qInfo("%s", posh::toText(found).c_str());
    QVERIFY(bound.program);
}

void tst_PoshBinding::theRegistryDescribesWithoutARobot() {
    const PoshRegistry registry = test::toyRegistry();
    const PrimitiveDescription& nearest = registry.find("Nearest")->description;
    QCOMPARE(nearest.kind, PrimitiveKind::Sense);
    QCOMPARE(nearest.answer, AnswerType::Real);
    QCOMPARE(nearest.unit, std::string("m"));
    QCOMPARE(nearest.needs, std::vector<std::string>{"RangeScanner"});
    QCOMPARE(registry.find("Arrived")->description.answer, AnswerType::Boolean);
    QCOMPARE(registry.find("Turn")->description.parameters.front().choices.size(), std::size_t(2));
    QVERIFY(!registry.find("Fly"));
}

USAR_TEST(tst_PoshBinding)

} // namespace tst_posh_binding

#include "tst_posh_binding.moc"
