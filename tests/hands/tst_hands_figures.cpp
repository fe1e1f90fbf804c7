// Instruments tell whose figures they show, and show no others.
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_figures {

using namespace usar::hands;

class tst_HandsFigures : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void aSecondRobotDoesNotShowTheFiguresOfTheFirst();
    void theFiguresOfTheFirstComeBackWithIt();
    void instrumentsNameTheirRobot();

private:
    Program program_;
};

void tst_HandsFigures::initTestCase() {
    QVERIFY2(program_.trouble().isEmpty(), qPrintable(program_.trouble()));
    QVERIFY(program_.spawnByKeys("PlayerStart", "R1"));
    QVERIFY(program_.fly());
}

void tst_HandsFigures::aSecondRobotDoesNotShowTheFiguresOfTheFirst() {
    QVERIFY(program_.number("flown") > 0.0);
    QVERIFY(program_.spawnByKeys("HillTop", "R2"));
    QTRY_VERIFY2_WITH_TIMEOUT(program_.row("R2").contains("idle"), qPrintable(program_.row("R2")), 30000);
    for (const QString& name : QStringList{"flown", "range left"})
        QTRY_COMPARE_WITH_TIMEOUT(program_.figure(name), QStringLiteral("– m"), 10000);
    for (const QString& name : QStringList{"elapsed", "charges"})
        QTRY_COMPARE_WITH_TIMEOUT(program_.figure(name).trimmed(), QStringLiteral("–"), 10000);
    program_.screenshot("second_robot");
}

void tst_HandsFigures::theFiguresOfTheFirstComeBackWithIt() {
    QVERIFY(program_.lookAtWorld());
    program_.desk().key("1");
    QTRY_VERIFY_WITH_TIMEOUT(program_.number("flown") > 0.0, 30000);
}

void tst_HandsFigures::instrumentsNameTheirRobot() {
    QVERIFY(program_.lookAtWorld());
    for (const QString& number : QStringList{"2", "1"}) {
        program_.desk().key(number);
        QVERIFY2(program_.says("Status of R" + number), qPrintable("It does not name R" + number));
    }
}

USAR_TEST(tst_HandsFigures)

} // namespace tst_hands_figures

#include "tst_hands_figures.moc"
