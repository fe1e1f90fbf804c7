#include <QTest>

#include "core/base/result.h"
#include "tests/suite/suite.h"

namespace tst_result {

using namespace usar;

class tst_Result : public QObject {
    Q_OBJECT
private slots:
    void anErrorReadsAsSentences_data();
    void anErrorReadsAsSentences();
};

void tst_Result::anErrorReadsAsSentences_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("where");
    QTest::addColumn<QString>("mend");
    QTest::addColumn<QString>("text");
    QTest::newRow("all three") << "the area has no size"
                               << "m.json:3:9"
                               << "make it larger"
                               << "m.json:3:9: the area has no size. Make it larger.";
    QTest::newRow("without a mend") << "the disk is full"
                                    << "/data"
                                    << ""
                                    << "/data: the disk is full.";
    QTest::newRow("without a place") << "there is no link"
                                     << ""
                                     << "Connect first"
                                     << "There is no link. Connect first.";
    QTest::newRow("a question as mend") << "no answer"
                                        << "10.0.0.5:3000"
                                        << "is USARSim running there?"
                                        << "10.0.0.5:3000: no answer. Is USARSim running there?";
    QTest::newRow("stops are not doubled") << "It closed."
                                           << "server"
                                           << "Start it."
                                           << "server: It closed. Start it.";
}

void tst_Result::anErrorReadsAsSentences() {
    QFETCH(QString, what);
    QFETCH(QString, where);
    QFETCH(QString, mend);
    QFETCH(QString, text);
    const Error error{what.toStdString(), where.toStdString(), mend.toStdString()};
    QCOMPARE(QString::fromStdString(error.text()), text);
}

USAR_TEST(tst_Result)

} // namespace tst_result

#include "tst_result.moc"
