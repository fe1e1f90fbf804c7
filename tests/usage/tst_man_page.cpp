// Pages as mandoc, an independent reader of them, takes them.
#include <QTest>

#include "core/usage/man_page.h"
#include "tests/suite/suite.h"
#include "tests/usage/small_program.h"

namespace tst_man_page {

using namespace usar::usage;
using namespace usar::usage_tests;

namespace {

QString shown(const Program& program) {
    return outputOf("mandoc", {"-T", "utf8", "-O", "width=100"}, manPage(program, "1.2.3", "2026-11-27"))
        .remove(QRegularExpression(".\b")); // Bold letters are struck twice.
}

} // namespace

class tst_ManPage : public QObject {
    Q_OBJECT
private slots:
    void itHasWhatAPageHas_data() {
        QTest::addColumn<QString>("part");
        for (const char* const part :
             {"TRY-IT(1)", "try-it - try what tables become", "try-it fly MISSION.json [options]",
              "try-it fly --again RECORDING", "'Tis a first paragraph.",
              ".TH would begin a page; a \\ is a backslash, … an ellipsis.", "how fast (1)", "--adjust on|off",
              "A note.", "EXIT STATUS", "fallen", "FILES", "usar-sim(1), usar-mission(1)", "USAR Mission Control 1.2.3",
              "2026-11-27"})
            QTest::newRow(part) << QString(part);
    }

    void itHasWhatAPageHas() {
        QFETCH(QString, part);
        static const QString page = shown(smallProgram());
        QVERIFY2(page.contains(part), qPrintable(page));
    }

    void nothingInItIsAWarning_data() {
        QTest::addColumn<Program>("program");
        QTest::newRow("with verbs") << smallProgram();
        QTest::newRow("without") << plainProgram();
    }

    void nothingInItIsAWarning() {
        QFETCH(Program, program);
        const QByteArray page = manPage(program, "1.2.3", "2026-11-27");
        QVERIFY(!page.isEmpty());
        QVERIFY(!outputOf("mandoc", {"-T", "ascii", "-W", "warning,stop"}, page).isEmpty());
        for (const char letter : page)
            QVERIFY(letter == '\n' || (letter >= ' ' && letter <= '~'));
    }

    void whatIsTypedIsBoldAndWhatStandsForSomethingIsNot() {
        const QByteArray page = manPage(smallProgram(), "1.2.3", "2026-11-27");
        QVERIFY2(page.contains("\\fB\\-\\-speed\\fR \\fIN\\fR|\\fBmax\\fR\n"), page);
        QVERIFY2(page.contains("\\fBtry\\-it\\fR \\fBfly\\fR \\fIMISSION.json\\fR \\fI[options]\\fR\n"), page);
    }
};

USAR_TEST(tst_ManPage)

} // namespace tst_man_page

#include "tst_man_page.moc"
