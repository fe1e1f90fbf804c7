#include <QTest>

#include "core/campaign/runs/run_request.h"
#include "tests/suite/suite.h"

namespace tst_run_request {

using namespace usar::campaign;

class tst_RunRequest : public QObject {
    Q_OBJECT
private slots:
    void argumentsComeAsTheyWere() {
        const QStringList arguments{"run", "/a b/c%20d.json", "--fault", "wind speed=4\nfrom=60", "--set",
                                    "",    "\u00e9"};
        const QByteArray line = write(RunRequest{12, arguments});
        QVERIFY(line.endsWith('\n') && line.count('\n') == 1);
        QVERIFY((readRunRequest(line) == RunRequest{12, arguments}));
    }

    void theEndIsTakenOffWhatWasWritten_data() {
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<QByteArray>("left");
        QTest::addColumn<bool>("ended");
        QTest::addColumn<bool>("by_signal");
        QTest::addColumn<int>("code");
        QTest::newRow("done") << QByteArray("{\"a\":1}\n\nended 3 0\n") << QByteArray("{\"a\":1}\n") << true << false
                              << 0;
        QTest::newRow("failed, in the middle of a line")
            << QByteArray("{\"a\nended 3 127\n") << QByteArray("{\"a") << true << false << 127;
        QTest::newRow("by a signal") << QByteArray("\nended 3 by 11\n") << QByteArray() << true << true << 11;
        QTest::newRow("nothing yet") << QByteArray() << QByteArray() << false << false << 0;
        QTest::newRow("not yet all of it")
            << QByteArray("x\nended 3 by 1") << QByteArray("x\nended 3 by 1") << false << false << 0;
        QTest::newRow("a word of the run's own")
            << QByteArray("\nended 3 well\n") << QByteArray("\nended 3 well\n") << false << false << 0;
        QTest::newRow("another run's") << QByteArray("\nended 2 0\n") << QByteArray("\nended 2 0\n") << false << false
                                       << 0;
        QTest::newRow("somebody writes after it")
            << QByteArray("a\nended 3 1\nx") << QByteArray("a") << true << false << 1;
    }
    void theEndIsTakenOffWhatWasWritten() {
        QFETCH(QByteArray, written);
        QFETCH(QByteArray, left);
        QFETCH(bool, ended);
        QFETCH(bool, by_signal);
        QFETCH(int, code);
        const auto end = takeRunEnd(written, 3);
        QCOMPARE(end.has_value(), ended);
        QCOMPARE(written, left);
        if (ended)
            QVERIFY((*end == RunEnd{by_signal, code}));
    }

    void whatIsWrittenIsTaken() {
        for (const RunEnd& end : {RunEnd{}, RunEnd{false, 1}, RunEnd{true, 9}}) {
            QByteArray written = "half a line" + write(5, end);
            QVERIFY(takeRunEnd(written, 5) == end);
            QCOMPARE(written, QByteArray("half a line"));
        }
    }
};

USAR_TEST(tst_RunRequest)

} // namespace tst_run_request

#include "tst_run_request.moc"
