// A newcomer's first flight.
#include <QDir>
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_first_flight {

using namespace usar::hands;

class tst_HandsFirstFlight : public QObject {
    Q_OBJECT
private slots:
    void fiveGesturesLeadToAMap();
};

void tst_HandsFirstFlight::fiveGesturesLeadToAMap() {
    Program program;
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.says("Connected"));
    program.screenshot("start");
}

USAR_TEST(tst_HandsFirstFlight)

} // namespace tst_hands_first_flight

#include "tst_hands_first_flight.moc"
