// These tests say which lines of the embedded simulator's log become notices of the window.
#include <QTest>

#include "core/server/embedded/log_words.h"
#include "tests/suite/suite.h"

namespace tst_log_words {

class tst_LogWords : public QObject {
    Q_OBJECT
private slots:
    void connectionsHaveNoNumbers_data();
    void connectionsHaveNoNumbers();
};

void tst_LogWords::connectionsHaveNoNumbers_data() {
    QTest::addColumn<QString>("logged");
    QTest::addColumn<QString>("told");
    QTest::newRow("comes") << "client 4: connected"
                           << "";
    QTest::newRow("goes") << "client 12: gone"
                          << "";
    QTest::newRow("ignored") << "client 4: ignored 'HORN {Tune 1}'"
                             << "Simulator: ignored 'HORN {Tune 1}'";
    QTest::newRow("of no client") << "Port 5003 is in use."
                                  << "Port 5003 is in use.";
}

void tst_LogWords::connectionsHaveNoNumbers() {
    QFETCH(QString, logged);
    QFETCH(QString, told);
    QCOMPARE(usar::server::noticeOfLog(logged), told);
}

USAR_TEST(tst_LogWords)

} // namespace tst_log_words

#include "tst_log_words.moc"
