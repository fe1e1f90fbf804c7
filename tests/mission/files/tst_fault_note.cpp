// Sentences about faults, and which faults still hold.
#include <QTest>

#include "core/mission/files/fault_note.h"
#include "tests/suite/suite.h"

namespace tst_fault_note {

using namespace usar;
using namespace usar::mission;

class tst_FaultNote : public QObject {
    Q_OBJECT
private slots:
    void aSentenceIsTakenApart_data() {
        QTest::addColumn<QString>("sentence");
        QTest::addColumn<double>("time_s");
        QTest::addColumn<bool>("begins");
        QTest::addColumn<QString>("fault");
        QTest::newRow("begins") << "60.2 s: fault begins: wind speed=5 from=60" << 60.2 << true
                                << "wind speed=5 from=60";
        QTest::newRow("ends") << "0.0 s: fault ends: gps lost" << 0.0 << false << "gps lost";
    }
    void aSentenceIsTakenApart() {
        QFETCH(const QString, sentence);
        const auto note = readFaultNote(sentence.toStdString());
        QVERIFY(note);
        QTEST(note->time.count(), "time_s");
        QTEST(note->begins, "begins");
        QTEST(QString::fromStdString(note->fault), "fault");
    }

    void otherSentencesSayNothing() {
        for (const char* text :
             {"", "wind", "x s: fault begins: wind", "60.2 s: ", "60.2 s: fault begins", ": s: a: b"})
            QVERIFY2(!readFaultNote(text), text);
    }

    void aFaultHoldsUntilItEnds() {
        StandingFaults faults;
        faults.take("1.0 s: fault begins: wind speed=5");
        faults.take("nonsense");
        faults.take("2.0 s: fault begins: gps lost");
        faults.take("3.0 s: fault begins: gps lost");
        faults.take("4.0 s: fault ends: gps lost");
        faults.take("4.0 s: fault ends: another");
        QCOMPARE(faults.sentences(),
                 (std::vector<std::string>{"1.0 s: fault begins: wind speed=5", "3.0 s: fault begins: gps lost"}));
    }
};

USAR_TEST(tst_FaultNote)

} // namespace tst_fault_note

#include "tst_fault_note.moc"
